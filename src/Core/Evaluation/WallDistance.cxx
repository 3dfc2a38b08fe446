/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/WallDistance.h"

#include "Geometry/NearestInTriangle.h"
#include "Image/ImagePlaces.h"
#include "Mesh/WallPieces.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>

namespace tissue
{
namespace
{
/** Distances, each of a share of all that is measured. */
struct WeightedDistance
{
  double distance;
  double weight;

  bool
  operator<(const WeightedDistance & other) const
  {
    return distance < other.distance;
  }
};

double
WeightOf(const std::vector<WeightedDistance> & distances)
{
  return std::accumulate(
    distances.begin(), distances.end(), 0.0, [](double sum, const WeightedDistance & d) { return sum + d.weight; });
}

/** The distance than which a twentieth of the weight is farther off; -1 without any. */
double
Percentile95(std::vector<WeightedDistance> distances)
{
  std::sort(distances.begin(), distances.end());
  double left = 0.05 * WeightOf(distances);
  for (auto d = distances.rbegin(); d != distances.rend(); ++d)
  {
    left -= d->weight;
    if (left <= 0.0)
    {
      return d->distance;
    }
  }
  return -1.0;
}

/** The triangles of the walls of two cells. */
struct PairOfCells
{
  VertexPair               cells;
  std::vector<std::size_t> triangles;
};

std::vector<PairOfCells>
TrianglesOfPairs(const WallMesh & walls)
{
  std::map<VertexPair, std::vector<std::size_t>> ofPair;
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    ofPair[walls.walls[walls.wallOfTriangle[t]].cells].push_back(t);
  }
  std::vector<PairOfCells> pairs;
  for (auto & [cells, triangles] : ofPair)
  {
    pairs.push_back({ cells, std::move(triangles) });
  }
  return pairs;
}

/** The distance of a point to some triangles. Those are left out whose sphere about their centroid is too far off. */
class TriangleDistance
{
public:
  TriangleDistance(const WallMesh & walls, const std::vector<std::size_t> & triangles)
    : m_Points(walls.points)
  {
    for (const std::size_t t : triangles)
    {
      const Triangle & p = walls.triangles[t];
      const Point      center = (1.0 / 3.0) * (m_Points[p[0]] + m_Points[p[1]] + m_Points[p[2]]);
      double           radius = 0.0;
      for (const PointId corner : p)
      {
        radius = std::max(radius, Distance(center, m_Points[corner]));
      }
      m_Spheres.push_back({ center, radius, p });
    }
  }

  double
  To(const Point & place) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Sphere & sphere : m_Spheres)
    {
      if (Distance(place, sphere.center) - sphere.radius < least)
      {
        const Point & a = m_Points[sphere.triangle[0]];
        const Point & b = m_Points[sphere.triangle[1]];
        const Point & c = m_Points[sphere.triangle[2]];
        least = std::min(least, Distance(place, Combine(NearestInTriangle(place, a, b, c), a, b, c)));
      }
    }
    return least;
  }

private:
  struct Sphere
  {
    Point    center;
    double   radius;
    Triangle triangle;
  };

  const std::vector<Point> & m_Points;
  std::vector<Sphere>        m_Spheres;
};

/** Of each face of the image's walls that the mesh has. */
std::vector<WeightedDistance>
MeasureFromImage(const WallMesh & walls, const LabelVolume & labels, const Execution & execution)
{
  const std::vector<PairOfCells> pairs = TrianglesOfPairs(walls);
  std::vector<VertexPair>        cells;
  std::transform(pairs.begin(), pairs.end(), std::back_inserter(cells), [](const auto & pair) { return pair.cells; });
  const ImagePlaces                          faces = CollectImageFaces(labels, cells);
  std::vector<std::vector<WeightedDistance>> ofPair(pairs.size());
  execution.For(pairs.size(), [&](std::size_t i) {
    const TriangleDistance distance(walls, pairs[i].triangles);
    for (const ImagePlaces::Place * face = faces.Begin(i); face != faces.End(i); ++face)
    {
      ofPair[i].push_back({ distance.To({ { (*face)[0], (*face)[1], (*face)[2] } }), 1.0 });
    }
  });
  std::vector<WeightedDistance> all;
  for (const auto & distances : ofPair)
  {
    all.insert(all.end(), distances.begin(), distances.end());
  }
  return all;
}

/** -1 without any. */
double
MeanOf(const std::vector<WeightedDistance> & distances)
{
  double sum = 0.0;
  for (const WeightedDistance & d : distances)
  {
    sum += d.weight * d.distance;
  }
  return distances.empty() ? -1.0 : sum / WeightOf(distances);
}

/** The area of a wall that the image has not, or the distances of its triangles' centroids. */
struct WallSamples
{
  std::vector<WeightedDistance> ofTriangles;
  double                        falseArea = 0.0;
};

std::vector<WallSamples>
MeasureToImage(const WallMesh & walls, const LabelVolume & labels, const Execution & execution)
{
  const ImagePlaces              faces = CollectImageFaces(labels, CellsOfWalls(walls));
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(walls);
  std::vector<WallSamples>       samples(walls.walls.size());
  execution.For(walls.walls.size(), [&](std::size_t w) {
    const PlaceTree places(faces.Begin(w), faces.End(w));
    for (std::size_t t = first[w]; t < first[w + 1]; ++t)
    {
      const Point & a = walls.points[walls.triangles[t][0]];
      const Point & b = walls.points[walls.triangles[t][1]];
      const Point & c = walls.points[walls.triangles[t][2]];
      const double  area = TriangleArea(a, b, c);
      if (places.IsEmpty())
      {
        samples[w].falseArea += area;
      }
      else
      {
        samples[w].ofTriangles.push_back({ places.DistanceToNearest((1.0 / 3.0) * (a + b + c)), area });
      }
    }
  });
  return samples;
}

/** Voxel faces between two vertices, the exterior around the image counted. */
std::int64_t
CountWallFaces(const LabelVolume & labels)
{
  std::int64_t count = 0;
  for (std::int32_t z = -1; z < labels.size[2]; ++z)
  {
    for (std::int32_t y = -1; y < labels.size[1]; ++y)
    {
      for (std::int32_t x = -1; x < labels.size[0]; ++x)
      {
        const VertexId v = labels.At(x, y, z);
        count += (v != labels.At(x + 1, y, z) ? 1 : 0) + (v != labels.At(x, y + 1, z) ? 1 : 0) +
                 (v != labels.At(x, y, z + 1) ? 1 : 0);
      }
    }
  }
  return count;
}
} // namespace

WallDistance
MeasureWallDistance(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                    const Execution & execution)
{
  const std::vector<WallSamples> samples = MeasureToImage(walls, labels, execution);
  WallDistance                   result;
  std::vector<WeightedDistance>  toImage;
  double                         falseArea = 0.0;
  std::vector<double>            areaOfVertex(static_cast<std::size_t>(numberOfVertices), 0.0);
  result.ofVertex.assign(static_cast<std::size_t>(numberOfVertices), 0.0);
  for (std::size_t w = 0; w < walls.walls.size(); ++w)
  {
    falseArea += samples[w].falseArea;
    toImage.insert(toImage.end(), samples[w].ofTriangles.begin(), samples[w].ofTriangles.end());
    for (const VertexId v : walls.walls[w].cells)
    {
      for (const WeightedDistance & d : samples[w].ofTriangles)
      {
        if (v < numberOfVertices)
        {
          areaOfVertex[v] += d.weight;
          result.ofVertex[v] += d.weight * d.distance;
        }
      }
    }
  }
  for (std::size_t v = 0; v < areaOfVertex.size(); ++v)
  {
    result.ofVertex[v] = areaOfVertex[v] > 0.0 ? result.ofVertex[v] / areaOfVertex[v] : -1.0;
  }
  const std::vector<WeightedDistance> fromImage = MeasureFromImage(walls, labels, execution);
  const auto                          allFaces = static_cast<double>(CountWallFaces(labels));
  const double                        whole = falseArea + WeightOf(toImage);
  result.mean = MeanOf(toImage);
  result.meanFromImage = MeanOf(fromImage);
  result.percentile95 = std::max(Percentile95(toImage), Percentile95(fromImage));
  result.voxelLength = labels.VoxelLength();
  result.shareOfFalseWalls = whole > 0.0 ? falseArea / whole : 0.0;
  result.shareOfMissingWalls = allFaces > 0.0 ? 1.0 - WeightOf(fromImage) / allFaces : 0.0;
  return result;
}
} // namespace tissue
