/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelIndexer_h
#define TissueTessellationCore_LabelIndexer_h

#include "TissueTessellationCore/Common/Types.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace tissue
{
/** The labels of an image that stand for the exterior. */
struct ExteriorLabels
{
  /** False where no label was named the exterior's. The exterior then is the outside of the image, and label 0 unless
   * that is a cell. */
  bool  hasLabel = false;
  Label label = 0;
  bool  zeroIsCell = false;
  /** Further labels of the exterior. */
  std::vector<Label> others = {};

  bool
  Contains(Label asked) const
  {
    return (hasLabel && asked == label) || (asked == 0 && !zeroIsCell) ||
           std::find(others.begin(), others.end(), asked) != others.end();
  }
};

/** Numbers labels from 1 in the order they are met; the exterior's are ExteriorVertex. */
class LabelIndexer
{
public:
  explicit LabelIndexer(const ExteriorLabels & exterior)
    : m_Exterior(exterior)
    , m_Labels(1)
    , m_Recent(1024)
  {}

  VertexId
  operator()(Label label)
  {
    Recent & recent = m_Recent[static_cast<std::uint64_t>(label) % 1024];
    if (recent.id < 0 || recent.label != label)
    {
      recent.label = label;
      recent.id = this->Find(label);
    }
    return recent.id;
  }

  /** The label of each number. The first entry stands for the exterior and is no label. */
  const std::vector<Label> &
  GetLabels() const
  {
    return m_Labels;
  }

  bool
  HasMet(Label label) const
  {
    return m_Ids.count(label) != 0;
  }

private:
  struct Recent
  {
    Label    label = 0;
    VertexId id = -1;
  };

  VertexId
  Find(Label label)
  {
    const VertexId next = m_Exterior.Contains(label) ? ExteriorVertex : static_cast<VertexId>(m_Labels.size());
    const auto     found = m_Ids.emplace(label, next);
    if (found.second && next != ExteriorVertex)
    {
      m_Labels.push_back(label);
    }
    return found.first->second;
  }

  ExteriorLabels                      m_Exterior;
  std::vector<Label>                  m_Labels;
  std::unordered_map<Label, VertexId> m_Ids;
  /** The label last met of each residue modulo 1024, which spares nearly every look-up in the table. */
  std::vector<Recent> m_Recent;
};
} // namespace tissue

#endif
