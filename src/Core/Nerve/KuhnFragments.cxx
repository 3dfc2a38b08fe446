/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnFragments.h"

#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
/** Number of runs that are joined as they come; a piece is some parts, and goes by the first one. */
using PartId = std::int64_t;

/** Consecutive voxels of one vertex in a row, [begin, end). */
struct LabelRun
{
  VertexId     vertex;
  std::int32_t begin;
  std::int32_t end;
  PartId       part;
};

using RunRow = std::vector<LabelRun>;

/** Calls visit(run, run of the row before, common voxels) for the contacts of a row with one before it, where a voxel
 * meets that of the same place in the row, and `reach` voxels before it. */
template <typename TRow, typename TVisitor>
void
VisitContacts(TRow & row, const RunRow & before, std::int32_t reach, const TVisitor & visit)
{
  auto a = row.begin();
  auto b = before.begin();
  while (a != row.end() && b != before.end())
  {
    const std::int32_t common = std::min(a->end, b->end + reach) - std::max(a->begin, b->begin);
    if (common > 0)
    {
      visit(*a, *b, common);
    }
    // The run that ends first has met all that it can; one that ends within reach may meet the next one, too.
    if (a->end <= b->end)
    {
      ++a;
    }
    else
    {
      ++b;
    }
  }
}

/** \brief The pieces of an image. Its runs are not kept but for two planes: they are read again where they are wanted.
 */
class Pieces
{
public:
  /** \param boxes get the voxels of all vertices. */
  Pieces(const LabelVolume & volume, std::vector<VoxelBox> & boxes)
    : m_Volume(volume)
  {
    this->Read([&](std::size_t row, const RunRow & runs, const RunRow &, const RunRow &) {
      const VoxelIndex first = this->FirstOfRow(row);
      for (const LabelRun & run : runs)
      {
        m_Voxels[static_cast<std::size_t>(run.part)] += run.end - run.begin;
        AddRun(run, first, boxes[static_cast<std::size_t>(run.vertex)]);
      }
    });
    for (std::size_t part = 0; part < m_Voxels.size(); ++part)
    {
      const auto piece = static_cast<std::size_t>(m_Sets.Find(static_cast<PartId>(part)));
      if (piece != part)
      {
        m_Voxels[piece] += m_Voxels[part];
      }
    }
  }

  /** Calls visit(row, its runs, those of the row before it in the plane, those of the same row in the plane before) for
   * each row; where there is no such row, without runs. */
  template <typename TVisitor>
  void
  Read(const TVisitor & visit)
  {
    const RunRow        none;
    const auto          rows = static_cast<std::size_t>(m_Volume.size[1]);
    std::vector<RunRow> plane(rows);
    std::vector<RunRow> below(rows);
    PartId              next = 0;
    for (std::size_t row = 0; row < rows * static_cast<std::size_t>(m_Volume.size[2]); ++row)
    {
      const std::size_t y = row % rows;
      if (y == 0)
      {
        plane.swap(below);
      }
      const RunRow & near = y > 0 ? plane[y - 1] : none;
      this->FindRuns(row, plane[y]);
      for (const RunRow * before : { &near, static_cast<const RunRow *>(&below[y]), y > 0 ? &below[y - 1] : &none })
      {
        this->Join(plane[y], *before);
      }
      this->AddParts(plane[y], next);
      visit(row, plane[y], near, below[y]);
    }
  }

  VoxelIndex
  FirstOfRow(std::size_t row) const
  {
    const auto rows = static_cast<std::size_t>(m_Volume.size[1]);
    return { { 0, static_cast<std::int32_t>(row % rows), static_cast<std::int32_t>(row / rows) } };
  }

  /** \param first voxel of the row. */
  static void
  AddRun(const LabelRun & run, const VoxelIndex & first, VoxelBox & box)
  {
    box.Add({ { run.begin, first[1], first[2] } });
    box.Add({ { run.end - 1, first[1], first[2] } });
  }

  PartId
  NumberOfParts() const
  {
    return static_cast<PartId>(m_VertexOf.size());
  }
  PartId
  PieceOf(PartId part)
  {
    return m_Sets.Find(part);
  }
  VertexId
  VertexOf(PartId part) const
  {
    return m_VertexOf[static_cast<std::size_t>(part)];
  }
  std::int64_t
  VoxelsOf(PartId piece) const
  {
    return m_Voxels[static_cast<std::size_t>(piece)];
  }

private:
  static constexpr PartId None = -1;

  void
  FindRuns(std::size_t row, RunRow & runs) const
  {
    runs.clear();
    m_Volume.vertices.Visit([&](const auto * first) {
      const auto * const labels = first + row * static_cast<std::size_t>(m_Volume.size[0]);
      for (std::int32_t begin = 0; begin < m_Volume.size[0];)
      {
        std::int32_t end = begin + 1;
        while (end < m_Volume.size[0] && labels[end] == labels[begin])
        {
          ++end;
        }
        runs.push_back({ labels[begin], begin, end, None });
        begin = end;
      }
    });
  }

  void
  Join(RunRow & runs, const RunRow & before)
  {
    VisitContacts(runs, before, 1, [this](LabelRun & run, const LabelRun & other, std::int32_t) {
      if (run.vertex == other.vertex && run.part == None)
      {
        run.part = other.part;
      }
      else if (run.vertex == other.vertex && run.part != other.part)
      {
        m_Sets.Unite(run.part, other.part);
      }
    });
  }

  /** Parts are the same each time that the image is read. */
  void
  AddParts(RunRow & runs, PartId & next)
  {
    for (LabelRun & run : runs)
    {
      if (run.part == None)
      {
        run.part = next++;
        if (run.part == this->NumberOfParts())
        {
          m_Sets.Add();
          m_VertexOf.push_back(run.vertex);
          m_Voxels.push_back(0);
        }
      }
    }
  }

  const LabelVolume &       m_Volume;
  DisjointSets              m_Sets;
  std::vector<VertexId>     m_VertexOf;
  std::vector<std::int64_t> m_Voxels;
};

/** Of each vertex its largest piece, of several the first; -1 where it has none. */
std::vector<PartId>
FindLargest(Pieces & pieces, VertexId numberOfVertices)
{
  std::vector<PartId> largest(static_cast<std::size_t>(numberOfVertices), -1);
  for (PartId part = 0; part < pieces.NumberOfParts(); ++part)
  {
    PartId & best = largest[static_cast<std::size_t>(pieces.VertexOf(part))];
    if (pieces.PieceOf(part) == part && (best < 0 || pieces.VoxelsOf(part) > pieces.VoxelsOf(best)))
    {
      best = part;
    }
  }
  return largest;
}

/** Faces that each fragment has in common with each other piece. */
using Contacts = std::map<PartId, std::map<PartId, std::int64_t>>;

class FragmentSearch
{
public:
  FragmentSearch(const LabelVolume & volume, VertexId numberOfVertices, std::int64_t minimumVoxels)
    : m_Size(volume.size[0])
    , m_NumberOfVertices(numberOfVertices)
    , m_MinimumVoxels(minimumVoxels)
    , m_Boxes(static_cast<std::size_t>(numberOfVertices))
    , m_Pieces(volume, m_Boxes)
    , m_Largest(FindLargest(m_Pieces, numberOfVertices))
  {}

  Fragments
  Run()
  {
    Fragments result;
    result.numberOfVertices = m_NumberOfVertices;
    bool isAny = false;
    for (PartId part = 0; part < m_Pieces.NumberOfParts(); ++part)
    {
      if (m_Pieces.PieceOf(part) == part && this->IsFragment(part))
      {
        isAny = true;
        if (m_Pieces.VoxelsOf(part) >= m_MinimumVoxels)
        {
          m_Vertex.emplace(part, result.numberOfVertices++);
        }
      }
    }
    if (!isAny)
    {
      result.boxes = std::move(m_Boxes);
      return result;
    }
    const std::map<PartId, VertexId> large = m_Vertex;
    this->FindContacts();
    this->ChooseForSmall();
    for (const auto & [piece, vertex] : m_Vertex)
    {
      result.fragments.push_back(
        { m_Pieces.VertexOf(piece), m_Pieces.VoxelsOf(piece), vertex, large.count(piece) != 0 });
    }
    m_Boxes.resize(static_cast<std::size_t>(result.numberOfVertices));
    this->AppendRanges(large, result);
    result.boxes = std::move(m_Boxes);
    return result;
  }

private:
  bool
  IsFragment(PartId piece) const
  {
    const VertexId vertex = m_Pieces.VertexOf(piece);
    return vertex != ExteriorVertex && m_Largest[static_cast<std::size_t>(vertex)] != piece;
  }

  void
  AddContact(const LabelRun & runA, const LabelRun & runB, std::int64_t faces)
  {
    const PartId a = m_Pieces.PieceOf(runA.part);
    const PartId b = m_Pieces.PieceOf(runB.part);
    if (a != b && this->IsFragment(a))
    {
      m_Contacts[a][b] += faces;
    }
    if (a != b && this->IsFragment(b))
    {
      m_Contacts[b][a] += faces;
    }
  }

  void
  FindContacts()
  {
    m_Pieces.Read([this](std::size_t, const RunRow & runs, const RunRow & near, const RunRow & below) {
      for (std::size_t i = 1; i < runs.size(); ++i)
      {
        this->AddContact(runs[i - 1], runs[i], 1);
      }
      for (const RunRow * before : { &near, &below })
      {
        VisitContacts(runs, *before, 0, [this](const LabelRun & a, const LabelRun & b, std::int32_t common) {
          this->AddContact(a, b, common);
        });
      }
    });
  }

  /** In rounds: the fragments of a round go into pieces that stay, or that have found their place in an earlier one.
   * Two fragments that went into each other's cells at once would swap labels for ever. */
  void
  ChooseForSmall()
  {
    std::map<PartId, VertexId> round;
    do
    {
      round.clear();
      for (const auto & [fragment, faces] : m_Contacts)
      {
        std::map<VertexId, std::int64_t> ofVertex;
        for (const auto & [other, count] : faces)
        {
          const auto known = m_Vertex.find(other);
          if (!this->IsFragment(other) || known != m_Vertex.end())
          {
            ofVertex[known != m_Vertex.end() ? known->second : m_Pieces.VertexOf(other)] += count;
          }
        }
        if (m_Vertex.count(fragment) == 0 && !ofVertex.empty())
        {
          const auto most = std::max_element(
            ofVertex.begin(), ofVertex.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
          round.emplace(fragment, most->first);
        }
      }
      m_Vertex.insert(round.begin(), round.end());
    } while (!round.empty());
  }

  void
  AppendRanges(const std::map<PartId, VertexId> & large, Fragments & result)
  {
    m_Pieces.Read([&](std::size_t row, const RunRow & runs, const RunRow &, const RunRow &) {
      const std::size_t first = row * static_cast<std::size_t>(m_Size);
      for (const LabelRun & run : runs)
      {
        const auto at = m_Vertex.find(m_Pieces.PieceOf(run.part));
        if (at != m_Vertex.end())
        {
          auto & ranges = large.count(at->first) != 0 ? result.ofLarge : result.ofSmall;
          ranges.push_back(
            { first + static_cast<std::size_t>(run.begin), first + static_cast<std::size_t>(run.end), at->second });
          Pieces::AddRun(run, m_Pieces.FirstOfRow(row), m_Boxes[static_cast<std::size_t>(at->second)]);
        }
      }
    });
  }

  std::int32_t          m_Size;
  VertexId              m_NumberOfVertices;
  std::int64_t          m_MinimumVoxels;
  std::vector<VoxelBox> m_Boxes;
  Pieces                m_Pieces;
  std::vector<PartId>   m_Largest;
  Contacts              m_Contacts;
  /** The vertex of each fragment, large or small. */
  std::map<PartId, VertexId> m_Vertex;
};
} // namespace

Fragments
FindFragments(const LabelVolume & volume, VertexId numberOfVertices, std::int64_t minimumVoxels)
{
  return FragmentSearch(volume, numberOfVertices, minimumVoxels).Run();
}

void
Relabel(LabelVolume & volume, const std::vector<VoxelRange> & ranges)
{
  for (const VoxelRange & range : ranges)
  {
    volume.vertices.Fill(range.begin, range.end, range.vertex);
  }
}
} // namespace tissue
