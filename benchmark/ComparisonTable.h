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
/** One column of the comparison. */
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
  /** As the program gives them; those of the evaluation count a wall once. */
  std::size_t          numberOfOutputTriangles = 0;
  TissueMeshEvaluation evaluation;
};

/** A Markdown table, a row for each figure, then the phases of those that have some. */
void
Print(const std::vector<Contestant> & contestants, std::ostream & os);

nlohmann::ordered_json
ToJson(const std::vector<Contestant> & contestants);
} // namespace tissue

#endif
