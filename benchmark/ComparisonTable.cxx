/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "ComparisonTable.h"

#include <nlohmann/json.hpp>

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

std::vector<std::string>
MakeRow(const Contestant & contestant)
{
  const WallMeshEvaluation & e = contestant.evaluation;
  return { contestant.name,
           Fixed(contestant.time.wallSeconds, 2),
           Fixed(contestant.time.processorSeconds, 2),
           Fixed(Ratio(contestant.numberOfOutputTriangles, e.numberOfCells), 0),
           std::to_string(e.numberOfCorners),
           std::to_string(e.numberOfCrowdedCorners) + " (" +
             Fixed(100.0 * Ratio(e.numberOfCrowdedCorners, e.numberOfCorners), 1) + " %)",
           std::to_string(e.numberOfMissingCells),
           Fixed(100.0 * Ratio(e.numberOfClosedCells, e.numberOfCells), 1) + " %",
           Fixed(100.0 * Ratio(e.numberOfSpheres, e.numberOfCells), 1) + " %",
           Fixed(100.0 * e.meanVolumeError, 2) + " %",
           Fixed(e.overlap.adjacency2, 3),
           Fixed(e.overlap.adjacency4, 3) };
}
} // namespace

void
Print(const std::vector<Contestant> & contestants, std::ostream & os)
{
  const std::vector<std::string> header = { "program", "wall s",       "CPU s",         "triangles a cell",
                                            "corners", "of > 4 cells", "missing cells", "closed cells",
                                            "spheres", "volume error", "adjacency2",    "adjacency4" };
  PrintRow(header, os);
  PrintRow(std::vector<std::string>(header.size(), "---"), os);
  for (const Contestant & contestant : contestants)
  {
    PrintRow(MakeRow(contestant), os);
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
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Contestant & contestant : contestants)
  {
    const WallMeshEvaluation & e = contestant.evaluation;
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
                     { "meanVolumeError", e.meanVolumeError },
                     { "adjacency2", e.overlap.adjacency2 },
                     { "adjacency4", e.overlap.adjacency4 } });
  }
  return rows;
}
} // namespace tissue
