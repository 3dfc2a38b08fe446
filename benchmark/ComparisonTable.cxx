/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "ComparisonTable.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <iomanip>
#include <sstream>

namespace tissue
{
namespace
{
double
Ratio(std::size_t part, std::size_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::string
Fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

void
PrintRow(const std::vector<std::string> & columns, std::ostream & os)
{
  for (const std::string & column : columns)
  {
    os << "| " << column << ' ';
  }
  os << "|\n";
}

/** Writes a number, or "none" for -1, which stands for a mean of nothing. */
std::string
FixedOrNone(double value, int digits, double factor = 1.0)
{
  return value < 0.0 ? "none" : Fixed(factor * value, digits);
}

struct Figure
{
  std::string                                      name;
  std::function<std::string(const Contestant & c)> get;
};

std::vector<Figure>
MakeFiguresOfCells()
{
  using C = const Contestant &;
  return {
    { "wall s", [](C c) { return Fixed(c.time.wallSeconds, 2); } },
    { "CPU s", [](C c) { return Fixed(c.time.processorSeconds, 2); } },
    { "triangles a cell", [](C c) { return Fixed(c.evaluation.TrianglesPerCell(), 0); } },
    { "triangles a cell, as the program gives them",
      [](C c) { return Fixed(Ratio(c.numberOfOutputTriangles, c.evaluation.mesh.numberOfCells), 0); } },
    { "adjacency2", [](C c) { return Fixed(c.evaluation.mesh.overlap.adjacency2, 3); } },
    { "adjacency4", [](C c) { return Fixed(c.evaluation.mesh.overlap.adjacency4, 3); } },
    { "corners", [](C c) { return std::to_string(c.evaluation.mesh.numberOfCorners); } },
    { "corners of > 4 cells", [](C c) { return std::to_string(c.evaluation.mesh.numberOfCrowdedCorners); } },
    { "missing cells", [](C c) { return std::to_string(c.evaluation.mesh.numberOfMissingCells); } },
    { "closed cells, %",
      [](C c) {
        return Fixed(100.0 * Ratio(c.evaluation.mesh.numberOfClosedCells, c.evaluation.mesh.numberOfCells), 1);
      } },
    { "spheres, %",
      [](C c) { return Fixed(100.0 * Ratio(c.evaluation.mesh.numberOfSpheres, c.evaluation.mesh.numberOfCells), 1); } },
  };
}

std::vector<Figure>
MakeFiguresOfShape()
{
  using C = const Contestant &;
  return {
    { "volume error, mean, %", [](C c) { return FixedOrNone(c.evaluation.mesh.meanVolumeError, 2, 100.0); } },
    { "volume error, 95 %, %", [](C c) { return FixedOrNone(c.evaluation.mesh.volumeErrorPercentile95, 2, 100.0); } },
    { "cells within 1 %, %", [](C c) { return Fixed(100.0 * c.evaluation.mesh.shareWithinOnePercent, 1); } },
    { "wall distance, voxels",
      [](C c) { return FixedOrNone(c.evaluation.distance.InVoxels(c.evaluation.distance.mean), 3); } },
    { "area in false walls, %", [](C c) { return Fixed(100.0 * c.evaluation.distance.shareOfFalseWalls, 2); } },
    { "quality, mean", [](C c) { return Fixed(c.evaluation.mesh.quality.mean, 3); } },
    { "quality, worst twentieth", [](C c) { return Fixed(c.evaluation.mesh.quality.fifthPercentile, 3); } },
    { "quality, least", [](C c) { return Fixed(c.evaluation.mesh.quality.least, 3); } },
    { "degenerate triangles", [](C c) { return std::to_string(c.evaluation.mesh.numberOfDegenerateTriangles); } },
    { "crossing pairs", [](C c) { return std::to_string(c.evaluation.mesh.numberOfCrossings); } },
    { "Dice", [](C c) { return Fixed(c.evaluation.meanDice, 3); } },
    { "convexity", [](C c) { return FixedOrNone(c.evaluation.mesh.meanConvexity, 3); } },
  };
}
} // namespace

void
Print(const std::vector<Contestant> & contestants, std::ostream & os)
{
  // The names of the contestants come first, then one row for each figure, then the phases in lines of their own.
  std::vector<std::string> row{ "" };
  for (const Contestant & contestant : contestants)
  {
    row.push_back(contestant.name);
  }
  PrintRow(row, os);
  PrintRow(std::vector<std::string>(row.size(), "---"), os);
  for (const auto & figures : { MakeFiguresOfCells(), MakeFiguresOfShape() })
  {
    for (const Figure & figure : figures)
    {
      row.assign(1, figure.name);
      for (const Contestant & contestant : contestants)
      {
        row.push_back(figure.get(contestant));
      }
      PrintRow(row, os);
    }
  }
  for (const Contestant & contestant : contestants)
  {
    if (!contestant.phases.empty())
    {
      os << '\n' << contestant.name << " by phase, wall s:";
      for (const Contestant::Phase & phase : contestant.phases)
      {
        os << ' ' << phase.name << ' ' << Fixed(phase.wallSeconds, 3);
      }
      os << '\n';
    }
  }
}

nlohmann::ordered_json
ToJson(const std::vector<Contestant> & contestants)
{
  // Each contestant is an object with the same keys. A mean of nothing, -1, becomes null.
  const auto numberOrNull = [](double value) {
    return value < 0.0 ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
  };
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Contestant & contestant : contestants)
  {
    const WallMeshEvaluation & e = contestant.evaluation.mesh;
    const WallDistance &       distance = contestant.evaluation.distance;
    nlohmann::ordered_json     phases = nlohmann::ordered_json::object();
    for (const Contestant::Phase & phase : contestant.phases)
    {
      phases[phase.name] = phase.wallSeconds;
    }
    rows.push_back({ { "program", contestant.name },
                     { "wallSeconds", contestant.time.wallSeconds },
                     { "processorSeconds", contestant.time.processorSeconds },
                     { "phases", phases },
                     { "outputTriangles", contestant.numberOfOutputTriangles },
                     { "triangles", e.numberOfTriangles },
                     { "cells", e.numberOfCells },
                     { "corners", e.numberOfCorners },
                     { "cornersWithMoreThanFourCells", e.numberOfCrowdedCorners },
                     { "missingCells", e.numberOfMissingCells },
                     { "closedCells", e.numberOfClosedCells },
                     { "spheres", e.numberOfSpheres },
                     { "meanVolumeError", numberOrNull(e.meanVolumeError) },
                     { "volumeErrorPercentile95", numberOrNull(e.volumeErrorPercentile95) },
                     { "shareWithinOnePercent", e.shareWithinOnePercent },
                     { "wallDistance", numberOrNull(distance.mean) },
                     { "wallDistanceInVoxels", numberOrNull(distance.InVoxels(distance.mean)) },
                     { "shareOfFalseWalls", distance.shareOfFalseWalls },
                     { "meanQuality", e.quality.mean },
                     { "qualityFifthPercentile", e.quality.fifthPercentile },
                     { "leastQuality", e.quality.least },
                     { "degenerateTriangles", e.numberOfDegenerateTriangles },
                     { "crossingPairs", e.numberOfCrossings },
                     { "meanDice", contestant.evaluation.meanDice },
                     { "meanConvexity", numberOrNull(e.meanConvexity) },
                     { "adjacency2", e.overlap.adjacency2 },
                     { "adjacency4", e.overlap.adjacency4 } });
  }
  return rows;
}
} // namespace tissue
