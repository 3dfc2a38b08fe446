/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallAngles_h
#define TissueTessellationCore_WallAngles_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief What a mesh to be computed on must not fall below: angles in degrees, and edges over the mesh's median edge.
 */
struct AngleLimits
{
  double triangleAngle = 10.0;
  double dihedralAngle = 10.0;
  double edgeLength = 0.1;
};

/** \brief The least angles and the edges of a wall mesh. */
struct WallAngles
{
  /** The least angle of any triangle, in degrees, 0 .. 60. */
  double minimumTriangleAngle = 60.0;
  /** The least angle, within a cell, between two of its triangles with an edge in common, in degrees, 0 .. 180. */
  double minimumDihedralAngle = 180.0;
  /** The same of each cell, by vertex; 180 for the exterior, and for a cell without such an edge. */
  std::vector<double> minimumDihedralOfCell;
  double              shortestEdge = 0.0;
  double              medianEdge = 0.0;
  double              longestEdge = 0.0;

  /** The longest edge over the shortest; 0 without edges. */
  double
  EdgeLengthRatio() const
  {
    return shortestEdge > 0.0 ? longestEdge / shortestEdge : 0.0;
  }
};

WallAngles
MeasureWallAngles(const WallMesh & mesh, VertexId numberOfVertices);

/** A place of a mesh that is sharper than a limit. */
struct SharpPlace
{
  enum class Kind
  {
    TriangleAngle,
    DihedralAngle,
    EdgeLength
  };
  Kind kind;
  /** As AngleLimits has it. */
  double value;
  /** Of a dihedral angle the one that it is in, else the first of the wall. */
  VertexId cell;
  WallId   wall;
  /** The points of the triangle; of the edge alone where the last one is -1. */
  Triangle points;
};

/** All places below the limits: triangles, then edges, in ascending order. */
std::vector<SharpPlace>
FindSharpPlaces(const WallMesh & mesh, const AngleLimits & limits);

/** 0 without edges. */
double
MedianEdgeLength(const WallMesh & mesh);

/** The least angle of a triangle, in degrees. */
double
LeastAngle(const Point & a, const Point & b, const Point & c);

/** The angle at the edge from a to b between the triangles to two more points, in degrees, 0 .. 180. */
double
DihedralAngle(const Point & a, const Point & b, const Point & c, const Point & d);
} // namespace tissue

#endif
