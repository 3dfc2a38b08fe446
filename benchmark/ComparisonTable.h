/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ComparisonTable_h
#define ComparisonTable_h

#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace tissue
{
/** A program that takes part in the comparison, which is one column of it. */
struct Contestant
{
  struct Phase
  {
    std::string name;
    double      wallSeconds = 0.0;
  };

  std::string        name;
  ElapsedTime        time;
  std::vector<Phase> phases;
  /** The number of triangles as the program gives them, some programs with every wall twice. The evaluation counts each
   * wall once. */
  std::size_t          numberOfOutputTriangles = 0;
  TissueMeshEvaluation evaluation;
};

/** Writes a Markdown table with a row for each figure, then the phases of those contestants that have some. */
void
Print(const std::vector<Contestant> & contestants, std::ostream & os);

nlohmann::ordered_json
ToJson(const std::vector<Contestant> & contestants);
} // namespace tissue

#endif
