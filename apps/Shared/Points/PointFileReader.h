/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointFileReader_h
#define PointFileReader_h

#include "Shared/Points/PointFileOptions.h"
#include "TissueTessellationCore/Common/Types.h"

#include <string>
#include <vector>

namespace tissue
{
/** Points of a file in physical coordinates (LPS). */
struct PointFile
{
  std::vector<Point> points;
  /** Of each point, from 0 on; empty where the file has none. */
  std::vector<Label> labels;
  /** Of each point, where the file has text for labels; else empty. */
  std::vector<std::string> names;
  /** Of each point where it is in the file, for messages: "line 7". */
  std::vector<std::string> places;
  /** Of length, as the names of columns say it: "um", "mm"; else empty. */
  std::string unit;
  /** Of what was left out or guessed. */
  std::vector<std::string> warnings;
};

/** Whether the name ends in one of the extensions of a point file: of tables .csv, .tsv, .txt and those like it, .fcsv,
 * .json, .ply, .vtp. */
bool
IsPointFile(const std::string & path);

/** \brief Reads the points of a file.
 *
 * - `.csv`, `.tsv`, `.tab`, `.txt`, `.xls` (text of ImageJ), `.dat`, `.xyz`, `.marker`, `.apo` (both of Vaa3D): tables,
 * by ReadPointTable().
 * - `.fcsv`: markups of 3D Slicer; RAS coordinates, the default of its older versions, become LPS.
 * - `.mrk.json`: likewise of its newer ones, by ReadMarkupsJson().
 * - `.ply`: the vertices, by ReadPlyPoints().
 * - `.vtp`: the points of VTK's polygonal data; those whose field array `SPACE` says RAS become LPS.
 *
 * Numbers are read alike in any locale. Coordinates are multiplied by the options' spacing; without it those of tables
 * are in the unit of the names, PointFile::unit.
 * \throws std::runtime_error: no such file, missing columns, text in place of a number, a number that is not finite;
 * with line, column and value; options of tables for another file. */
PointFile
ReadPointFile(const std::string & path, const PointFileOptions & options = PointFileOptions());
} // namespace tissue

#endif
