/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallEdgeLengths_h
#define TissueTessellationCore_WallEdgeLengths_h

#include "Mesh/WallLines.h"

#include <vector>

namespace tissue
{
/** \throws std::invalid_argument unless there is one edge length for each wall, and all are positive. */
void
RequireEdgeLengths(const WallMesh & mesh, const std::vector<double> & edgeLengths);

/** Returns the number of pieces of a line of the given length: length / edgeLength, rounded, at least 1. */
int
NumberOfSegments(double length, double edgeLength);

/** Returns the number of points within a wall that give it as many triangles as equilateral ones of the edge length
 * would cover its area, for an outline of so many segments; 0 where the outline alone gives as many. */
int
NumberOfInteriorPoints(double area, double edgeLength, int outlineSegments);

/** Returns the edge length at a line: the least of its walls', so that all triangles at it are as small as those of the
 * smallest cell. */
double
EdgeLengthAt(const WallLine & line, const std::vector<double> & edgeLengths);

/** \brief Returns the lengths of the triangles' edges in each wall for a wanted number of triangles in all.
 *
 * The length in a wall is one length for all walls, times the wall's own factor, which is 1 where no factors are given.
 * NumberOfSegments() and NumberOfInteriorPoints() tell how many triangles will come of it. Where no length gives the
 * wanted number, it is approached.
 * \throws std::invalid_argument unless numberOfTriangles is positive and the factors are one for each wall or none. */
std::vector<double>
ChooseEdgeLengths(const WallMesh & mesh, double numberOfTriangles, const std::vector<double> & factors = {});

/** \brief Returns factors for ChooseEdgeLengths() by the size of each wall's smaller cell: the cube root of the ratio
 * of its volume to the median volume, to the power of `exponent`, within 1/3 ... 3.
 *
 * With the exponent 1 all cells get triangles of the same size relative to their own, with 0 all factors are 1. The
 * bounds keep tiny cells from taking most of the triangles, and huge ones from getting hardly any. */
std::vector<double>
EdgeLengthFactorsByCell(const WallMesh & mesh, const std::vector<double> & volumes, double exponent);
} // namespace tissue

#endif
