/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ExteriorOptions.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace tissue
{
namespace
{
const std::string Suspects = "suspects";

/** A label, or the word for suspects. */
CLI::Validator
LabelOrSuspects()
{
  const auto check = [](const std::string & argument) {
    Label      label = 0;
    const bool isOne = argument == Suspects || CLI::detail::lexical_cast(argument, label);
    return isOne ? std::string() : argument + " is neither a label nor '" + Suspects + "'";
  };
  return CLI::Validator(check, "LABEL or " + Suspects);
}
} // namespace

void
AddExteriorOptions(CLI::App & app, const std::string & group, itk::ExteriorLabelSettings & settings)
{
  // Each option takes one argument, of labels that commas separate, so that the file after it is none of them; it may
  // be there several times.
  const auto takeEach = [&group](CLI::Option * option) {
    option->allow_extra_args(false)->take_all()->delimiter(',');
    if (!group.empty())
    {
      option->group(group);
    }
  };
  takeEach(app.add_option_function<std::vector<Label>>(
    "--exteriorLabel",
    [&settings](const std::vector<Label> & labels) {
      settings.isAutomatic = false;
      for (const Label label : labels)
      {
        itk::ExteriorLabelSettings::Add(label, settings.labels);
      }
    },
    "Labels of the exterior, separated by commas or given again; found in the image by default"));
  CLI::Option * const zeroIsCell = app.add_flag("--zeroIsCell", settings.zeroIsCell, "Take label 0 for a cell");
  if (!group.empty())
  {
    zeroIsCell->group(group);
  }
  takeEach(app
             .add_option_function<std::vector<std::string>>(
               "--dropCells",
               [&settings](const std::vector<std::string> & cells) {
                 for (const std::string & cell : cells)
                 {
                   Label label = 0;
                   if (cell == Suspects)
                   {
                     settings.dropsSuspects = true;
                   }
                   else if (CLI::detail::lexical_cast(cell, label))
                   {
                     itk::ExteriorLabelSettings::Add(label, settings.dropped);
                   }
                 }
               },
               "Labels that are no cells, to be taken for exterior, separated by commas; suspects: all that the report "
               "suspects")
             ->check(LabelOrSuspects()));
}

CLI::Option *
AddSpeckOption(CLI::App & app, bool & acceptsSpecks)
{
  return app.add_flag("--acceptSpecks",
                      acceptsSpecks,
                      "Take the image for labels though most of them are specks, as the grey values of a stain are");
}

void
AddToJson(const itk::ExteriorLabelSettings & settings, nlohmann::ordered_json & json)
{
  json["exteriorLabel"] = settings.isAutomatic          ? nlohmann::ordered_json("automatic")
                          : settings.labels.size() == 1 ? nlohmann::ordered_json(settings.labels.front())
                                                        : nlohmann::ordered_json(settings.labels);
  json["zeroIsCell"] = settings.zeroIsCell;
  json["dropCells"] = settings.dropped;
  json["dropSuspects"] = settings.dropsSuspects;
}
} // namespace tissue
