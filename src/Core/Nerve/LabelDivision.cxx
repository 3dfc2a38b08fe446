/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/LabelDivision.h"

#include "Nerve/GeodesicSeeds.h"
#include "Nerve/VertexLinks.h"
#include "Nerve/VoxelBox.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace tissue
{
namespace
{
/** Steps from a wall that the layer around it reaches into the exterior. */
constexpr int LayerSteps = 2;
/** Exterior around the image: the layer of a wall at its border, and the voxel at the wall. */
constexpr std::int32_t Padding = LayerSteps + 1;
constexpr int          MaximumNumberOfRounds = 6;

/** Whether a layer around a cell may reach out of the image. */
bool
AreNearBorder(const LabelDivision & division, const std::vector<VoxelBox> & boxes)
{
  VoxelBox all;
  for (std::size_t v = 0; v < boxes.size(); ++v)
  {
    if (division.realOf[v] != ExteriorVertex && !boxes[v].IsEmpty())
    {
      all.Add(boxes[v].least);
      all.Add(boxes[v].most);
    }
  }
  bool isNearAny = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    isNearAny = isNearAny || all.least[axis] < Padding || all.most[axis] >= division.volume.size[axis] - Padding;
  }
  return isNearAny;
}

void
Shift(std::vector<KuhnEdge> & edges)
{
  const VoxelIndex shift{ { Padding, Padding, Padding } };
  for (KuhnEdge & edge : edges)
  {
    edge = { edge.first + shift, edge.second + shift };
  }
}

LabelVolume
Pad(const LabelVolume & volume)
{
  LabelVolume padded;
  padded.steps = volume.steps;
  padded.origin = volume.ToPhysical({ { -1.0 * Padding, -1.0 * Padding, -1.0 * Padding } });
  std::transform(
    volume.size.begin(), volume.size.end(), padded.size.begin(), [](std::int32_t s) { return s + 2 * Padding; });
  padded.vertices =
    VoxelVertices(static_cast<std::size_t>(padded.size[0]) * padded.size[1] * padded.size[2], ExteriorVertex);
  std::size_t from = 0;
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      const std::size_t to = OffsetOf(padded, { { Padding, y + Padding, z + Padding } });
      for (std::int32_t x = 0; x < volume.size[0]; ++x)
      {
        padded.vertices.Put(to + static_cast<std::size_t>(x), volume.vertices[from++]);
      }
    }
  }
  return padded;
}

bool
IsWithin(const LabelVolume & volume, const VoxelIndex & p)
{
  return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < volume.size[0] && p[1] < volume.size[1] && p[2] < volume.size[2];
}

/** In ascending order, so that nothing hangs on the order of a flood. */
std::vector<VoxelIndex>
EachOnce(std::vector<VoxelIndex> voxels)
{
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  return voxels;
}

/** \brief The rounds of Divide(). */
class Division
{
public:
  /** \param boxes of the vertices of the volume. */
  Division(LabelDivision & division, std::vector<VoxelBox> boxes)
    : m_Volume(division.volume)
    , m_RealOf(division.realOf)
    , m_Boxes(std::move(boxes))
  {}

  void
  Run(std::vector<KuhnEdge> starts, const std::vector<SplitCell> & split)
  {
    std::map<VertexId, Surfaces> ofVertex;
    for (const SplitCell & cell : split)
    {
      this->AppendSurface(cell, ofVertex[cell.cell]);
    }
    m_Starts = std::move(starts);
    this->AppendFaulty(ofVertex);
    for (int round = 0; round < MaximumNumberOfRounds && !ofVertex.empty(); ++round)
    {
      m_Starts.clear();
      for (const auto & [vertex, surfaces] : ofVertex)
      {
        this->DivideVertex(vertex, surfaces);
      }
      m_StartOf.clear();
      ofVertex.clear();
      this->AppendFaulty(ofVertex);
    }
  }

  /** Each voxel that has another vertex than at first, once. */
  std::vector<VoxelChange>
  TakeChanges()
  {
    const auto isSame = [](const VoxelChange & a, const VoxelChange & b) { return a.voxel == b.voxel; };
    std::stable_sort(m_Changes.begin(), m_Changes.end(), [](const VoxelChange & a, const VoxelChange & b) {
      return a.voxel < b.voxel;
    });
    m_Changes.erase(std::unique(m_Changes.begin(), m_Changes.end(), isSame), m_Changes.end());
    m_Changes.erase(std::remove_if(m_Changes.begin(),
                                   m_Changes.end(),
                                   [this](const VoxelChange & c) { return this->At(c.voxel) == c.before; }),
                    m_Changes.end());
    return std::move(m_Changes);
  }

private:
  /** Where a vertex is to be divided: its voxels at a faulty wall. */
  struct Surface
  {
    std::vector<VoxelIndex> voxels;
    /** Around what is within the vertex, so that all of it is to be divided. */
    bool isAround;
  };
  using Surfaces = std::vector<Surface>;

  VertexId
  At(const VoxelIndex & p) const
  {
    return m_Volume.At(p[0], p[1], p[2]);
  }

  bool
  IsOutside(VertexId v) const
  {
    return m_RealOf[static_cast<std::size_t>(v)] == ExteriorVertex;
  }

  /** All walls of the cell that are within it, as one surface. */
  void
  AppendSurface(const SplitCell & cell, Surfaces & surfaces)
  {
    KuhnWallSearch          search(m_Volume);
    std::vector<VoxelIndex> voxels;
    for (const KuhnEdge & start : cell.walls)
    {
      const auto wall = search.Find(start);
      if (wall)
      {
        const auto & ofCell = wall->voxels[wall->cells[0] == cell.cell ? 0 : 1];
        voxels.insert(voxels.end(), ofCell.begin(), ofCell.end());
      }
    }
    surfaces.push_back({ EachOnce(std::move(voxels)), true });
  }

  /** The faulty ones of the walls to be looked at, by the vertex that is to be divided. */
  void
  AppendFaulty(std::map<VertexId, Surfaces> & ofVertex)
  {
    KuhnWallSearch search(m_Volume);
    for (std::size_t i = 0; i < m_Starts.size(); ++i)
    {
      const KuhnEdge start = m_Starts[i];
      if (this->IsOutside(this->At(start.first)) && this->IsOutside(this->At(start.second)))
      {
        continue;
      }
      auto wall = search.Find(start);
      if (!wall || wall->IsSound())
      {
        continue;
      }
      for (const KuhnTriangle & line : wall->closedLines)
      {
        m_Starts.push_back({ line.edge.first, line.third });
        m_Starts.push_back({ line.edge.second, line.third });
      }
      if (!this->IsForThird(*wall))
      {
        const int  larger = this->FindLarger(start.first, start.second);
        const bool isClosed = wall->numberOfCircles == 0 && wall->closedLines.empty();
        ofVertex[wall->cells[larger]].push_back({ EachOnce(std::move(wall->voxels[larger])), isClosed });
      }
    }
  }

  /** A line without corners that is all of the wall's boundary gets some when the largest of its cells is divided. */
  bool
  IsForThird(const KuhnWall & wall)
  {
    if (wall.numberOfCircles > 0 || wall.closedLines.size() != 1)
    {
      return false;
    }
    const VoxelIndex & third = wall.closedLines[0].third;
    return this->FindLarger(wall.start.first, third) == 1 && this->FindLarger(wall.start.second, third) == 1;
  }

  /** Which of the regions of two voxels is larger: 0 or 1. Of the same size it is the exterior, then the one of the
   * lesser vertex. */
  int
  FindLarger(const VoxelIndex & a, const VoxelIndex & b)
  {
    const VertexId vertices[] = { this->At(a), this->At(b) };
    std::int64_t   sizes[] = { 0, 0 };
    for (const int i : { 0, 1 })
    {
      if (vertices[i] != ExteriorVertex)
      {
        sizes[i] = m_Boxes[static_cast<std::size_t>(vertices[i])].NumberOfVoxels();
        m_StartOf.emplace(vertices[i], i == 0 ? a : b);
      }
    }
    for (const int i : { 0, 1 })
    {
      if (vertices[i] == ExteriorVertex)
      {
        sizes[i] = this->SizeOfExterior(i == 0 ? a : b, sizes[1 - i]);
      }
    }
    if (sizes[0] != sizes[1])
    {
      return sizes[0] > sizes[1] ? 0 : 1;
    }
    return vertices[0] < vertices[1] ? 0 : 1;
  }

  /** The voxels of the box around what hangs together with a voxel of the exterior; unbounded where that has left the
   * image or become larger than the limit. */
  std::int64_t
  SizeOfExterior(const VoxelIndex & start, std::int64_t limit) const
  {
    constexpr std::int64_t  unbounded = std::numeric_limits<std::int64_t>::max();
    std::vector<VoxelIndex> voxels{ start };
    KeySet                  found;
    VoxelBox                box;
    found.Insert(KeyOfVoxel(m_Volume, start));
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      box.Add(voxels[i]);
      if (!IsWithin(m_Volume, voxels[i]) || box.NumberOfVoxels() > limit)
      {
        return unbounded;
      }
      for (const VoxelIndex & step : KuhnSteps())
      {
        const VoxelIndex next = voxels[i] + step;
        if (this->At(next) == ExteriorVertex && found.Insert(KeyOfVoxel(m_Volume, next)))
        {
          voxels.push_back(next);
        }
      }
    }
    return box.NumberOfVoxels();
  }

  /** The voxels of a cell that hang together with one of them, that first. */
  std::vector<VoxelIndex>
  Flood(const VoxelIndex & start) const
  {
    const VertexId    vertex = this->At(start);
    const VoxelBox &  box = m_Boxes[static_cast<std::size_t>(vertex)];
    std::vector<bool> isFound(static_cast<std::size_t>(box.NumberOfVoxels()), false);
    const auto        find = [&](const VoxelIndex & p) {
      const std::size_t row = static_cast<std::size_t>(p[2] - box.least[2]) * (box.most[1] - box.least[1] + 1) +
                              static_cast<std::size_t>(p[1] - box.least[1]);
      auto       at = isFound[row * (box.most[0] - box.least[0] + 1) + static_cast<std::size_t>(p[0] - box.least[0])];
      const bool isNew = !at;
      at = true;
      return isNew;
    };
    std::vector<VoxelIndex> voxels{ start };
    find(start);
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      for (const VoxelIndex & step : KuhnSteps())
      {
        const VoxelIndex next = voxels[i] + step;
        if (this->At(next) == vertex && find(next))
        {
          voxels.push_back(next);
        }
      }
    }
    return voxels;
  }

  /** What of the exterior is at the surfaces. */
  std::vector<VoxelIndex>
  FindLayer(const Surfaces & surfaces) const
  {
    std::vector<VoxelIndex> layer;
    KeySet                  found;
    const auto              add = [&](const VoxelIndex & p) {
      if (IsWithin(m_Volume, p) && this->At(p) == ExteriorVertex && found.Insert(KeyOfVoxel(m_Volume, p)))
      {
        layer.push_back(p);
      }
    };
    for (const Surface & surface : surfaces)
    {
      std::for_each(surface.voxels.begin(), surface.voxels.end(), add);
    }
    std::size_t begin = 0;
    for (int step = 0; step < LayerSteps; ++step)
    {
      const std::size_t end = layer.size();
      for (; begin < end; ++begin)
      {
        for (const VoxelIndex & s : KuhnSteps())
        {
          add(layer[begin] + s);
        }
      }
    }
    return layer;
  }

  /** What of a cell is at the surfaces: as far from each as that is wide, so that what is left has no layer around a
   * hole; the whole cell where one is around something. */
  std::vector<VoxelIndex>
  FindNeighborhood(const std::vector<VoxelIndex> & cell, const Surfaces & surfaces) const
  {
    if (std::any_of(surfaces.begin(), surfaces.end(), [](const Surface & surface) { return surface.isAround; }))
    {
      return cell;
    }
    std::vector<std::pair<VoxelIndex, VoxelIndex>> boxes;
    for (const Surface & surface : surfaces)
    {
      VoxelIndex least = surface.voxels.front();
      VoxelIndex most = least;
      for (const VoxelIndex & p : surface.voxels)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          least[axis] = std::min(least[axis], p[axis]);
          most[axis] = std::max(most[axis], p[axis]);
        }
      }
      const std::int32_t width = LayerSteps + std::max({ most[0] - least[0], most[1] - least[1], most[2] - least[2] });
      boxes.push_back(
        { least + VoxelIndex{ { -width, -width, -width } }, most + VoxelIndex{ { width, width, width } } });
    }
    const auto isIn = [](const VoxelIndex & p, const std::pair<VoxelIndex, VoxelIndex> & box) {
      return p[0] >= box.first[0] && p[1] >= box.first[1] && p[2] >= box.first[2] && p[0] <= box.second[0] &&
             p[1] <= box.second[1] && p[2] <= box.second[2];
    };
    std::vector<VoxelIndex> region;
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(region), [&](const VoxelIndex & p) {
      return std::any_of(boxes.begin(), boxes.end(), [&](const auto & box) { return isIn(p, box); });
    });
    return region;
  }

  void
  DivideVertex(VertexId vertex, const Surfaces & surfaces)
  {
    const bool              isExterior = vertex == ExteriorVertex;
    std::vector<VoxelIndex> cell;
    if (!isExterior)
    {
      const auto start = m_StartOf.find(vertex);
      cell = this->Flood(start != m_StartOf.end() ? start->second : surfaces.front().voxels.front());
    }
    GeodesicSeeds seeds(m_Volume, isExterior ? this->FindLayer(surfaces) : this->FindNeighborhood(cell, surfaces));
    for (const Surface & surface : surfaces)
    {
      seeds.Cover(surface.voxels);
    }
    seeds.Finish();
    const auto & region = seeds.GetRegion();
    const auto   first = static_cast<VertexId>(m_RealOf.size());
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      if (seeds.SeedOf(i) != GeodesicSeeds::None)
      {
        this->Put(region[i], first + seeds.SeedOf(i));
      }
    }
    m_RealOf.resize(m_RealOf.size() + static_cast<std::size_t>(seeds.NumberOfSeeds()),
                    m_RealOf[static_cast<std::size_t>(vertex)]);
    if (!isExterior)
    {
      this->NumberRest(vertex, cell);
    }
    m_Boxes.resize(m_RealOf.size());
    m_Boxes[static_cast<std::size_t>(vertex)] = VoxelBox();
    for (const VoxelIndex & p : isExterior ? region : cell)
    {
      m_Boxes[static_cast<std::size_t>(this->At(p))].Add(p);
    }
    if (seeds.NumberOfSeeds() > 1)
    {
      this->AppendStarts(region);
    }
  }

  /** What is left of a cell keeps its vertex if it is one piece; other pieces become vertices of their own. Where
   * nothing is left, the part of the last seed gets the vertex. */
  void
  NumberRest(VertexId vertex, const std::vector<VoxelIndex> & cell)
  {
    std::vector<VoxelIndex> last;
    for (const VoxelIndex & start : cell)
    {
      if (this->At(start) == vertex)
      {
        last = this->Flood(start);
        const auto piece = static_cast<VertexId>(m_RealOf.size());
        m_RealOf.push_back(m_RealOf[static_cast<std::size_t>(vertex)]);
        for (const VoxelIndex & p : last)
        {
          this->Put(p, piece);
        }
      }
    }
    // The last vertex is the last piece, or a seed's.
    const VertexId number = static_cast<VertexId>(m_RealOf.size()) - 1;
    for (const VoxelIndex & p : last.empty() ? cell : last)
    {
      if (this->At(p) == number)
      {
        this->Put(p, vertex);
      }
    }
    m_RealOf.pop_back();
  }

  /** Of all walls of the region. */
  void
  AppendStarts(const std::vector<VoxelIndex> & region)
  {
    for (const VoxelIndex & p : region)
    {
      for (const VoxelIndex & step : KuhnSteps())
      {
        if (this->At(p) != this->At(p + step))
        {
          m_Starts.push_back({ p, p + step });
        }
      }
    }
  }

  void
  Put(const VoxelIndex & p, VertexId vertex)
  {
    m_Changes.push_back({ p, m_Volume.vertices[OffsetOf(m_Volume, p)] });
    m_Volume.vertices.Put(OffsetOf(m_Volume, p), vertex);
  }

  LabelVolume &           m_Volume;
  std::vector<VertexId> & m_RealOf;
  std::vector<KuhnEdge>   m_Starts;
  /** All of them in their order: a voxel may change several times, or get back what it had. */
  std::vector<VoxelChange> m_Changes;
  /** Of each vertex, which is one piece if it is not the exterior. */
  std::vector<VoxelBox> m_Boxes;
  /** Where the vertices that a round has looked at begin to be listed. */
  std::map<VertexId, VoxelIndex> m_StartOf;
};

/** The share of a cell's faces from which on a wall is nearly all of its surface. */
constexpr double ShareOfNearlyAll = 0.75;

/** Of each vertex its faces in all walls. */
std::vector<std::int64_t>
CountFaces(const std::vector<ImageWall> & walls, VertexId numberOfVertices)
{
  std::vector<std::int64_t> faces(static_cast<std::size_t>(numberOfVertices), 0);
  for (const ImageWall & wall : walls)
  {
    faces[static_cast<std::size_t>(wall.cells[0])] += wall.numberOfFaces;
    faces[static_cast<std::size_t>(wall.cells[1])] += wall.numberOfFaces;
  }
  return faces;
}

std::vector<SplitCell>
ToSplitCells(std::map<VertexId, std::vector<KuhnEdge>> ofCell)
{
  std::vector<SplitCell> split;
  for (auto & [cell, edges] : ofCell)
  {
    if (!edges.empty())
    {
      split.push_back({ cell, std::move(edges) });
    }
  }
  return split;
}

/** Edges across a wall: its first face, or where that was a small fragment's, which has another cell by now, faces of
 * the same two cells near it. */
std::vector<KuhnEdge>
StartsOf(const LabelVolume & volume, const ImageWall & wall)
{
  constexpr std::int32_t reach = 4; // small fragments of few voxels
  const auto             isAcross = [&](const VoxelIndex & p, const VoxelIndex & q) {
    const VertexId a = volume.At(p[0], p[1], p[2]);
    const VertexId b = volume.At(q[0], q[1], q[2]);
    return std::minmax(a, b) == std::minmax(wall.cells[0], wall.cells[1]);
  };
  if (isAcross(wall.face[0], wall.face[1]))
  {
    return { { wall.face[0], wall.face[1] } };
  }
  std::vector<KuhnEdge> starts;
  const VoxelIndex &    f = wall.face[0];
  for (std::int32_t z = std::max(-1, f[2] - reach); z < std::min(volume.size[2], f[2] + reach); ++z)
  {
    for (std::int32_t y = std::max(-1, f[1] - reach); y < std::min(volume.size[1], f[1] + reach); ++y)
    {
      for (std::int32_t x = std::max(-1, f[0] - reach); x < std::min(volume.size[0], f[0] + reach); ++x)
      {
        const VoxelIndex p{ { x, y, z } };
        for (const int set : { 1, 2, 4 })
        {
          const VoxelIndex q = p + KuhnSteps()[set - 1];
          if (isAcross(p, q))
          {
            starts.push_back({ p, q });
          }
        }
      }
    }
  }
  return starts;
}

/** Of each cell that has several links the index of the largest one. */
std::map<VertexId, std::int32_t>
FindLargestLinks(const GeneralComplex & nerve, const VertexLinks & links)
{
  std::map<VertexId, std::int32_t> largest;
  for (VertexId v = 0; v < nerve.NumberOfVertices(); ++v)
  {
    if (!nerve.IsOutside(v) && links.NumberOfLinks(v) > 1)
    {
      const auto begin = links.links.begin() + static_cast<std::ptrdiff_t>(links.firstOfVertex[v]);
      const auto end = links.links.begin() + static_cast<std::ptrdiff_t>(links.firstOfVertex[v + 1]);
      const auto most = std::max_element(
        begin, end, [](const auto & a, const auto & b) { return a.numberOfTriangles < b.numberOfTriangles; });
      largest.emplace(v, static_cast<std::int32_t>(most - links.links.begin()));
    }
  }
  return largest;
}

/** Of each cell that has several links the neighbours that are not in the largest one. */
std::map<VertexId, std::set<VertexId>>
FindNeighborsWithin(const GeneralComplex & nerve)
{
  const VertexLinks                      links = FindVertexLinks(nerve);
  const auto                             largest = FindLargestLinks(nerve, links);
  std::map<VertexId, std::set<VertexId>> within;
  std::set<VertexPair>                   around;
  for (TetrahedronId id = 0; !largest.empty() && id < nerve.TetrahedronIdBound(); ++id)
  {
    const VertexQuadruple & t = nerve.GetTetrahedron(id).vertices;
    for (int i = 0; nerve.IsAlive(id) && i < 4; ++i)
    {
      const auto found = largest.find(t[i]);
      for (int j = 0; found != largest.end() && j < 4; ++j)
      {
        if (links.linkOf[id][i] == found->second)
        {
          around.insert({ { t[i], t[j] } });
        }
        else if (j != i)
        {
          within[t[i]].insert(t[j]);
        }
      }
    }
  }
  for (const VertexPair & pair : around)
  {
    within[pair[0]].erase(pair[1]);
  }
  return within;
}
} // namespace

LabelDivision::LabelDivision(LabelVolume undivided, VertexId numberOfVertices)
  : volume(std::move(undivided))
  , realOf(static_cast<std::size_t>(numberOfVertices))
{
  std::iota(realOf.begin(), realOf.end(), ExteriorVertex);
}

std::vector<DividedCell>
LabelDivision::FindDividedCells() const
{
  std::map<VertexId, std::int32_t> pieces;
  for (const VertexId cell : realOf)
  {
    ++pieces[cell];
  }
  std::vector<DividedCell> cells;
  for (const auto & [cell, count] : pieces)
  {
    if (count > 1)
    {
      cells.push_back({ cell, count });
    }
  }
  return cells;
}

bool
Divide(LabelDivision & division, std::vector<KuhnEdge> faulty, std::vector<SplitCell> split)
{
  std::vector<VoxelBox> boxes = FindVoxelBoxes(division.volume, division.realOf.size());
  division.isPadded = AreNearBorder(division, boxes);
  if (division.isPadded)
  {
    division.volume = Pad(division.volume);
    Shift(faulty);
    for (SplitCell & cell : split)
    {
      Shift(cell.walls);
    }
    boxes = FindVoxelBoxes(division.volume, division.realOf.size());
  }
  const VertexId before = division.NumberOfVertices();
  Division       run(division, std::move(boxes));
  run.Run(std::move(faulty), split);
  division.changes = run.TakeChanges();
  return division.NumberOfVertices() > before;
}

std::vector<KuhnEdge>
FindFaultyWalls(const LabelVolume & volume, const std::vector<ImageWall> & walls, const GeneralComplex & nerve)
{
  std::map<VertexPair, int> balance;
  for (const GeneralComplex::Edge & edge : nerve.FindEdges())
  {
    ++balance[edge.vertices];
  }
  for (const ImageWall & wall : walls)
  {
    --balance[wall.cells];
  }
  KuhnWallSearch        search(volume);
  std::vector<KuhnEdge> faulty;
  for (const ImageWall & wall : walls)
  {
    if (balance[wall.cells] == 0)
    {
      continue;
    }
    for (const KuhnEdge & start : StartsOf(volume, wall))
    {
      const auto found = search.Find(start);
      if (found && !found->IsSound())
      {
        faulty.push_back(start);
      }
    }
  }
  return faulty;
}

std::vector<SplitCell>
FindCellsAround(const LabelVolume & volume, const std::vector<ImageWall> & walls, VertexId numberOfVertices)
{
  const std::vector<std::int64_t>           facesOf = CountFaces(walls, numberOfVertices);
  std::map<VertexId, std::vector<KuhnEdge>> ofCell;
  for (const ImageWall & wall : walls)
  {
    const int      within = facesOf[wall.cells[0]] < facesOf[wall.cells[1]] ? 0 : 1;
    const VertexId cell = wall.cells[within];
    if (cell != ExteriorVertex && wall.cells[1 - within] != ExteriorVertex &&
        static_cast<double>(wall.numberOfFaces) > ShareOfNearlyAll * static_cast<double>(facesOf[cell]))
    {
      const auto starts = StartsOf(volume, wall);
      auto &     all = ofCell[wall.cells[1 - within]];
      all.insert(all.end(), starts.begin(), starts.end());
    }
  }
  return ToSplitCells(std::move(ofCell));
}

std::vector<SplitCell>
WithAllWalls(const LabelVolume & volume, const std::vector<ImageWall> & walls, const std::vector<VertexId> & cells)
{
  std::map<VertexId, std::vector<KuhnEdge>> ofCell;
  for (std::size_t i = 0; i < 2 * walls.size(); ++i)
  {
    const VertexId cell = walls[i / 2].cells[i % 2];
    if (std::binary_search(cells.begin(), cells.end(), cell))
    {
      const auto starts = StartsOf(volume, walls[i / 2]);
      ofCell[cell].insert(ofCell[cell].end(), starts.begin(), starts.end());
    }
  }
  return ToSplitCells(std::move(ofCell));
}

std::vector<SplitCell>
FindSplitCells(const LabelVolume & volume, const std::vector<ImageWall> & walls, const GeneralComplex & nerve)
{
  const auto                                within = FindNeighborsWithin(nerve);
  std::map<VertexId, std::vector<KuhnEdge>> ofCell;
  for (std::size_t i = 0; !within.empty() && i < 2 * walls.size(); ++i)
  {
    const ImageWall & wall = walls[i / 2];
    const VertexId    cell = wall.cells[i % 2];
    const auto        found = within.find(cell);
    if (found != within.end() && found->second.count(wall.cells[1 - i % 2]) != 0)
    {
      const auto starts = StartsOf(volume, wall);
      ofCell[cell].insert(ofCell[cell].end(), starts.begin(), starts.end());
    }
  }
  return ToSplitCells(std::move(ofCell));
}
} // namespace tissue
