/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BlockScan_h
#define TissueTessellationCore_BlockScan_h

#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Common/Types.h"
#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "TissueTessellationCore/Image/VertexTupleTable.h"

#include <vector>

namespace tissue
{
/** \brief Gathers cells, walls, triple lines and junctions from consecutive planes of a label image, row by row.
 *
 * Rows come as runs of equal labels, so the cost is that of the runs, not of the voxels, and only two planes of runs
 * are held. All sums are of integers: they do not depend on how the image was split among scans.
 *
 * Coordinates are *padded*: the image lies at 1 ... size within a border of one voxel of exterior, 0 and size + 1. The
 * corner (x, y, z) is the one shared by the eight voxels of the block (x - 1 ... x, y - 1 ... y, z - 1 ... z).
 *
 * Cells are numbered by the scan, in the order they are met. GatherJunctions() joins the scans of an image. */
class BlockScan
{
public:
  using Index = std::array<std::int32_t, 3>;

  /** Consecutive voxels of one cell in one row; they begin where the run before ends. */
  struct Run
  {
    std::int32_t end;
    VertexId     cell;
    std::int64_t piece;
  };

  /** A part of a face-connected piece, by the number of its voxels and the sums of their coordinates. */
  struct Piece
  {
    VertexId                    cell = 0;
    std::int64_t                numberOfVoxels = 0;
    std::array<std::int64_t, 3> sum = { { 0, 0, 0 } };
  };

  /** The faces of a wall that are normal to one axis, by their number and the sums of the coordinates of the voxels at
   * their upper sides. */
  struct Faces
  {
    std::int64_t                numberOfFaces = 0;
    std::array<std::int64_t, 3> sum = { { 0, 0, 0 } };
  };

  /** Four cells that one block holds. */
  struct Quadruple
  {
    VertexQuadruple cells;
    /** The padded coordinates of the block's corner. */
    Index corner;
    /** True where the block holds no fifth cell. */
    bool exact;
  };

  using WallTable = VertexTupleTable<2, std::array<Faces, 3>>;
  using TripleTable = VertexTupleTable<3, std::int64_t>;

  /** \param size the image's size in voxels.
   *  \param firstPlane the first plane to count, at least 1. The plane before it must be fed first; it is not counted.
   */
  BlockScan(const Index & size, std::int32_t firstPlane, const ExteriorLabels & exterior);

  /** Begins the next plane. Each of its rows, from 0 to size[1] + 1, is then fed by AddRun(), not at all where it is
   * all exterior, and completed by EndRow(). */
  void
  BeginPlane();
  /** Feeds the row's voxels from the run before up to the padded coordinate `end`, excluded. Neighbouring runs may be
   * of one cell. */
  void
  AddRun(Label label, std::int32_t end)
  {
    this->AppendRun(m_Labels(label), end);
  }
  /** Completes the row with the exterior. */
  void
  EndRow();

  const LabelIndexer &
  GetLabels() const
  {
    return m_Labels;
  }
  /** Tells, by the scan's number of a cell, whether it has a voxel on the border of the image. The list ends with the
   * last cell that has one. */
  const std::vector<bool> &
  GetTouchesBorder() const
  {
    return m_TouchesBorder;
  }
  /** The parts of pieces; GetPieceSets() tells which of them make up one piece. Those of the runs of the first plane,
   * which is not counted, come first. */
  const std::vector<Piece> &
  GetPieces() const
  {
    return m_Pieces;
  }
  const DisjointSets &
  GetPieceSets() const
  {
    return m_PieceSets;
  }
  /** The runs of the last plane. */
  const std::vector<Run> &
  GetLastRuns() const
  {
    return m_Current.runs;
  }
  const WallTable &
  GetWalls() const
  {
    return m_Walls;
  }
  const TripleTable &
  GetTriples() const
  {
    return m_Triples;
  }
  const std::vector<Quadruple> &
  GetQuadruples() const
  {
    return m_Quadruples;
  }
  std::int64_t
  GetNumberOfCrowdedBlocks() const
  {
    return m_NumberOfCrowdedBlocks;
  }

private:
  struct Plane
  {
    std::vector<Run>         runs;
    std::vector<std::size_t> rowBegins;
  };

  void
  AppendRun(VertexId cell, std::int32_t end)
  {
    if (m_Current.runs.size() > m_Current.rowBegins.back() && m_Current.runs.back().cell == cell)
    {
      m_Current.runs.back().end = end;
    }
    else
    {
      m_Current.runs.push_back(Run{ end, cell, -1 });
    }
  }
  void
  MarkBorderCells();
  void
  ScanRow();
  void
  Connect(int axis, const Run & neighbour, Run & own, std::int32_t begin, std::int32_t end);
  void
  AddFaces(int axis, VertexId a, VertexId b, std::int32_t begin, std::int32_t end);
  void
  FinishRun(Run & run, std::int32_t begin);
  void
  AddBlocks(const VertexId * cells, int numberOfVoxels, std::int32_t begin, std::int32_t end);
  std::int64_t
  AddPiece(VertexId cell);

  Index             m_Size;
  std::int32_t      m_Y;
  std::int32_t      m_Z;
  bool              m_IsFirstPlane;
  LabelIndexer      m_Labels;
  std::vector<bool> m_TouchesBorder;
  Plane             m_Previous;
  Plane             m_Current;

  std::vector<Piece>     m_Pieces;
  DisjointSets           m_PieceSets;
  WallTable              m_Walls;
  TripleTable            m_Triples;
  std::vector<Quadruple> m_Quadruples;
  std::int64_t           m_NumberOfCrowdedBlocks = 0;
};
} // namespace tissue

#endif
