/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageDual_h
#define TissueTessellationCore_ImageDual_h

#include "Dual/DualMesh.h"
#include "Nerve/ImageNerve.h"
#include "Nerve/TissuePlaces.h"

namespace tissue
{
/** \brief The dual of a complex that was taken from a label image, each corner and line where the image has it. */
struct ImageDual
{
  DualMesh mesh;
  /** Of each corner, whether the image has one of its four vertices. */
  std::vector<bool> isInImage;
};

/** The cells of four vertices, by the cell of each vertex. */
inline VertexQuadruple
CellsOf(const VertexQuadruple & vertices, const std::vector<VertexId> & cellOf)
{
  return { { cellOf[vertices[0]], cellOf[vertices[1]], cellOf[vertices[2]], cellOf[vertices[3]] } };
}

/** \brief Dualizes a nerve after its moves.
 *
 * A corner that a move has made is at the nearest place of its vertices in the image; where there is none, at the mean
 * of its neighbours. A line that a move has made runs between its corners, a little towards its own cells. Corners that
 * fall on the same place are moved apart, each by a twentieth of the way to the mean of its cells' centres.
 *
 * \param cellOf the cell of each vertex of the complex. Corners of four different cells come first, ascending by the
 *   cells as AdjacencyComplex::GetTetrahedra() has them.
 * \param centers those of the cells; the exterior's is ignored. */
ImageDual
DualizeNerve(const ImageNerve & nerve, const std::vector<CornerPlace> & places, const std::vector<VertexId> & cellOf,
             const std::vector<Point> & centers);
} // namespace tissue

#endif
