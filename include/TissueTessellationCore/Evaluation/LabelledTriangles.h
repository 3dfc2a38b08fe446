/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelledTriangles_h
#define TissueTessellationCore_LabelledTriangles_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The boundaries of cells as any program may make them: triangles, each with the cells on its two sides. */
struct LabelledTriangles
{
  struct Triangle
  {
    std::array<PointId, 3> points = { { 0, 0, 0 } };
    /** The cells on the two sides. The normal, by the right-hand rule, points from the first to the second. */
    VertexPair cells = { { 0, 0 } };
  };

  std::vector<Point>    points;
  std::vector<Triangle> triangles;
};

/** \brief The boundaries of cells as files have them: triangles, each with the labels of an image on its two sides. */
struct TrianglesOfLabels
{
  struct Triangle
  {
    std::array<PointId, 3> points = { { 0, 0, 0 } };
    /** The labels on the two sides. The normal, by the right-hand rule, points from the first to the second. */
    std::array<Label, 2> labels = { { 0, 0 } };
  };

  std::vector<Point>    points;
  std::vector<Triangle> triangles;
};

/** Gives the triangles with cells in place of labels. Points at the very same place become one, the first of them, as
 * the triangles of most programs are neighbours by their places alone. Labels of the exterior are all that
 * JunctionSet::exteriorLabels names, and -1 where no cell has it; triangles between two of them are left out.
 * \throws std::invalid_argument where a label is neither a cell's nor the exterior's, or on both sides of a triangle,
 * or a point is out of range or not finite. */
LabelledTriangles
FindCellsOfTriangles(const TrianglesOfLabels & mesh, const JunctionSet & junctions);

/** \brief Groups the triangles by the pair of cells they separate, and turns them as WallMesh promises.
 *
 * The vertex of the smaller index is the wall's first cell, the exterior its second. Points in no triangle are left
 * out; the others keep their order, and so do the triangles of a wall. WallMesh::numberOfCells stays empty. All else
 * that WallMesh promises is as true as the triangles make it.
 * \throws std::invalid_argument where both sides of a triangle are the same cell, or a point is out of range. */
WallMesh
MakeWallMesh(const LabelledTriangles & mesh);
} // namespace tissue

#endif
