/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageOptions.h"

#include "Shared/CommandLine/OptionChecks.h"

#include <nlohmann/json.hpp>

namespace tissue
{
namespace
{
const std::string group = "Image";
}

void
AddSpacingAndChannel(CLI::App & app, ImageOptions & options)
{
  app
    .add_option(
      "--spacing",
      options.spacing,
      "Voxel size x y z, or x,y,z, in place of the file's; for further images of the run where theirs tell none")
    ->type_name("FLOAT FLOAT FLOAT")
    ->delimiter(',')
    ->check(InRange(1e-12, 1e12))
    ->group(group);
  app.add_option("--channel", options.channel, "Which channel is read of a file that has several, from 1 on")
    ->type_name("NUMBER")
    ->check(InRange(1, 1e6))
    ->group(group);
}

void
AddImageOptions(CLI::App & app, ImageOptions & options)
{
  AddSpacingAndChannel(app, options);
  app.add_option("--frame", options.frame, "Which frame (time point) is read of a file that has several, from 1 on")
    ->type_name("NUMBER")
    ->check(InRange(1, 1e6))
    ->group(group);
}

void
AddToJson(const ImageOptions & options, nlohmann::ordered_json & json)
{
  const auto ofImage = [](bool isGiven, const auto & value) {
    return isGiven ? nlohmann::ordered_json(value) : nlohmann::ordered_json("of the image");
  };
  json["spacing"] = ofImage(options.spacing.has_value(), options.spacing.value_or(std::array<double, 3>()));
  json["channel"] = ofImage(options.channel > 0, options.channel);
  json["frame"] = ofImage(options.frame > 0, options.frame);
}
} // namespace tissue
