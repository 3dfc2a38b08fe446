/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ProjectionSources_h
#define ProjectionSources_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Images/ScalarImageInput.h"
#include "Shared/Points/CellTable.h"
#include "Shared/Projection/ProjectionOptions.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <map>
#include <string>
#include <vector>

namespace tissue
{
/** What is to be projected, as it is read. */
struct ProjectionSources
{
  struct Table
  {
    std::string file;
    CellTable   values;
  };
  struct Signal
  {
    SignalSource    source;
    ScalarImageFile image;
  };
  std::vector<Table>  tables;
  std::vector<Signal> signals;

  /** Of all columns of cells that there will be. */
  std::vector<std::string>
  ColumnNames() const;

  /** What is to be said of the files, which it names. */
  std::vector<std::string>
  Warnings() const;
};

/** The columns that an image of intensities has of the cells: `<name>Mean`, `<name>Integral`, `<name>NearWalls`. */
std::vector<std::string>
SignalColumnNames(const std::string & signal);

/** Reads the tables and the images.
 * \throws FileError: of ReadCellTable() and ReadScalarImage(); a column with the name of a statistic or of another
 * column. */
ProjectionSources
ReadProjectionSources(const ProjectionOptions & options, ProgressBar & progress);

/** The row of a table that each vertex has; -1 where there is none. */
struct MatchedRows
{
  std::vector<std::ptrdiff_t> rowOfVertex;
  /** Labels of rows that no cell has, as they are written, and cells without a row. */
  std::vector<std::string> unknownLabels;
  std::vector<Label>       cellsWithoutRow;
};

/** Finds the cells of the rows: by the names of the cells where there are some, else by the labels.
 * \throws std::runtime_error where no row has a label of a cell. */
MatchedRows
MatchRows(const CellTable & table, const std::vector<Cell> & cells, const std::map<Label, std::string> & names);

/** Throws std::runtime_error where no voxel of a cell is in the image. */
void
RequireOverlap(const ScalarImage * image, const LabelVolume & labels, std::size_t numberOfVertices);
} // namespace tissue

#endif
