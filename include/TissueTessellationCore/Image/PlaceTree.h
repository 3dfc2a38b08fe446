/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PlaceTree_h
#define TissueTessellationCore_PlaceTree_h

#include "TissueTessellationCore/Image/ImageFaces.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <boost/geometry/geometries/adapted/std_array.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <limits>

BOOST_GEOMETRY_REGISTER_STD_ARRAY_CS(boost::geometry::cs::cartesian)

namespace tissue
{
/** \brief The places of one wall or line in the image, for the nearest of them. */
class PlaceTree
{
public:
  PlaceTree(const ImagePlaces::Place * begin, const ImagePlaces::Place * end)
    : m_Tree(begin, end)
  {}

  bool
  IsEmpty() const
  {
    return m_Tree.empty();
  }

  /** Infinite without places. */
  double
  DistanceToNearest(const Point & point) const
  {
    const auto nearest = m_Tree.qbegin(boost::geometry::index::nearest(point, 1));
    return nearest == m_Tree.qend() ? std::numeric_limits<double>::infinity()
                                    : Distance(point, { { (*nearest)[0], (*nearest)[1], (*nearest)[2] } });
  }

private:
  boost::geometry::index::rtree<ImagePlaces::Place, boost::geometry::index::linear<16>> m_Tree;
};
/** The area of triangles, and its integral of the distance to the places, by the triangles' centroids. */
struct AreaAndDistance
{
  double area = 0.0;
  double distance = 0.0;
};

/** Of the triangles [firstTriangle, endTriangle); the distance is infinite without places. */
AreaAndDistance
IntegrateDistance(const WallMesh & mesh, std::size_t firstTriangle, std::size_t endTriangle, const PlaceTree & places);
} // namespace tissue

#endif
