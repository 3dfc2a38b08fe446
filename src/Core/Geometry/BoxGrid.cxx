/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/BoxGrid.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>
#include <limits>

namespace tissue
{
namespace
{
double
MeanExtent(const Box & box)
{
  const Point extent = box.upper - box.lower;
  return (extent[0] + extent[1] + extent[2]) / 3.0;
}
} // namespace

BoxGrid::BoxGrid(const std::vector<Box> & boxes, std::vector<std::int32_t> groups)
  : m_Boxes(boxes)
  , m_Groups(std::move(groups))
{
  this->FindLongBoxes();
  Box    all = boxes[m_InGrid.front()];
  double sum = 0.0;
  for (const std::int32_t i : m_InGrid)
  {
    Extend(all, boxes[i].lower);
    Extend(all, boxes[i].upper);
    sum += MeanExtent(boxes[i]);
  }
  double cells = 1.0;
  m_Lower = all.lower;
  m_CellSize = std::max(1.5 * sum / static_cast<double>(m_InGrid.size()), std::numeric_limits<double>::min());
  for (int i = 0; i < 3; ++i)
  {
    cells *= (all.upper[i] - all.lower[i]) / m_CellSize + 1.0;
  }
  // No more cells than boxes have use for, however the tissue is spread.
  m_CellSize *= std::max(1.0, std::cbrt(cells / (8.0 * static_cast<double>(m_InGrid.size()) + 1000.0)));
  for (int i = 0; i < 3; ++i)
  {
    m_Size[i] = static_cast<std::int64_t>((all.upper[i] - all.lower[i]) / m_CellSize) + 1;
  }
  m_Members.Assign(static_cast<std::size_t>(m_Size[0] * m_Size[1] * m_Size[2]), [this](const auto & add) {
    for (const std::int32_t i : m_InGrid)
    {
      this->VisitCells(m_Boxes[i], [&add, i](std::int64_t cell) { add(static_cast<std::size_t>(cell), i); });
    }
  });
}

void
BoxGrid::FindLongBoxes()
{
  constexpr double timesMean = 64.0; // so that at most a 64th of all are long
  double           sum = 0.0;
  for (const Box & box : m_Boxes)
  {
    sum += MeanExtent(box);
  }
  const double longest = timesMean * sum / static_cast<double>(m_Boxes.size());
  for (std::size_t i = 0; i < m_Boxes.size(); ++i)
  {
    (MeanExtent(m_Boxes[i]) > longest ? m_Long : m_InGrid).push_back(static_cast<std::int32_t>(i));
  }
}
} // namespace tissue
