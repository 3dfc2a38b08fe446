/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/ImageTopology.h"

#include "Nerve/VertexLinks.h"
#include "Nerve/WallPart.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
/** The cells of the image that have not one sphere for a link. */
std::vector<VertexId>
FindUnsoundCells(const GeneralComplex & complex, const TissuePlaces & places)
{
  std::vector<bool> isInImage(static_cast<std::size_t>(complex.NumberOfVertices()), false);
  for (const ImageWall & wall : places.walls)
  {
    isInImage[wall.cells[0]] = true;
    isInImage[wall.cells[1]] = true;
  }
  const VertexLinks     links = FindVertexLinks(complex);
  std::vector<VertexId> unsound;
  for (VertexId v = 0; v < complex.NumberOfVertices(); ++v)
  {
    const bool isSphere = links.NumberOfLinks(v) == 1 && links.links[links.firstOfVertex[v]].eulerCharacteristic == 2;
    if (isInImage[v] && !isSphere && !complex.IsOutside(v))
    {
      unsound.push_back(v);
    }
  }
  return unsound;
}

/** Of each vertex of the image and of each large fragment the vertex of the image. */
std::vector<VertexId>
CellsWithFragments(const Fragments & fragments)
{
  std::vector<VertexId> cellOf(static_cast<std::size_t>(fragments.numberOfVertices));
  std::iota(cellOf.begin(), cellOf.end(), ExteriorVertex);
  for (const Fragment & fragment : fragments.fragments)
  {
    if (fragment.isLarge)
    {
      cellOf[fragment.vertex] = fragment.cell;
    }
  }
  return cellOf;
}

/** \brief Reads an image: finds its fragments and handles, places and nerve, and divides what needs it. */
class ImageReading
{
public:
  ImageReading(const LabelVolume & volume, ImageTopology & topology, const Execution & execution)
    : m_Volume(volume)
    , m_Topology(topology)
    , m_Execution(execution)
  {}

  void
  Run(VertexId numberOfVertices, std::int64_t minimumFragmentVoxels)
  {
    m_Topology.fragments = FindFragments(m_Volume, numberOfVertices, minimumFragmentVoxels);
    if (!m_Topology.fragments.fragments.empty())
    {
      m_Topology.volume = m_Volume;
      Relabel(m_Topology.volume, m_Topology.fragments.ofLarge);
    }
    auto characteristics = this->FindPlaces();
    m_Execution.Report(0.4);
    if (!m_Topology.fragments.ofSmall.empty())
    {
      this->TakeSmallFragments();
      characteristics = FindEulerCharacteristics(this->GetImage(), m_Topology.fragments.numberOfVertices, m_Execution);
    }
    this->TakeHandles(std::move(characteristics));
    UpdateCrowdedBlocks(this->GetImage(), m_Changes, m_Blocks);
    m_Topology.nerve = MakeImageNerve(this->GetImage(), m_Topology.fragments.numberOfVertices, m_Blocks, m_Execution);
    m_Execution.Report(0.6);
    m_Division = LabelDivision({}, m_Topology.fragments.numberOfVertices);
    this->DivideWhereNeeded();
    this->NameCells();
    m_Execution.Report(0.7);
  }

  /** Divides cells, ascending, whatever their walls are, and makes the nerve anew. Returns whether there was anything
   * to divide. */
  bool
  DivideCells(const std::vector<VertexId> & cells)
  {
    auto split = WithAllWalls(this->GetImage(), m_Topology.places.walls, cells);
    this->TakeImage();
    const bool isDivided = this->DivideAndUpdate({}, std::move(split));
    this->LeaveImage();
    this->NameCells();
    return isDivided;
  }

private:
  /** As it is by now. */
  const LabelVolume &
  GetImage() const
  {
    return m_Topology.volume.vertices.empty() ? m_Volume : m_Topology.volume;
  }

  /** The walls, the crowded blocks and the corners; returns the Euler characteristics. */
  std::vector<std::int32_t>
  FindPlaces()
  {
    const LabelVolume &   image = this->GetImage();
    CrowdedBlockGathering crowded(image);
    EulerGathering        characteristics(m_Topology.fragments.numberOfVertices);
    m_Topology.places.walls = FindImageWalls(
      image,
      [&](std::size_t slab, const CrowdedBlock & block) {
        crowded.Add(slab, block);
        characteristics.Add(block);
      },
      m_Execution);
    m_Blocks = crowded.TakeBlocks();
    m_Topology.places.corners = FindCornerPlaces(image, m_Blocks);
    return characteristics.GetCharacteristics();
  }

  void
  TakeSmallFragments()
  {
    const auto row = static_cast<std::size_t>(m_Volume.size[0]);
    const auto columns = static_cast<std::size_t>(m_Volume.size[1]);
    for (const VoxelRange & range : m_Topology.fragments.ofSmall)
    {
      for (std::size_t i = range.begin; i < range.end; ++i)
      {
        m_Changes.push_back({ { { static_cast<std::int32_t>(i % row),
                                  static_cast<std::int32_t>(i / row % columns),
                                  static_cast<std::int32_t>(i / row / columns) } },
                              m_Topology.volume.vertices[i] });
      }
    }
    Relabel(m_Topology.volume, m_Topology.fragments.ofSmall);
  }

  /** \param characteristics of the image as it is by now. */
  void
  TakeHandles(std::vector<std::int32_t> characteristics)
  {
    if (std::all_of(characteristics.begin() + 1, characteristics.end(), [](std::int32_t c) { return c == 1; }))
    {
      return;
    }
    if (m_Topology.volume.vertices.empty())
    {
      m_Topology.volume = m_Volume;
    }
    HandleCuts cuts = CutHandles(m_Topology.volume, std::move(characteristics), m_Topology.fragments.boxes);
    m_Topology.handles = std::move(cuts.cells);
    m_Changes.insert(m_Changes.end(), cuts.changes.begin(), cuts.changes.end());
  }

  /** What walls of the image need it, and what is around others, then the cells that are split all the same: around
   * several others. */
  void
  DivideWhereNeeded()
  {
    const LabelVolume & image = this->GetImage();
    auto                faulty = FindFaultyWalls(image, m_Topology.places.walls, m_Topology.nerve.complex);
    auto                around = FindCellsAround(image, m_Topology.places.walls, m_Topology.fragments.numberOfVertices);
    const auto          split = FindSplitCells(image, m_Topology.places.walls, m_Topology.nerve.complex);
    if (faulty.empty() && around.empty() && split.empty())
    {
      return;
    }
    this->TakeImage();
    this->DivideAndUpdate(std::move(faulty), std::move(around));
    // Of a cell around others that is around others each pass divides one more.
    constexpr int maximumNumberOfPasses = 3;
    for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
    {
      auto left = FindSplitCells(m_Division.volume, m_Topology.places.walls, m_Topology.nerve.complex);
      if (left.empty() || !this->DivideAndUpdate({}, std::move(left)))
      {
        break;
      }
    }
    this->LeaveImage();
  }

  void
  TakeImage()
  {
    if (m_Topology.volume.vertices.empty())
    {
      m_Topology.volume = m_Volume;
    }
    m_Division.volume = std::move(m_Topology.volume);
  }

  void
  LeaveImage()
  {
    if (m_Division.NumberOfVertices() > m_Topology.fragments.numberOfVertices)
    {
      m_Topology.places.corners = FindCornerPlaces(m_Division.volume, m_Blocks);
    }
    m_Topology.volume = std::move(m_Division.volume);
  }

  /** Puts the nerve and the walls of the divided image in the place of the image's, if that has changed. */
  bool
  DivideAndUpdate(std::vector<KuhnEdge> faulty, std::vector<SplitCell> split)
  {
    if (!Divide(m_Division, std::move(faulty), std::move(split)) && !m_Division.isPadded)
    {
      return false;
    }
    auto & walls = m_Topology.places.walls;
    if (m_Division.isPadded)
    {
      m_Blocks = FindCrowdedBlocks(m_Division.volume, m_Execution);
      walls = FindImageWalls(m_Division.volume, m_Execution);
    }
    else
    {
      UpdateCrowdedBlocks(m_Division.volume, m_Division.changes, m_Blocks);
      // A voxel that changed before it was divided is there first, with the vertex that the walls know.
      m_Changes.insert(m_Changes.end(), m_Division.changes.begin(), m_Division.changes.end());
      UpdateImageWalls(m_Division.volume, m_Changes, walls);
    }
    m_Changes.clear();
    m_Topology.nerve = MakeImageNerve(m_Division.volume, m_Division.NumberOfVertices(), m_Blocks, m_Execution);
    std::vector<VertexId> outside;
    for (VertexId v = ExteriorVertex + 1; v < m_Division.NumberOfVertices(); ++v)
    {
      if (m_Division.realOf[static_cast<std::size_t>(v)] == ExteriorVertex)
      {
        outside.push_back(v);
      }
    }
    m_Topology.nerve.complex.SetOutside(std::move(outside));
    return true;
  }

  void
  NameCells()
  {
    m_Topology.divided = m_Division.FindDividedCells();
    const std::vector<VertexId> cellOf = CellsWithFragments(m_Topology.fragments);
    m_Topology.cellOf.resize(m_Division.realOf.size());
    std::transform(m_Division.realOf.begin(), m_Division.realOf.end(), m_Topology.cellOf.begin(), [&](VertexId v) {
      return cellOf[v];
    });
  }

  const LabelVolume & m_Volume;
  ImageTopology &     m_Topology;
  const Execution &   m_Execution;
  /** Of the image as it is by now. */
  std::vector<CrowdedBlock> m_Blocks;
  /** Since the walls were found. */
  std::vector<VoxelChange> m_Changes;
  /** It has the image while it is being divided. */
  LabelDivision m_Division;
};
} // namespace

ImageTopology
FindImageTopology(const LabelVolume & volume, VertexId numberOfVertices, const ImageTopologyParameters & parameters,
                  const Execution & execution, const NerveVisitor & visit)
{
  ImageTopology topology;
  ImageReading  reading(volume, topology, execution);
  reading.Run(numberOfVertices, parameters.minimumFragmentVoxels);
  // Where a handle could not be cut the cell, or the piece of one, is divided across it.
  constexpr int maximumNumberOfPasses = 4;
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    if (visit)
    {
      visit(topology);
    }
    topology.repairs = Repair(topology.nerve, topology.places);
    if (parameters.descends)
    {
      topology.descent = Descend(
        topology.nerve.complex, topology.places, parameters.preferences, parameters.votes, execution.Part(0.75, 1.0));
    }
    topology.unsoundCells = FindUnsoundCells(topology.nerve.complex, topology.places);
    if (topology.unsoundCells.empty() || pass + 1 == maximumNumberOfPasses ||
        !reading.DivideCells(topology.unsoundCells))
    {
      break;
    }
  }
  return topology;
}
} // namespace tissue
