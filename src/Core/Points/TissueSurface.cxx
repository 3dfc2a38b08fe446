/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueSurface.h"

#include "Common/Algorithms.h"
#include "Complex/DelaunayTetrahedralization.h"
#include "Complex/LocalSpacing.h"
#include "Complex/RelativeExterior.h"
#include "Complex/SurfaceHeights.h"
#include "Points/MirroredCenters.h"
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The greatest length of a surface triangle's edge, in units of the local spacing. Of the rules tried for cleaning a
 * complex of points alone this one kept most adjacencies, by a little. */
constexpr double MaximumEdgeLength = 1.5;
/** The bounds of depths, in units of the local spacing: the greatest first one, and the least and the greatest of all.
 * A ball-shaped cell has a depth of about a half. They limit what the joint fit can do to a single cell. */
constexpr double MostOfFirstDepth = 0.6;
constexpr double LeastDepth = 0.15;
constexpr double MostDepth = 0.8;
/** The first depth over the height of the centre above those of the neighbours below: half, as if all cells were
 * equally thick. */
constexpr double DepthOfHeight = 0.5;
/** How much a depth changes over how far the seed is off its point along the normal; as in the step of the seeds
 * (CentroidFit), less than the whole damps the joint fit. */
constexpr double DepthStep = 0.7;
/** The share of a depth that is taken from its neighbours' mean, at first, where depths are guesses, and after each
 * step of the fit. */
constexpr double FirstEvenness = 0.5;
constexpr double Evenness = 0.3;

AdjacencyComplex
CleanedComplex(const MirroredCenters & centers)
{
  AdjacencyComplex         complex(static_cast<VertexId>(centers.positions.size()),
                           DelaunayTetrahedralization(centers.positions));
  SurfaceCleanUpParameters cleanUp;
  cleanUp.maximumEdgeLength = MaximumEdgeLength;
  cleanUp.localLengths = centers.spacings;
  CleanSurface(complex, centers.positions, cleanUp);
  return complex;
}
} // namespace

TissueSurface::TissueSurface(const std::vector<Point> & points, const Box & box)
  : TissueSurface(MirrorAtSides(points, LocalSpacings(points), box), points.size())
{}

TissueSurface::TissueSurface(MirroredCenters centers, std::size_t numberOfPoints)
  : m_Complex(CleanedComplex(centers))
  , m_Centers(std::move(centers.positions))
  , m_Spacings(std::move(centers.spacings))
  , m_Normals(RelativeExterior(m_Complex, m_Centers).Normals())
  , m_IsCut(numberOfPoints + 1, false)
{
  for (std::size_t v = numberOfPoints + 1; v < centers.originals.size(); ++v)
  {
    m_IsCut[centers.originals[v]] = true;
  }
  this->EstimateDepths();
}

void
TissueSurface::EstimateDepths()
{
  const auto heights = CollectHeights(m_Complex, m_Centers, m_Normals);
  m_Depths.assign(m_Centers.size(), 0.0);
  for (std::size_t v = 1; v < m_Centers.size(); ++v)
  {
    if (m_Complex.FindEdge(ExteriorVertex, static_cast<VertexId>(v)) != nullptr)
    {
      const double height = heights[v].empty() ? m_Spacings[v] : Median(heights[v]);
      m_Depths[v] = std::min(DepthOfHeight * height, MostOfFirstDepth * m_Spacings[v]);
    }
  }
  this->EvenOut(FirstEvenness);
}

/** Takes a share of each depth from the mean of its neighbours'. */
void
TissueSurface::EvenOut(double share)
{
  std::vector<double> sums(m_Depths.size(), 0.0);
  std::vector<int>    counts(m_Depths.size(), 0);
  for (const AdjacencyComplex::Edge & edge : m_Complex.GetEdges())
  {
    const auto [u, v] = edge.vertices;
    if (m_Depths[u] > 0.0 && m_Depths[v] > 0.0)
    {
      sums[u] += m_Depths[v];
      sums[v] += m_Depths[u];
      ++counts[u];
      ++counts[v];
    }
  }
  for (std::size_t v = 1; v < m_Depths.size(); ++v)
  {
    if (counts[v] > 0)
    {
      m_Depths[v] += share * (sums[v] / counts[v] - m_Depths[v]);
    }
  }
}

void
TissueSurface::Follow(const std::vector<MetricSeed> & seeds)
{
  for (std::size_t v = 1; v < m_IsCut.size(); ++v)
  {
    if (m_Depths[v] > 0.0)
    {
      const double way = Dot(seeds[v - 1].position - m_Centers[v], m_Normals[v]);
      m_Depths[v] = std::clamp(m_Depths[v] + DepthStep * way, LeastDepth * m_Spacings[v], MostDepth * m_Spacings[v]);
    }
  }
  this->EvenOut(Evenness);
}

CellNeighbors
TissueSurface::FindNeighbors() const
{
  CellNeighbors neighbors(m_IsCut.size() - 1);
  for (const AdjacencyComplex::Edge & edge : m_Complex.GetEdges())
  {
    const auto u = static_cast<std::size_t>(edge.vertices[0]);
    const auto v = static_cast<std::size_t>(edge.vertices[1]);
    if (u > 0 && v < m_IsCut.size())
    {
      neighbors[u - 1].push_back(v - 1);
      neighbors[v - 1].push_back(u - 1);
    }
  }
  return neighbors;
}

TissueMask
TissueSurface::MakeMask(const TissueGrid & grid, const Execution & execution) const
{
  return EstimateTissueMask(m_Complex, m_Centers, m_Depths, grid, execution);
}
} // namespace tissue
