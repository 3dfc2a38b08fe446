/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SurfaceFit_h
#define TissueTessellationCore_SurfaceFit_h

#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include <vector>

namespace tissue
{
/** A part of a surface, as a point that stands for it. */
struct SurfaceSample
{
  Point  position;
  double area;
};

/** \brief How samples lie about the surfaces that fit best, by least squares. What cannot be known is
 * UnknownStatistic. */
struct SurfaceRelief
{
  /** The root mean square distance of the samples along the given normal to a quadratic height over the plane. */
  double roughness = UnknownStatistic;
  /** That to the plane that fits best. */
  double planeDistance = UnknownStatistic;
};

/** Samples that leave the fit open, as of fewer than six places or all on one line, have no roughness; without samples
 * nothing is known. \param normal of length 1, near that of the surface. */
SurfaceRelief
MeasureRelief(const std::vector<SurfaceSample> & samples, const Point & center, const Point & normal);

/** \brief Finds the curvatures of a surface where it is nearest to a centre, by a fit to samples.
 *
 * The surface's normal sections are arcs of circles there: balls and cylinders fit exactly, and so do all others to the
 * second order. Samples that leave the fit open have no curvatures.
 * \param normal of length 1, near that of the surface, from which curvatures are seen. */
Curvatures
FitSurface(const std::vector<SurfaceSample> & samples, const Point & center, const Point & normal);

/** A part of a surface with its mean normal times its area, which its outline alone decides. */
struct SurfacePart
{
  Point  center;
  Point  normal;
  double area;
};

/** \brief Finds the curvatures of a surface by how the normals of its parts turn from one to the next: bulges of the
 * parts themselves do not count.
 *
 * Those of a ball are exact. Fewer than three parts, or parts in one line, have none.
 * \param normal of length 1, near that of the surface. */
Curvatures
FitNormals(const std::vector<SurfacePart> & parts, const Point & center, const Point & normal);
} // namespace tissue

#endif
