/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PointColumns.h"

#include "Shared/Points/DelimitedText.h"
#include "Shared/Points/PointColumnName.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <stdexcept>
#include <utility>

namespace tissue
{
namespace
{
using Names = std::vector<std::string>;

struct Coordinate
{
  std::size_t column;
  AxisName    name;
};

using CoordinatesOfAxes = std::array<std::vector<Coordinate>, 3>;

/** Several names, as a list that is not too long. */
std::string
List(const Names & names)
{
  constexpr std::size_t most = 10;
  std::string           list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
  {
    list += (i > 0 ? ", " : "") + QuoteName(names[i]);
  }
  return list + (names.size() > most ? ", ..." : "");
}

/** Where axes are numbered from 0 on the first is mostly z, and x where they are from 1 on (MATLAB). */
void
RefuseNumbered(const Names & names)
{
  std::map<int, std::string> numbered;
  for (const std::string & name : names)
  {
    if (const auto axis = ParseNumberedAxis(name))
    {
      numbered.emplace(*axis, name);
    }
  }
  if (numbered.size() < 3)
  {
    return;
  }
  const bool  isFromZero = numbered.begin()->first == 0;
  std::string columns;
  // Of four the first is mostly the time.
  for (auto at = numbered.rbegin(); at != std::next(numbered.rbegin(), 3); ++at)
  {
    columns = isFromZero ? columns + " " + QuoteName(at->second) : " " + QuoteName(at->second) + columns;
  }
  throw std::runtime_error("the column " + QuoteName(numbered.begin()->second) +
                           " is numbered by the axes of an array, of which the first is mostly " +
                           (isFromZero ? "z" : "x") + ": --columns says which are x, y and z, here perhaps --columns" +
                           columns + ", and --pointSpacing how large a voxel is if they are in voxels");
}

[[noreturn]] void
RefuseMissing(std::size_t axis, const Names & names)
{
  RefuseNumbered(names);
  const std::string letter(1, "xyz"[axis]);
  throw std::runtime_error("there is no column " + letter + " among " + List(names) + "; accepted are " + letter +
                           ", center_" + letter + ", centroid_" + letter + ", position_" + letter +
                           ", each also with a unit of length, as " + letter + "_um or " + letter +
                           " (microns); others by --columns X Y Z, their names or their numbers from 1 on");
}

[[noreturn]] void
RefuseTwo(std::size_t axis, const std::string & first, const std::string & second)
{
  throw std::runtime_error("the columns " + QuoteName(first) + " and " + QuoteName(second) + " both are " +
                           std::string(1, "xyz"[axis]) + ": --columns X Y Z says which is meant");
}

CoordinatesOfAxes
FindCoordinates(const Names & names)
{
  CoordinatesOfAxes found;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (const auto name = ParseAxisName(names[i]))
    {
      found[name->axis].push_back({ i, *name });
    }
  }
  return found;
}

/** Of the columns of one stem: the less, the rather it is meant. */
std::pair<int, int>
RankOf(const AxisName & name, bool isInVoxels)
{
  const int kind = name.unit == "voxels" ? 2 : name.unit.empty() ? 1 : 0;
  return { isInVoxels ? 2 - kind : kind, name.rank };
}

/** The columns that are rather meant than all others by their common stem; all where no stem has all axes. */
CoordinatesOfAxes
ChooseStems(const CoordinatesOfAxes & found, bool isInVoxels)
{
  CoordinatesOfAxes                  chosen;
  std::optional<std::pair<int, int>> best;
  for (const Coordinate & x : found[0])
  {
    CoordinatesOfAxes ofStem;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::copy_if(found[axis].begin(),
                   found[axis].end(),
                   std::back_inserter(ofStem[axis]),
                   [&x](const Coordinate & c) { return c.name.stem == x.name.stem; });
    }
    const auto rank = RankOf(x.name, isInVoxels);
    if (ofStem[1].empty() || ofStem[2].empty() || (best && *best < rank) || ofStem[0].front().column != x.column)
    {
      continue;
    }
    if (!best || rank < *best)
    {
      chosen = {};
    }
    best = rank;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      chosen[axis].insert(chosen[axis].end(), ofStem[axis].begin(), ofStem[axis].end());
    }
  }
  return best ? chosen : found;
}

/** By name, in any letters, or by number. */
std::size_t
FindColumn(const std::string & wanted, const Names & names)
{
  const auto isWanted = [&wanted](const std::string & name) { return ToLower(name) == ToLower(TrimBlanks(wanted)); };
  const auto at = std::find_if(names.begin(), names.end(), isWanted);
  if (at != names.end())
  {
    if (std::find_if(at + 1, names.end(), isWanted) != names.end())
    {
      throw std::runtime_error("two columns are named " + QuoteName(*at) + ": --columns takes their numbers, too");
    }
    return static_cast<std::size_t>(at - names.begin());
  }
  const auto number = ToColumnNumber(wanted);
  if (!number)
  {
    throw std::runtime_error("there is no column " + QuoteName(wanted) + " (--columns)" +
                             (names.empty() ? ": the columns have no names" : " among " + List(names)));
  }
  if (!names.empty() && *number >= names.size())
  {
    throw std::runtime_error("there is no column " + wanted + " (--columns), there are " +
                             std::to_string(names.size()));
  }
  return *number;
}

/** Sets unit and columns; the units must be the same. */
void
SetCoordinates(const std::array<std::size_t, 3> & coordinates, const Names & names, PointColumns & columns)
{
  std::array<AxisName, 3> axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t column = coordinates[axis];
    axes[axis] = (column < names.size() ? ParseAxisName(names[column]) : std::nullopt).value_or(AxisName());
    if (axes[axis].unit != axes[0].unit)
    {
      throw std::runtime_error("the columns " + QuoteName(names[coordinates[0]]) + " and " + QuoteName(names[column]) +
                               " are of different units");
    }
  }
  columns.coordinates = coordinates;
  columns.unit = axes[0].unit;
  columns.isMostlyInVoxels = axes[0].isMostlyInVoxels;
}

std::array<std::size_t, 3>
ChooseCoordinates(const Names & names, const PointFileOptions & options)
{
  std::array<std::size_t, 3> coordinates{};
  if (!options.columns.empty())
  {
    std::transform(options.columns.begin(), options.columns.end(), coordinates.begin(), [&names](const auto & wanted) {
      return FindColumn(wanted, names);
    });
    return coordinates;
  }
  const CoordinatesOfAxes found = ChooseStems(FindCoordinates(names), options.spacing.has_value());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (found[axis].empty())
    {
      RefuseMissing(axis, names);
    }
    if (found[axis].size() > 1)
    {
      RefuseTwo(axis, names[found[axis][0].column], names[found[axis][1].column]);
    }
    coordinates[axis] = found[axis].front().column;
  }
  return coordinates;
}

/** The column whose name has the least rank; nothing if none has one. */
std::optional<std::size_t>
FindLabels(const Names & names)
{
  std::map<int, std::vector<std::size_t>> columnsOfRank;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (const auto rank = RankLabelName(names[i]))
    {
      columnsOfRank[*rank].push_back(i);
    }
  }
  if (columnsOfRank.empty())
  {
    return std::nullopt;
  }
  const std::vector<std::size_t> & columns = columnsOfRank.begin()->second;
  if (columns.size() > 1)
  {
    throw std::runtime_error("the columns " + std::to_string(columns[0] + 1) + " and " +
                             std::to_string(columns[1] + 1) + " both are the label");
  }
  return columns.front();
}

std::vector<std::size_t>
FindFrames(const Names & names)
{
  std::vector<std::pair<int, std::size_t>> ranks;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (const auto rank = RankFrameName(names[i]))
    {
      ranks.emplace_back(*rank, i);
    }
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::size_t> columns;
  std::transform(ranks.begin(), ranks.end(), std::back_inserter(columns), [](const auto & r) { return r.second; });
  return columns;
}
/** Of its markers and of its point clouds. */
bool
IsOfVaa3D(const Names & names)
{
  const auto has = [&names](const char * name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return (has("radius") && has("shape")) || has("pixmax");
}
} // namespace

PointColumns
FindPointColumns(const Names & names, const PointFileOptions & options)
{
  PointColumns columns;
  SetCoordinates(ChooseCoordinates(names, options), names, columns);
  if (columns.unit == "voxels" && !options.spacing)
  {
    throw std::runtime_error("the column " + QuoteName(names[columns.coordinates[0]]) +
                             " is in voxels: --pointSpacing X Y Z gives their size");
  }
  columns.isMostlyInVoxels = columns.isMostlyInVoxels || IsOfVaa3D(names);
  columns.label = FindLabels(names);
  columns.frames = FindFrames(names);
  const auto unit = std::find_if(names.begin(), names.end(), [](const auto & name) { return ToLower(name) == "unit"; });
  if (unit != names.end())
  {
    columns.unitColumn = static_cast<std::size_t>(unit - names.begin());
  }
  return columns;
}

bool
HasPointColumns(const Names & names, const PointFileOptions & options)
{
  Names wanted;
  std::copy_if(options.columns.begin(), options.columns.end(), std::back_inserter(wanted), [](const auto & column) {
    return !ToColumnNumber(column);
  });
  if (wanted.empty())
  {
    const CoordinatesOfAxes found = FindCoordinates(names);
    return std::none_of(found.begin(), found.end(), [](const auto & ofAxis) { return ofAxis.empty(); });
  }
  return std::all_of(wanted.begin(), wanted.end(), [&names](const std::string & column) {
    return std::any_of(
      names.begin(), names.end(), [&](const auto & name) { return ToLower(name) == ToLower(TrimBlanks(column)); });
  });
}

std::optional<std::size_t>
ToColumnNumber(const std::string & text)
{
  std::size_t number = 0;
  const auto  result = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool  isNumber = result.ec == std::errc() && result.ptr == text.data() + text.size() && number > 0;
  return isNumber ? std::make_optional(number - 1) : std::nullopt;
}
} // namespace tissue
