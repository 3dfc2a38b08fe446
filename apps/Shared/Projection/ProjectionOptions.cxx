/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Projection/ProjectionOptions.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "itkStackHDF5ImageIO.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

/** The name of a file of an image without its folder and extensions. */
std::string
NameOf(const std::string & file)
{
  const auto [path, dataSet] = itk::StackHDF5ImageIO::SplitPath(file);
  if (!dataSet.empty() && !fs::path(dataSet).filename().empty())
  {
    return fs::path(dataSet).filename().string();
  }
  fs::path name = fs::path(path).stem();
  for (const std::string extension : { ".nii", ".ome", ".inr" })
  {
    name = name.extension() == extension ? name.stem() : name;
  }
  return name.string();
}

/** The number for a signal of those that are given. */
unsigned int
NumberOf(const std::vector<unsigned int> & numbers, std::size_t signal)
{
  return numbers.empty() ? 0 : numbers.size() == 1 ? numbers.front() : numbers[signal];
}

void
RequireOneOrEach(const std::vector<unsigned int> & numbers, std::size_t numberOfSignals, const std::string & option)
{
  if (numbers.size() > 1 && numbers.size() != numberOfSignals)
  {
    throw std::runtime_error(option + " has " + std::to_string(numbers.size()) + " values, must have one, or one for " +
                             "each --signal, of which there are " + std::to_string(numberOfSignals));
  }
}
} // namespace

std::vector<std::string>
ProjectionOptions::Files() const
{
  std::vector<std::string> files = tables;
  for (const SignalSource & signal : ListSignals(*this))
  {
    files.push_back(signal.file);
  }
  return files;
}

std::vector<SignalSource>
ListSignals(const ProjectionOptions & options)
{
  RequireOneOrEach(options.channels, options.signals.size(), "--signalChannel");
  RequireOneOrEach(options.frames, options.signals.size(), "--signalFrame");
  std::vector<SignalSource> sources;
  for (const std::string & signal : options.signals)
  {
    const std::size_t equals = signal.find('=');
    const bool        isNamed = equals != std::string::npos && !fs::exists(signal);
    SignalSource      source;
    source.file = isNamed ? signal.substr(equals + 1) : signal;
    source.name = isNamed ? signal.substr(0, equals) : NameOf(signal);
    if (source.file.empty() || source.name.empty())
    {
      throw std::runtime_error("--signal " + signal + " has no " + (source.file.empty() ? "file" : "name") +
                               ", must be FILE or NAME=FILE");
    }
    source.image = options.image.ForFurther();
    source.image.channel = NumberOf(options.channels, sources.size());
    source.image.frame = NumberOf(options.frames, sources.size());
    source.image.requiresChoice = true;
    source.image.channelOption = "--signalChannel";
    source.image.frameOption = "--signalFrame";
    sources.push_back(source);
  }
  return sources;
}

void
AddProjectionOptions(CLI::App & app, ProjectionOptions & options)
{
  const std::string group = "Projected on the cells";
  // An option that may be repeated must not take the files that follow it.
  const auto add = [&](const char * name, std::vector<std::string> & files, const char * description) {
    app.add_option(name, files, description)->type_name("FILE")->allow_extra_args(false)->group(group);
  };
  const auto addNumbers = [&](const char * name, std::vector<unsigned int> & numbers, const char * description) {
    app.add_option(name, numbers, description)
      ->type_name("NUMBER")
      ->check(InRange(1, 1e6))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs("--signal")
      ->group(group);
  };
  add("--cellData",
      options.tables,
      "Table of values of the cells, by their labels (.csv, .tsv, .txt), which go to all outputs; may be repeated");
  app
    .add_option("--cellDataLabel",
                options.labelColumn,
                "Its column of labels, by name or number from 1 on, where the names do not tell")
    ->needs("--cellData")
    ->type_name("COLUMN")
    ->group(group);
  add("--signal",
      options.signals,
      "Image of intensities, FILE or NAME=FILE, on any grid: its mean, integral and mean near the walls in each cell, "
      "and mean on each wall, go to all outputs; may be repeated");
  addNumbers("--signalChannel", options.channels, "Its channel, from 1 on, where it has several; or one of each, 1,2");
  addNumbers("--signalFrame", options.frames, "Its frame likewise");
  app
    .add_option("--wallDistance",
                options.wallDistance,
                "Near the walls are voxels within this distance, in the image's units; 0: the diagonal of a voxel")
    ->check(InRange(0.0, 1e12))
    ->capture_default_str()
    ->group(group);
}

void
AddToJson(const ProjectionOptions & options, nlohmann::ordered_json & json)
{
  if (!options.tables.empty())
  {
    json["cellData"] = options.tables;
    json["cellDataLabel"] = options.labelColumn;
  }
  if (!options.signals.empty())
  {
    json["signal"] = options.signals;
    json["signalChannel"] = options.channels;
    json["signalFrame"] = options.frames;
    json["wallDistance"] = options.wallDistance;
  }
}
} // namespace tissue
