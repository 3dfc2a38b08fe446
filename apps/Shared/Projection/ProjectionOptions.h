/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ProjectionOptions_h
#define ProjectionOptions_h

#include "Shared/Images/ImageOptions.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tissue
{
/** What is projected on cells and walls. */
struct ProjectionOptions
{
  /** Tables of cells, and the column of their labels, by name or number from 1 on; empty: found by its name. */
  std::vector<std::string> tables;
  std::string              labelColumn;
  /** Images of intensities: FILE, or NAME=FILE. */
  std::vector<std::string> signals;
  /** Which channel and frame of each is read, from 1 on: one for all, or one for each; none: it has one. */
  std::vector<unsigned int> channels;
  std::vector<unsigned int> frames;
  /** How near to its walls a cell's voxels are that count as such; 0: the diagonal of a voxel. */
  double wallDistance = 0.0;
  /** Of the image that the cells are from: the voxel size where a signal's file tells none. */
  ImageOptions image;

  /** The files that are read. */
  std::vector<std::string>
  Files() const;
};

/** An image of intensities, as asked for. */
struct SignalSource
{
  /** What the columns begin with. */
  std::string  name;
  std::string  file;
  ImageOptions image;
};

/** \brief The images in the order of the options.
 *
 * The name is that before the first '=', unless there is such a file, or else the file's without folder and extensions,
 * or the data set's of HDF5.
 * \throws std::runtime_error: an empty name or file, channels or frames of another number. */
std::vector<SignalSource>
ListSignals(const ProjectionOptions & options);

/** --cellData, --cellDataLabel, --signal, --signalChannel, --signalFrame and --wallDistance. */
void
AddProjectionOptions(CLI::App & app, ProjectionOptions & options);

/** The options for the report; nothing where nothing is projected. */
void
AddToJson(const ProjectionOptions & options, nlohmann::ordered_json & json);
} // namespace tissue

#endif
