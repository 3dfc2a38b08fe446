/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/BoxGrid.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>

namespace tissue
{
namespace
{
/** A float that is not above a number, or not below it where `sign` is 1: rounding to the nearest one changes it by
 * less than the added share. */
float
RoundTo(double x, double sign)
{
  constexpr double share = 1.2e-7;
  return static_cast<float>(x + sign * share * std::abs(x));
}
} // namespace

BoxGrid::BoxGrid(const std::vector<Box> & boxes, std::vector<std::int32_t> groups)
  : BoxGrid(
      boxes.size(), [&boxes](std::size_t i) { return boxes[i]; }, std::move(groups))
{}

BoxGrid::BoxGrid(std::size_t numberOfBoxes, const std::function<Box(std::size_t)> & boxOf,
                 std::vector<std::int32_t> groups)
  : m_Groups(std::move(groups))
{
  const Point origin = boxOf(0).lower;
  m_Boxes.reserve(numberOfBoxes);
  for (std::size_t i = 0; i < numberOfBoxes; ++i)
  {
    const Box   box = boxOf(i);
    const Point lower = box.lower - origin;
    const Point upper = box.upper - origin;
    m_Boxes.push_back({ { { RoundTo(lower[0], -1.0), RoundTo(lower[1], -1.0), RoundTo(lower[2], -1.0) } },
                        { { RoundTo(upper[0], 1.0), RoundTo(upper[1], 1.0), RoundTo(upper[2], 1.0) } } });
  }
  this->FindLongBoxes();
  this->ChooseCells();
  m_Members.Assign(static_cast<std::size_t>(m_Size[0] * m_Size[1] * m_Size[2]), [this](const auto & add) {
    for (const std::int32_t i : m_InGrid)
    {
      this->VisitCells(m_Boxes[i], [&add, i](std::int64_t cell) { add(static_cast<std::size_t>(cell), i); });
    }
  });
}

double
BoxGrid::MeanExtent(const FloatBox & box)
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    sum += static_cast<double>(box.upper[i]) - static_cast<double>(box.lower[i]);
  }
  return sum / 3.0;
}

void
BoxGrid::FindLongBoxes()
{
  constexpr double timesMean = 64.0; // so that at most a 64th of all are long
  double           sum = 0.0;
  for (const FloatBox & box : m_Boxes)
  {
    sum += MeanExtent(box);
  }
  const double longest = timesMean * sum / static_cast<double>(m_Boxes.size());
  for (std::size_t i = 0; i < m_Boxes.size(); ++i)
  {
    (MeanExtent(m_Boxes[i]) > longest ? m_Long : m_InGrid).push_back(static_cast<std::int32_t>(i));
  }
}

void
BoxGrid::ChooseCells()
{
  FloatBox all = m_Boxes[m_InGrid.front()];
  double   sum = 0.0;
  for (const std::int32_t box : m_InGrid)
  {
    for (int i = 0; i < 3; ++i)
    {
      all.lower[i] = std::min(all.lower[i], m_Boxes[box].lower[i]);
      all.upper[i] = std::max(all.upper[i], m_Boxes[box].upper[i]);
    }
    sum += MeanExtent(m_Boxes[box]);
  }
  const auto number = static_cast<double>(m_InGrid.size());
  double     cellSize = std::max(1.5 * sum / number, 1e-30);
  double     cells = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    cells *= (all.upper[i] - all.lower[i]) / cellSize + 1.0;
  }
  // No more cells than boxes have use for, however the tissue is spread.
  cellSize *= std::max(1.0, std::cbrt(cells / (8.0 * number + 1000.0)));
  for (int i = 0; i < 3; ++i)
  {
    m_Size[i] = static_cast<std::int64_t>((all.upper[i] - all.lower[i]) / cellSize) + 1;
  }
  m_Lower = all.lower;
  m_CellsPerLength = static_cast<float>(1.0 / cellSize);
}
} // namespace tissue
