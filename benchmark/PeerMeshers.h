/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PeerMeshers_h
#define PeerMeshers_h

#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"

#include <itkImage.h>

namespace tissue
{
/** \brief An image of vertices of the adjacency complex, ExteriorVertex all along its border.
 *
 * Peers are given this image, so that they see the cells as the pipeline does: with one exterior, closed at the border.
 * Their points are measured from the first voxel along the image's own axes; origin and direction change no figure. */
using CellImage = itk::Image<VertexId, 3>;

/** The boundaries of all cells as a peer makes them, and what it took to make them. */
struct PeerMesh
{
  LabelledTriangles boundaries;
  /** The number of triangles before they became LabelledTriangles. */
  std::size_t numberOfOutputTriangles = 0;
  /** The time of the peer alone, without that of bringing its input and output into form. */
  ElapsedTime time;
};

struct Mesh3Parameters
{
  /** The upper bound of the radius of a facet's surface Delaunay ball, in the image's units. */
  double facetSize = 0.0;
  /** The upper bound of the distance of a facet's circumcentre to the centre of that ball, in units of facetSize. */
  double facetDistance = 0.1;
  /** The upper bound of the circumradius of a tetrahedron, in units of facetSize. */
  double cellSize = 2.0;
};

/** \brief CGAL Mesh_3 (P. Alliez, C. Jamin, L. Rineau, S. Tayeb, J. Tournois, M. Yvinec: 3D Mesh Generation, CGAL User
 * and Reference Manual) of the cells, one sub-domain each: the facets between two sub-domains of the tetrahedral mesh.
 *
 * Optimization of tetrahedra (perturbation, exudation) is off, as it does not change what the facets separate. */
PeerMesh
MeshByMesh3(const CellImage * image, const Mesh3Parameters & parameters);

enum class LabelContour
{
  DiscreteMarchingCubes,
  DiscreteFlyingEdges
};

/** \brief Runs VTK's filters for label images on all cells; each cell is contoured by itself against all others.
 *
 * Their output has every wall twice. Where the triangles of two cells have the same points they become one triangle
 * between the two; one that has no such partner has the exterior behind it if no other cell has its points, and a gap
 * (the vertex `numberOfVertices`) otherwise. */
PeerMesh
MeshByLabelContours(const CellImage * image, VertexId numberOfVertices, LabelContour method);
} // namespace tissue

#endif
