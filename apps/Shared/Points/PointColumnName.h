/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointColumnName_h
#define PointColumnName_h

#include <cstddef>
#include <optional>
#include <string>

namespace tissue
{
/** What the name of a column of coordinates says. */
struct AxisName
{
  /** 0 for x, 1 for y, 2 for z. */
  std::size_t axis = 0;
  /** The name in small letters with # for the axis: equal for the columns that belong together. */
  std::string stem;
  /** "nm", "um", "mm", "cm", "m"; "voxels"; "units" where it says that it has some; else empty. */
  std::string unit;
  /** Whether there is no unit, but the program that writes such names means voxels (CellProfiler). */
  bool isMostlyInVoxels = false;
  /** Of names of one table the least is meant: 0 of a plain name or centre, 1 of one weighted by brightness, and of the
   * other one of CellProfiler's. */
  int rank = 0;
};

/** \brief The name of a column of coordinates, in small letters or capitals; nothing if the name is another one.
 *
 * "x", "X (microns)", "x, µm", "centroid_x", "Cell Position X", "x_pos", "CX (unit)", "BaryCenterX", "POSITION_X",
 * "Nuclei_Location_Center_X" and alike; "Center of the object_0", as ilastik counts x, y and z. Suffixes that are no
 * unit are something else: an error, an index. */
std::optional<AxisName>
ParseAxisName(const std::string & name);

/** The number of an axis that the name of a column ends in, as those of scikit-image and napari: "centroid-0",
 * "axis-2". */
std::optional<int>
ParseNumberedAxis(const std::string & name);

/** The unit, as in AxisName, of a text that says no more, as in the line below the names: "(micron)", "um", "[px]";
 * else nothing. */
std::optional<std::string>
ParseUnit(const std::string & text);

/** Whether it is the name of a column of labels: 0 for "Label", 1 for others ("ObjectNumber"); nothing if not. */
std::optional<int>
RankLabelName(const std::string & name);

/** The same of a table of cells, where the ids of rows are those of cells, too: 2 for "cell_id", "CellID", "Cell" and
 * alike, 3 for "id", 4 for "Name". */
std::optional<int>
RankCellName(const std::string & name);

/** Whether it is the name of a column of time points or of images: 0 for "FRAME", "timepoint" and alike, 1 for times
 * ("t", "Time [s]"), 2 for numbers of images; nothing if not. */
std::optional<int>
RankFrameName(const std::string & name);

/** The name in quotes, cut where it is long, for messages. */
std::string
QuoteName(const std::string & name);

/** In small letters, whatever the locale. */
std::string
ToLower(std::string text);
} // namespace tissue

#endif
