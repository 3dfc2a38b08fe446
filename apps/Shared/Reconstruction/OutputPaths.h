/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OutputPaths_h
#define OutputPaths_h

#include "TissueTessellationCore/Common/Types.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace tissue
{
/** The files that are made of a reconstruction; empty: not asked for. */
struct OutputPaths
{
  std::string walls;
  std::string complex;
  std::string cells;
  std::string cellSurfaces;
  std::string statistics;
  std::string wallStatistics;
  std::string graph;
  std::string junctions;
  std::string report;
  std::string picture;
  /** The column of the cells' statistics that the picture is coloured by; empty: none. */
  std::string colorBy;
  std::string page;
  /** Models for programs that mesh the cells: `.geo` of Gmsh, `.smesh` of TetGen. */
  std::vector<std::string> simulations;
  /** Meshes for other programs, see MeshExportEndings(), and the cells that are in them; none: all. */
  std::vector<std::string> exports;
  std::vector<Label>       exportedCells;
  /** Of --returnparameterfile. */
  std::string returnParameters;

  struct Output
  {
    std::string path;
    /** In words. */
    std::string content;
  };

  /** All that are asked for. */
  std::vector<Output>
  List() const;
};

/** The mesh of the walls, required, and all further outputs. */
void
AddOutputOptions(CLI::App & app, OutputPaths & paths);

/** Whether cells go to a segmentation of 3D Slicer, rather than to a grid. */
bool
IsSegmentation(const std::string & path);

/** \brief Throws std::runtime_error for everything that would make the outputs impossible, before the work.
 *
 * \param inputs the files that are read, some of which may be empty. */
void
RequireOutputs(const OutputPaths & paths, const std::vector<std::string> & inputs);

/** Throws std::runtime_error that lists the columns where that of --colorBy is none of them. \param projected further
 * columns. */
void
RequireColumn(const OutputPaths & paths, const std::vector<std::string> & projected);
} // namespace tissue

#endif
