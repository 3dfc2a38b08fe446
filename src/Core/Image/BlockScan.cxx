/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/BlockScan.h"

#include <algorithm>
#include <limits>

namespace tissue
{
namespace
{
/** The smallest and the largest cell of the four voxels at one side of a block, and whether there is a third. Most
 * blocks need no more: those within a cell or at a wall hold one or two cells and are not recorded. The tests have no
 * branches. */
struct Side
{
  VertexId smallest;
  VertexId largest;
  bool     hasThreeCells;

  explicit Side(const VertexId * voxels)
    : smallest(std::min(std::min(voxels[0], voxels[1]), std::min(voxels[2], voxels[3])))
    , largest(std::max(std::max(voxels[0], voxels[1]), std::max(voxels[2], voxels[3])))
    , hasThreeCells(false)
  {
    for (int i = 0; i < 4; ++i)
    {
      hasThreeCells |= (voxels[i] != smallest) & (voxels[i] != largest);
    }
  }
};

/** Tells whether a block holds three cells or more. */
bool
HaveThreeCells(const Side & left, const Side & right)
{
  const VertexId smallest = std::min(left.smallest, right.smallest);
  const VertexId largest = std::max(left.largest, right.largest);
  return left.hasThreeCells | right.hasThreeCells | ((left.smallest != smallest) & (left.smallest != largest)) |
         ((left.largest != smallest) & (left.largest != largest)) |
         ((right.smallest != smallest) & (right.smallest != largest)) |
         ((right.largest != smallest) & (right.largest != largest));
}

/** Writes the cells of a block in ascending order, each once, and gives their number. */
int
FindCells(const VertexId * voxels, int numberOfVoxels, std::array<VertexId, 8> & cells)
{
  constexpr VertexId none = std::numeric_limits<VertexId>::max();
  int                count = 0;
  VertexId           last = -1;
  for (;;)
  {
    VertexId next = none;
    for (int i = 0; i < numberOfVoxels; ++i)
    {
      next = std::min(next, voxels[i] > last ? voxels[i] : none);
    }
    if (next == none)
    {
      return count;
    }
    cells[count++] = next;
    last = next;
  }
}

/** The sum of the integers begin, ..., end - 1. */
std::int64_t
SumOfRange(std::int64_t begin, std::int64_t end)
{
  return (end - begin) * (begin + end - 1) / 2;
}
} // namespace

BlockScan::BlockScan(const Index & size, std::int32_t firstPlane, const ExteriorLabels & exterior)
  : m_Size(size)
  , m_Y(0)
  , m_Z(firstPlane - 2)
  , m_IsFirstPlane(false)
  , m_Labels(exterior)
{}

void
BlockScan::BeginPlane()
{
  m_IsFirstPlane = m_Current.rowBegins.empty();
  ++m_Z;
  m_Y = 0;
  std::swap(m_Previous, m_Current);
  m_Current.runs.clear();
  m_Current.rowBegins.assign(1, 0);
  this->AppendRun(ExteriorVertex, 1);
}

void
BlockScan::EndRow()
{
  this->AppendRun(ExteriorVertex, m_Size[0] + 2);
  if (m_IsFirstPlane)
  {
    for (std::size_t i = m_Current.rowBegins.back(); i < m_Current.runs.size(); ++i)
    {
      m_Current.runs[i].piece = this->AddPiece(m_Current.runs[i].cell);
    }
  }
  else
  {
    if (m_Y == 0)
    {
      // The row is all exterior, and so is the same row of the plane before.
      m_Current.runs.front().piece = m_Previous.runs.front().piece;
    }
    else
    {
      this->MarkBorderCells();
      this->ScanRow();
    }
  }
  ++m_Y;
  if (m_Y < m_Size[1] + 2)
  {
    m_Current.rowBegins.push_back(m_Current.runs.size());
    this->AppendRun(ExteriorVertex, 1);
  }
}

void
BlockScan::MarkBorderCells()
{
  const auto mark = [this](VertexId cell) {
    if (m_TouchesBorder.size() <= static_cast<std::size_t>(cell))
    {
      m_TouchesBorder.resize(cell + 1, false);
    }
    m_TouchesBorder[cell] = true;
  };
  const auto begin = m_Current.runs.cbegin() + m_Current.rowBegins.back();
  const auto end = m_Current.runs.cend();
  if (m_Y == 1 || m_Y == m_Size[1] || m_Z == 1 || m_Z == m_Size[2])
  {
    std::for_each(begin, end, [&mark](const Run & run) { mark(run.cell); });
  }
  else if (end - begin > 1)
  {
    if (begin->end == 1)
    {
      mark((begin + 1)->cell);
    }
    if ((end - 2)->end == m_Size[0] + 1)
    {
      mark((end - 2)->cell);
    }
  }
}

void
BlockScan::ScanRow()
{
  // Four rows are scanned side by side, from one end of a run in any of them to the next. Between two such places all
  // blocks are alike, so faces and blocks are counted by their number; at each place the block across it is examined.
  const auto rowOf = [](Plane & plane, std::int32_t y) { return plane.runs.data() + plane.rowBegins[y]; };
  // These are the current runs of the four rows; the row to be scanned is the last.
  std::array<Run *, 4> runs = {
    { rowOf(m_Previous, m_Y - 1), rowOf(m_Previous, m_Y), rowOf(m_Current, m_Y - 1), rowOf(m_Current, m_Y) }
  };
  // The first four voxels are those of the rows at the left side of the block, the others those at its right side.
  std::array<VertexId, 8> voxels;
  voxels.fill(ExteriorVertex);
  Side         left(voxels.data());
  std::int32_t begin = 0;
  std::int32_t ownBegin = 0;
  for (;;)
  {
    // From begin to end each row stays in one run.
    const std::int32_t end = std::min(std::min(runs[0]->end, runs[1]->end), std::min(runs[2]->end, runs[3]->end));
    this->Connect(1, *runs[2], *runs[3], begin, end);
    this->Connect(2, *runs[1], *runs[3], begin, end);
    if (left.hasThreeCells && end - begin > 1)
    {
      this->AddBlocks(voxels.data(), 4, begin + 1, end);
    }
    if (runs[3]->end == end)
    {
      this->FinishRun(*runs[3], ownBegin);
      ownBegin = end;
      if (end == m_Size[0] + 2)
      {
        return;
      }
      this->AddFaces(0, runs[3][0].cell, runs[3][1].cell, end, end + 1);
    }
    for (int i = 0; i < 4; ++i)
    {
      runs[i] += runs[i]->end == end;
      voxels[4 + i] = runs[i]->cell;
    }
    const Side right(voxels.data() + 4);
    if (HaveThreeCells(left, right))
    {
      this->AddBlocks(voxels.data(), 8, end, end + 1);
    }
    std::copy_n(voxels.data() + 4, 4, voxels.data());
    left = right;
    begin = end;
  }
}

void
BlockScan::Connect(int axis, const Run & neighbour, Run & own, std::int32_t begin, std::int32_t end)
{
  if (neighbour.cell != own.cell)
  {
    this->AddFaces(axis, neighbour.cell, own.cell, begin, end);
  }
  else if (own.piece < 0)
  {
    own.piece = neighbour.piece;
  }
  else if (own.piece != neighbour.piece)
  {
    own.piece = m_PieceSets.Unite(own.piece, neighbour.piece);
  }
}

void
BlockScan::AddFaces(int axis, VertexId a, VertexId b, std::int32_t begin, std::int32_t end)
{
  Faces & faces = m_Walls[{ { std::min(a, b), std::max(a, b) } }][axis];
  faces.numberOfFaces += end - begin;
  faces.sum[0] += SumOfRange(begin, end);
  faces.sum[1] += static_cast<std::int64_t>(m_Y) * (end - begin);
  faces.sum[2] += static_cast<std::int64_t>(m_Z) * (end - begin);
}

void
BlockScan::FinishRun(Run & run, std::int32_t begin)
{
  if (run.piece < 0)
  {
    run.piece = this->AddPiece(run.cell);
  }
  Piece & piece = m_Pieces[run.piece];
  piece.numberOfVoxels += run.end - begin;
  piece.sum[0] += SumOfRange(begin, run.end);
  piece.sum[1] += static_cast<std::int64_t>(m_Y) * (run.end - begin);
  piece.sum[2] += static_cast<std::int64_t>(m_Z) * (run.end - begin);
}

void
BlockScan::AddBlocks(const VertexId * voxels, int numberOfVoxels, std::int32_t begin, std::int32_t end)
{
  std::array<VertexId, 8> cells;
  const int               count = FindCells(voxels, numberOfVoxels, cells);
  m_NumberOfCrowdedBlocks += count > 4 ? end - begin : 0;
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      for (int k = j + 1; k < count; ++k)
      {
        m_Triples[{ { cells[i], cells[j], cells[k] } }] += end - begin;
        for (int l = k + 1; l < count; ++l)
        {
          for (std::int32_t x = begin; x < end; ++x)
          {
            m_Quadruples.push_back({ { { cells[i], cells[j], cells[k], cells[l] } }, { { x, m_Y, m_Z } }, count == 4 });
          }
        }
      }
    }
  }
}

std::int64_t
BlockScan::AddPiece(VertexId cell)
{
  m_Pieces.emplace_back();
  m_Pieces.back().cell = cell;
  return m_PieceSets.Add();
}
} // namespace tissue
