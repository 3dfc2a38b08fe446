/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/WallFaces.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace tissue
{
namespace
{
using Place = ImagePlaces::Place;

double
SquaredDistance(const Place & place, const Point & point)
{
  const Point v = Point{ { place[0], place[1], place[2] } } - point;
  return Dot(v, v);
}

/** The points on the outline of each wall that is asked for. */
std::vector<std::vector<Point>>
CollectOutlines(const WallMesh & mesh, const std::vector<bool> & isAsked)
{
  std::vector<std::set<PointId>> ids(mesh.walls.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      if (isAsked[mesh.wallOfTriangle[t]] && mesh.numberOfCells[p] != CellsWithinWall)
      {
        ids[mesh.wallOfTriangle[t]].insert(p);
      }
    }
  }
  std::vector<std::vector<Point>> outlines(ids.size());
  for (std::size_t w = 0; w < ids.size(); ++w)
  {
    for (const PointId p : ids[w])
    {
      outlines[w].push_back(mesh.points[p]);
    }
  }
  return outlines;
}

/** The piece of each face: faces that share an edge of a voxel are of one. Pieces are numbered in the order of their
 * first faces. */
std::vector<std::size_t>
FindPieces(const LabelVolume & volume, const Place * begin, const Place * end)
{
  // In doubled indices the centre of a face is odd along its axis and even along the others; the middles of its edges
  // are one further along one of these.
  const auto                                         count = static_cast<std::size_t>(end - begin);
  DisjointSets                                       sets(count);
  std::map<std::array<std::int64_t, 3>, std::size_t> faceAtEdge;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point                 index = volume.ToIndex({ { begin[i][0], begin[i][1], begin[i][2] } });
    std::array<std::int64_t, 3> doubled{};
    std::transform(index.begin(), index.end(), doubled.begin(), [](double x) { return std::llround(2.0 * x); });
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int step = -1; doubled[axis] % 2 == 0 && step < 2; step += 2)
      {
        auto edge = doubled;
        edge[axis] += step;
        sets.Unite(i, faceAtEdge.emplace(edge, i).first->second);
      }
    }
  }
  std::unordered_map<std::size_t, std::size_t> pieceOf;
  std::vector<std::size_t>                     pieces(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    pieces[i] = pieceOf.emplace(sets.Find(i), pieceOf.size()).first->second;
  }
  return pieces;
}

/** Shares the faces of two vertices among their walls. */
class FaceSharing
{
public:
  FaceSharing(const LabelVolume & volume, const Place * begin, const Place * end)
    : m_Begin(begin)
    , m_Pieces(FindPieces(volume, begin, end))
    , m_NumberOfPieces(m_Pieces.empty() ? 0 : *std::max_element(m_Pieces.begin(), m_Pieces.end()) + 1)
  {}

  /** Of each face the index of one of the outlines. */
  std::vector<std::size_t>
  Share(const std::vector<const std::vector<Point> *> & outlines) const
  {
    std::vector<std::vector<std::size_t>> claims(m_NumberOfPieces);
    for (std::size_t w = 0; w < outlines.size(); ++w)
    {
      claims[this->PieceOfOutline(*outlines[w])].push_back(w);
    }
    std::vector<std::size_t> wallOf(m_Pieces.size());
    for (std::size_t piece = 0; piece < m_NumberOfPieces; ++piece)
    {
      if (claims[piece].empty())
      {
        claims[piece].push_back(this->NearestToPiece(piece, outlines));
      }
    }
    for (std::size_t i = 0; i < m_Pieces.size(); ++i)
    {
      const std::vector<std::size_t> & walls = claims[m_Pieces[i]];
      wallOf[i] = *std::min_element(walls.begin(), walls.end(), [&](std::size_t a, std::size_t b) {
        return this->DistanceTo(i, *outlines[a]) < this->DistanceTo(i, *outlines[b]);
      });
    }
    return wallOf;
  }

private:
  double
  DistanceTo(std::size_t face, const std::vector<Point> & outline) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Point & point : outline)
    {
      least = std::min(least, SquaredDistance(m_Begin[face], point));
    }
    return least;
  }

  std::size_t
  PieceOfOutline(const std::vector<Point> & outline) const
  {
    std::vector<int> votes(m_NumberOfPieces, 0);
    for (const Point & point : outline)
    {
      const Place * nearest =
        std::min_element(m_Begin, m_Begin + m_Pieces.size(), [&point](const Place & a, const Place & b) {
          return SquaredDistance(a, point) < SquaredDistance(b, point);
        });
      ++votes[m_Pieces[static_cast<std::size_t>(nearest - m_Begin)]];
    }
    return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  std::size_t
  NearestToPiece(std::size_t piece, const std::vector<const std::vector<Point> *> & outlines) const
  {
    double      least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t w = 0; w < outlines.size(); ++w)
    {
      for (std::size_t i = 0; i < m_Pieces.size(); ++i)
      {
        const double distance = m_Pieces[i] == piece ? this->DistanceTo(i, *outlines[w]) : least;
        if (distance < least)
        {
          least = distance;
          nearest = w;
        }
      }
    }
    return nearest;
  }

  const Place *            m_Begin;
  std::vector<std::size_t> m_Pieces;
  std::size_t              m_NumberOfPieces;
};
} // namespace

ImagePlaces
CollectWallFaces(const WallMesh & mesh, const std::vector<VertexPair> & pairs, const LabelVolume & volume)
{
  std::map<VertexPair, std::vector<WallId>> wallsOf;
  for (std::size_t w = 0; w < pairs.size(); ++w)
  {
    const auto [u, v] = std::minmax(pairs[w][0], pairs[w][1]);
    wallsOf[{ { u, v } }].push_back(static_cast<WallId>(w));
  }
  std::vector<VertexPair> differentPairs;
  std::vector<bool>       isOneOfSeveral(pairs.size(), false);
  for (const auto & [pair, walls] : wallsOf)
  {
    differentPairs.push_back(pair);
    for (const WallId wall : walls)
    {
      isOneOfSeveral[wall] = walls.size() > 1;
    }
  }
  ImagePlaces faces = CollectImageFaces(volume, differentPairs);
  const auto  outlines = CollectOutlines(mesh, isOneOfSeveral);
  faces.Regroup(pairs.size(), [&](std::size_t group) {
    const std::vector<WallId> & walls = wallsOf[differentPairs[group]];
    const Place * const         begin = faces.Begin(group);
    if (walls.size() == 1 || begin == faces.End(group))
    {
      return std::vector<std::size_t>{ static_cast<std::size_t>(walls.front()) };
    }
    std::vector<const std::vector<Point> *> outlinesHere;
    for (const WallId wall : walls)
    {
      outlinesHere.push_back(&outlines[wall]);
    }
    std::vector<std::size_t> wallOf = FaceSharing(volume, begin, faces.End(group)).Share(outlinesHere);
    std::transform(wallOf.begin(), wallOf.end(), wallOf.begin(), [&](std::size_t i) { return walls[i]; });
    return wallOf;
  });
  return faces;
}
} // namespace tissue
