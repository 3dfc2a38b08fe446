/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImagePlaces_h
#define TissueTessellationCore_ImagePlaces_h

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <boost/geometry/geometries/adapted/std_array.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <functional>
#include <limits>
#include <vector>

BOOST_GEOMETRY_REGISTER_STD_ARRAY_CS(boost::geometry::cs::cartesian)

namespace tissue
{
/** \brief Places in a label image, in physical space, by the wall or line that they are of. */
class ImagePlaces
{
public:
  using Place = std::array<float, 3>;

  struct Entry
  {
    std::int32_t group;
    Place        place;
  };
  using Entries = std::vector<Entry>;

  /** \param giveAll is called twice, as giveAll(add), and calls add(group, place) for each place, both times in the
   * same order. */
  template <typename TGiveAll>
  ImagePlaces(std::size_t numberOfGroups, const TGiveAll & giveAll)
    : m_Rows(numberOfGroups, giveAll)
  {
    for (std::size_t group = 0; group < numberOfGroups; ++group)
    {
      m_Groups.push_back({ group, 0, m_Rows[group].size() });
    }
  }

  ImagePlaces(std::size_t numberOfGroups, const Entries & entries)
    : ImagePlaces(numberOfGroups, [&entries](const auto & add) {
      for (const Entry & entry : entries)
      {
        add(static_cast<std::size_t>(entry.group), entry.place);
      }
    })
  {}

  const Place *
  Begin(std::size_t group) const
  {
    return m_Rows[m_Groups[group].row].begin() + m_Groups[group].begin;
  }

  const Place *
  End(std::size_t group) const
  {
    return m_Rows[m_Groups[group].row].begin() + m_Groups[group].end;
  }

  /** \brief Gives the places of each group to new groups, where they are: there may be millions of them.
   *
   * \param newGroupsOf gives, of each group, the new group of each of its places in turn, or one for all of them. A new
   * group is of one old group's places alone, which stay in their order. */
  void
  Regroup(std::size_t                                                        numberOfNewGroups,
          const std::function<std::vector<std::size_t>(std::size_t group)> & newGroupsOf);

private:
  /** A group's part of a row. */
  struct Part
  {
    std::size_t row;
    std::size_t begin;
    std::size_t end;
  };

  CompressedRows<Place> m_Rows;
  std::vector<Part>     m_Groups;
};

/** The centres of the voxel faces between the two cells of each pair, in any order. */
ImagePlaces
CollectImageFaces(const LabelVolume & volume, const std::vector<VertexPair> & pairs);

/** The centres of the voxel edges at which the three cells of each line meet; `lines` ascending, each line ascending,
 * all different. */
ImagePlaces
CollectImageLines(const LabelVolume & volume, const std::vector<VertexTriple> & lines);

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
IntegrateDistance(const std::vector<Point> & points, const std::vector<Triangle> & triangles, std::size_t firstTriangle,
                  std::size_t endTriangle, const PlaceTree & places);
} // namespace tissue

#endif
