/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueLayer_h
#define TissueTessellationCore_TissueLayer_h

#include "Points/TissueMask.h"

#include <vector>

namespace tissue
{
/** \brief A tissue one cell thick, a sheet or a shell, flat or curved, as its cells' centres tell it.
 *
 * The layer has a plane at each point, that of its eight nearest. The tissue is what is nearer than half a cell to the
 * mean of the planes near by, by as much on either side, where cells are taken to be as thick as they are wide. Beyond
 * the outermost points it ends half-way to where the next cells would be; so holes that are wider than a cell stay
 * open, and so does what a shell encloses. */
class TissueLayer
{
public:
  /** \param points the centres of the cells, at least two. */
  explicit TissueLayer(const std::vector<Point> & points);

  /** \brief Tells whether the points show that their tissue is one layer.
   *
   * They do where two thirds of them lie flat among their eight nearest: these are spread along the normal by less than
   * half as much as along the narrower direction of the plane (standard deviations). In solid tissues one point in six
   * does, in layers nearly all do, down to shells of some thirty cells. Points between others above and below them are
   * not of a layer: there must be fewer than one in ten, else the cells are columns, one above the other. Of less than
   * ten points, whose nearest are all the others, the spread must be less than a fifth. */
  bool
  IsEvident() const;

  /** The points of the grid in the tissue. */
  TissueMask
  MakeMask(const TissueGrid & grid, const Execution & execution = Execution()) const;

  /** Moves samples of the tissue into the middle of the layer, so that cells which are made of them there are columns
   * across it: the same cells meet on both sides. */
  TissueSamples
  Flatten(TissueSamples samples, const Execution & execution = Execution()) const;

  /** The median thickness of the layer, which is the median width of its cells. */
  double
  Thickness() const;

private:
  /** Where a position is with regard to the layer: how far above its middle, along the normal there, and how thick one
   * half of the layer is. */
  struct Place
  {
    double height;
    double depth;
    Point  normal;
  };

  void
  FitPlane(std::size_t point);
  void
  EvenOutSpacings();
  void
  CloseRim(std::size_t point);
  bool
  IsBeside(std::size_t point, std::size_t other) const;
  bool
  IsBetweenOthers(std::size_t point) const;
  Place
  FindPlace(std::size_t point, const Point & position) const;
  Point
  FindFoot(std::size_t point, const Point & position) const;
  bool
  IsInTissue(std::size_t point, const Point & position) const;

  /** The points, then those where the next cells would be beyond the rims. */
  std::vector<Point>                    m_Points;
  std::size_t                           m_NumberOfCells;
  std::vector<std::vector<std::size_t>> m_Nearest;
  std::vector<Point>                    m_Normals;
  /** The spread of the nearest points along the normal over that along the narrower direction of the plane. */
  std::vector<double> m_Flatness;
  /** The widths of the cells: the mean distances of the four nearest points, even over neighbours. */
  std::vector<double> m_Spacings;
  /** The nearest of all m_Points, for the cells. */
  std::vector<std::vector<std::size_t>> m_Rivals;
};
} // namespace tissue

#endif
