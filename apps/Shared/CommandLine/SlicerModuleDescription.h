/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SlicerModuleDescription_h
#define SlicerModuleDescription_h

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace tissue
{
/** Of the options that 3D Slicer asks of its modules. */
inline const std::string SlicerGroup = "3D Slicer";

/** What 3D Slicer must know of an option that its type does not tell. */
enum class SlicerUse
{
  /** It makes no sense there. */
  LeftOut,
  /** A volume of labels. */
  LabelImage,
  /** A volume of any kind. */
  Image,
  /** A list of points, which is read. */
  InputPoints,
  /** A list of points, which is written. */
  OutputPoints
};

/** A number that a program gives back, which 3D Slicer shows. */
struct SlicerResult
{
  /** A name as those of variables. */
  std::string name;
  /** "integer" or "double". */
  std::string type;
  /** In words. */
  std::string description;
};

/** What 3D Slicer must know of a program beside its options. */
struct SlicerModule
{
  /** In the list of modules. */
  std::string title;
  /** By names of options, "--membrane" or "labels", or of groups of them; an option's own comes first. */
  std::map<std::string, SlicerUse> uses;
  std::vector<SlicerResult>        results;
};

/** \brief A program's options in the XML of 3D Slicer's command line modules (its Execution Model).
 *
 * Positional arguments have an index in their order, other options a long flag. Each group is one of Slicer's, all but
 * the first of them advanced. The type is
 * - that of SlicerModule::uses;
 * - `boolean` for flags without a value;
 * - `geometry` (.vtp, .vtu), `table` (.csv) or `file` for files to write, which EndsIn() tells, and `file` for others,
 * which have the type name FILE;
 * - `string-enumeration` for the choices of CLI::IsMember;
 * - `integer-vector`, `double-vector` and `string-vector`, separated by commas, for several values;
 * - `integer` and `double` with a default, which Slicer always passes, in the constraints of InRange() where a slider
 * can show them: from -1e4 to 1e4;
 * - `string`, which Slicer passes if there is one, for all else, numbers without a default or outside of their range
 * among them.
 *
 * Options without a group, of the group SlicerGroup and those that only print are left out; `--progress` is
 * hidden and always `slicer`. Results have neither index nor flag. */
std::string
DescribeSlicerModule(const CLI::App & app, const SlicerModule & module);
} // namespace tissue

#endif
