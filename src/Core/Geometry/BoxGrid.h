/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BoxGrid_h
#define TissueTessellationCore_BoxGrid_h

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Box.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace tissue
{
/** \brief Finds the pairs of boxes that overlap, by a flat grid of about as many cells as boxes. At least one box. The
 * few that are far longer than the mean are compared with all, beside the grid: they would make its cells too large for
 * the others.
 *
 * The grid keeps the boxes as floats, rounded outwards. Pairs that fail to overlap by less than a millionth of their
 * distance to the others may be found as well.
 *
 * `groups`, if not empty, has a number for each box: of boxes of one group that follow each other pairs may be left
 * out, and are where that saves time. */
class BoxGrid
{
public:
  explicit BoxGrid(const std::vector<Box> & boxes, std::vector<std::int32_t> groups = {});

  /** \param boxOf gives each box; it is called once for each, so that no list of them is needed. */
  BoxGrid(std::size_t numberOfBoxes, const std::function<Box(std::size_t)> & boxOf,
          std::vector<std::int32_t> groups = {});

  std::int64_t
  NumberOfLayers() const
  {
    return m_Size[2];
  }

  /** Calls visit(a, b), a < b, for each pair of overlapping boxes whose first common cell is in the layer; the pairs of
   * long boxes are spread over the layers. */
  template <typename TVisitor>
  void
  VisitPairs(std::int64_t layer, const TVisitor & visit) const
  {
    const std::int64_t perLayer = m_Size[0] * m_Size[1];
    for (std::int64_t cell = layer * perLayer; cell < (layer + 1) * perLayer; ++cell)
    {
      const auto           members = m_Members[static_cast<std::size_t>(cell)];
      const std::int32_t * next = members.begin();
      for (const std::int32_t * i = members.begin(); i != members.end(); ++i)
      {
        const FloatBox & a = m_Boxes[*i];
        next = this->SkipGroup(i, std::max(next, i + 1), members.end());
        for (const std::int32_t * j = next; j != members.end(); ++j)
        {
          const FloatBox & b = m_Boxes[*j];
          if (AreOverlapping(a, b) && this->CellOf(MostOf(a.lower, b.lower)) == cell)
          {
            visit(*i, *j);
          }
        }
      }
    }
    for (auto i = static_cast<std::size_t>(layer); i < m_Long.size(); i += static_cast<std::size_t>(m_Size[2]))
    {
      this->VisitPairsOfLongBox(i, visit);
    }
  }

private:
  using FloatPoint = std::array<float, 3>;

  /** Relative to the first box. */
  struct FloatBox
  {
    FloatPoint lower;
    FloatPoint upper;
  };

  static double
  MeanExtent(const FloatBox & box);

  /** Parts the boxes in m_InGrid, never empty, and m_Long, both ascending. */
  void
  FindLongBoxes();

  /** Of a size that suits the boxes in m_InGrid. */
  void
  ChooseCells();

  static bool
  AreOverlapping(const FloatBox & a, const FloatBox & b)
  {
    return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] &&
           b.lower[1] <= a.upper[1] && a.lower[2] <= b.upper[2] && b.lower[2] <= a.upper[2];
  }

  static FloatPoint
  MostOf(const FloatPoint & a, const FloatPoint & b)
  {
    return { { std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2]) } };
  }

  /** The first of next ... end - 1 that is not of the group of i, or end. */
  const std::int32_t *
  SkipGroup(const std::int32_t * i, const std::int32_t * next, const std::int32_t * end) const
  {
    while (!m_Groups.empty() && next != end && m_Groups[*next] == m_Groups[*i])
    {
      ++next;
    }
    return next;
  }

  template <typename TVisitor>
  void
  VisitPairsOfLongBox(std::size_t position, const TVisitor & visit) const
  {
    const std::int32_t a = m_Long[position];
    const auto         visitWith = [&](std::int32_t b) {
      if (AreOverlapping(m_Boxes[a], m_Boxes[b]))
      {
        visit(std::min(a, b), std::max(a, b));
      }
    };
    std::for_each(m_InGrid.begin(), m_InGrid.end(), visitWith);
    std::for_each(m_Long.begin() + static_cast<std::ptrdiff_t>(position) + 1, m_Long.end(), visitWith);
  }

  std::array<std::int64_t, 3>
  Coordinates(const FloatPoint & p) const
  {
    std::array<std::int64_t, 3> c;
    for (int i = 0; i < 3; ++i)
    {
      c[i] = std::min(static_cast<std::int64_t>((p[i] - m_Lower[i]) * m_CellsPerLength), m_Size[i] - 1);
    }
    return c;
  }

  std::int64_t
  CellOf(const FloatPoint & p) const
  {
    const auto c = this->Coordinates(p);
    return (c[2] * m_Size[1] + c[1]) * m_Size[0] + c[0];
  }

  template <typename TVisitor>
  void
  VisitCells(const FloatBox & box, const TVisitor & visit) const
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

  std::vector<FloatBox>       m_Boxes;
  std::vector<std::int32_t>   m_Groups;
  FloatPoint                  m_Lower{};
  float                       m_CellsPerLength = 1.0F;
  std::array<std::int64_t, 3> m_Size{};
  /** The boxes in each cell. */
  CompressedRows<std::int32_t> m_Members;
  std::vector<std::int32_t>    m_InGrid;
  std::vector<std::int32_t>    m_Long;
};
} // namespace tissue

#endif
