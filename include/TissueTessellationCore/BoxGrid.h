/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BoxGrid_h
#define TissueTessellationCore_BoxGrid_h

#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tissue
{
/** A box along the axes; of one point where its two corners are equal. */
struct Box
{
  Point lower;
  Point upper;
};

inline bool
Overlap(const Box & a, const Box & b)
{
  return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] && b.lower[1] <= a.upper[1] &&
         a.lower[2] <= b.upper[2] && b.lower[2] <= a.upper[2];
}

inline void
Extend(Box & box, const Point & p)
{
  for (int i = 0; i < 3; ++i)
  {
    box.lower[i] = std::min(box.lower[i], p[i]);
    box.upper[i] = std::max(box.upper[i], p[i]);
  }
}

/** \brief Finds the pairs of boxes that overlap, by a flat grid of about as many cells as boxes. At least one box; the
 * boxes must outlive the grid. */
class BoxGrid
{
public:
  explicit BoxGrid(const std::vector<Box> & boxes)
    : m_Boxes(boxes)
  {
    Box   all = boxes.front();
    Point mean{ { 0.0, 0.0, 0.0 } };
    for (const Box & box : boxes)
    {
      Extend(all, box.lower);
      Extend(all, box.upper);
      mean = mean + (box.upper - box.lower);
    }
    const double extent = (mean[0] + mean[1] + mean[2]) / (3.0 * static_cast<double>(boxes.size()));
    double       cells = 1.0;
    m_Lower = all.lower;
    m_CellSize = std::max(1.5 * extent, std::numeric_limits<double>::min());
    for (int i = 0; i < 3; ++i)
    {
      cells *= (all.upper[i] - all.lower[i]) / m_CellSize + 1.0;
    }
    // No more cells than boxes have use for, however the tissue is spread.
    m_CellSize *= std::max(1.0, std::cbrt(cells / (8.0 * static_cast<double>(boxes.size()) + 1000.0)));
    for (int i = 0; i < 3; ++i)
    {
      m_Size[i] = static_cast<std::int64_t>((all.upper[i] - all.lower[i]) / m_CellSize) + 1;
    }
    this->Fill();
  }

  std::int64_t
  NumberOfLayers() const
  {
    return m_Size[2];
  }

  /** Calls visit(a, b), a < b, for each pair of overlapping boxes whose first common cell is in the layer. */
  template <typename TVisitor>
  void
  VisitPairs(std::int64_t layer, const TVisitor & visit) const
  {
    const std::int64_t perLayer = m_Size[0] * m_Size[1];
    for (std::int64_t cell = layer * perLayer; cell < (layer + 1) * perLayer; ++cell)
    {
      for (std::int64_t i = m_First[cell]; i < m_First[cell + 1]; ++i)
      {
        const Box & a = m_Boxes[m_Members[i]];
        for (std::int64_t j = i + 1; j < m_First[cell + 1]; ++j)
        {
          const Box & b = m_Boxes[m_Members[j]];
          if (Overlap(a, b) && this->CellOf({ { std::max(a.lower[0], b.lower[0]),
                                                std::max(a.lower[1], b.lower[1]),
                                                std::max(a.lower[2], b.lower[2]) } }) == cell)
          {
            visit(m_Members[i], m_Members[j]);
          }
        }
      }
    }
  }

private:
  std::array<std::int64_t, 3>
  Coordinates(const Point & p) const
  {
    std::array<std::int64_t, 3> c;
    for (int i = 0; i < 3; ++i)
    {
      c[i] = std::min(static_cast<std::int64_t>((p[i] - m_Lower[i]) / m_CellSize), m_Size[i] - 1);
    }
    return c;
  }

  std::int64_t
  CellOf(const Point & p) const
  {
    const auto c = this->Coordinates(p);
    return (c[2] * m_Size[1] + c[1]) * m_Size[0] + c[0];
  }

  template <typename TVisitor>
  void
  VisitCells(const Box & box, const TVisitor & visit) const
  {
    const auto from = this->Coordinates(box.lower);
    const auto to = this->Coordinates(box.upper);
    for (std::int64_t z = from[2]; z <= to[2]; ++z)
    {
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
      {
        for (std::int64_t x = from[0]; x <= to[0]; ++x)
        {
          visit((z * m_Size[1] + y) * m_Size[0] + x);
        }
      }
    }
  }

  void
  Fill()
  {
    m_First.assign(m_Size[0] * m_Size[1] * m_Size[2] + 2, 0);
    for (const Box & box : m_Boxes)
    {
      this->VisitCells(box, [this](std::int64_t cell) { ++m_First[cell + 2]; });
    }
    for (std::size_t i = 1; i < m_First.size(); ++i)
    {
      m_First[i] += m_First[i - 1];
    }
    m_Members.resize(m_First.back());
    for (std::size_t i = 0; i < m_Boxes.size(); ++i)
    {
      this->VisitCells(m_Boxes[i],
                       [this, i](std::int64_t cell) { m_Members[m_First[cell + 1]++] = static_cast<std::int32_t>(i); });
    }
  }

  const std::vector<Box> &    m_Boxes;
  Point                       m_Lower{};
  double                      m_CellSize = 1.0;
  std::array<std::int64_t, 3> m_Size{};
  std::vector<std::int64_t>   m_First;
  std::vector<std::int32_t>   m_Members;
};
} // namespace tissue

#endif
