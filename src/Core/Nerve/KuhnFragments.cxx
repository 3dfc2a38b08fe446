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
/** Consecutive voxels of one vertex in a row, [begin, end). */
struct Run
{
  VertexId     vertex;
  std::int32_t begin;
  std::int32_t end;
};

using RunId = std::int64_t;

/** \brief The image as runs, and the pieces that they are joined to. */
class Pieces
{
public:
  explicit Pieces(const LabelVolume & volume)
    : m_Rows(static_cast<std::size_t>(volume.size[1]) * volume.size[2])
    , m_RowsPerPlane(static_cast<std::size_t>(volume.size[1]))
  {
    for (std::size_t row = 0; row < m_Rows; ++row)
    {
      m_RowBegins.push_back(m_Runs.size());
      this->AppendRuns(volume.vertices.data() + row * static_cast<std::size_t>(volume.size[0]), volume.size[0]);
    }
    m_RowBegins.push_back(m_Runs.size());
    m_Sets = DisjointSets(m_Runs.size());
    for (std::size_t row = 0; row < m_Rows; ++row)
    {
      this->VisitContacts(row, 1, [&](RunId a, RunId b, std::int32_t) {
        if (m_Runs[a].vertex == m_Runs[b].vertex)
        {
          m_Sets.Unite(a, b);
        }
      });
    }
  }

  /** Calls visit(run, run of a row before, common voxels) for the contacts of a row with those before it, where a voxel
   * meets those of the same place in the row, and `reach` voxels before it. With reach 0 only by faces. */
  template <typename TVisitor>
  void
  VisitContacts(std::size_t row, std::int32_t reach, const TVisitor & visit) const
  {
    const bool hasNear = row % m_RowsPerPlane != 0;
    const bool hasBelow = row >= m_RowsPerPlane;
    if (hasNear)
    {
      this->VisitRows(row, row - 1, reach, visit);
    }
    if (hasBelow)
    {
      this->VisitRows(row, row - m_RowsPerPlane, reach, visit);
    }
    if (hasNear && hasBelow && reach > 0)
    {
      this->VisitRows(row, row - m_RowsPerPlane - 1, reach, visit);
    }
  }

  std::size_t
  NumberOfRows() const
  {
    return m_Rows;
  }
  RunId
  RowBegin(std::size_t row) const
  {
    return static_cast<RunId>(m_RowBegins[row]);
  }
  const std::vector<Run> &
  GetRuns() const
  {
    return m_Runs;
  }
  RunId
  PieceOf(RunId run)
  {
    return m_Sets.Find(run);
  }

private:
  void
  AppendRuns(const VertexId * row, std::int32_t size)
  {
    for (std::int32_t begin = 0; begin < size;)
    {
      std::int32_t end = begin + 1;
      while (end < size && row[end] == row[begin])
      {
        ++end;
      }
      m_Runs.push_back({ row[begin], begin, end });
      begin = end;
    }
  }

  template <typename TVisitor>
  void
  VisitRows(std::size_t row, std::size_t before, std::int32_t reach, const TVisitor & visit) const
  {
    std::size_t a = m_RowBegins[row];
    std::size_t b = m_RowBegins[before];
    while (a < m_RowBegins[row + 1] && b < m_RowBegins[before + 1])
    {
      const std::int32_t common =
        std::min(m_Runs[a].end, m_Runs[b].end + reach) - std::max(m_Runs[a].begin, m_Runs[b].begin);
      if (common > 0)
      {
        visit(static_cast<RunId>(a), static_cast<RunId>(b), common);
      }
      // The run that ends first has met all that it can; one that ends within reach may meet the next one, too.
      ++(m_Runs[a].end <= m_Runs[b].end ? a : b);
    }
  }

  std::size_t              m_Rows;
  std::size_t              m_RowsPerPlane;
  std::vector<Run>         m_Runs;
  std::vector<std::size_t> m_RowBegins;
  DisjointSets             m_Sets;
};

/** Of each vertex its largest piece, -1 where it has none; of each piece, by its first run, its voxels. */
struct LargestPieces
{
  std::vector<RunId>        ofVertex;
  std::vector<std::int64_t> voxels;
};

LargestPieces
FindLargest(Pieces & pieces, VertexId numberOfVertices)
{
  const auto &  runs = pieces.GetRuns();
  LargestPieces largest{ std::vector<RunId>(static_cast<std::size_t>(numberOfVertices), -1),
                         std::vector<std::int64_t>(runs.size(), 0) };
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    largest.voxels[static_cast<std::size_t>(pieces.PieceOf(static_cast<RunId>(i)))] += runs[i].end - runs[i].begin;
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    RunId & best = largest.ofVertex[static_cast<std::size_t>(runs[i].vertex)];
    if (largest.voxels[i] > (best < 0 ? 0 : largest.voxels[static_cast<std::size_t>(best)]))
    {
      best = static_cast<RunId>(i);
    }
  }
  return largest;
}

/** Faces that each fragment has in common with each other piece. */
using Contacts = std::map<RunId, std::map<RunId, std::int64_t>>;

class FragmentSearch
{
public:
  FragmentSearch(const LabelVolume & volume, VertexId numberOfVertices, std::int64_t minimumVoxels)
    : m_Size(volume.size[0])
    , m_NumberOfVertices(numberOfVertices)
    , m_MinimumVoxels(minimumVoxels)
    , m_Pieces(volume)
    , m_Largest(FindLargest(m_Pieces, numberOfVertices))
  {}

  Fragments
  Run()
  {
    Fragments result;
    result.numberOfVertices = m_NumberOfVertices;
    const auto numberOfRuns = static_cast<RunId>(m_Pieces.GetRuns().size());
    for (RunId run = 0; run < numberOfRuns; ++run)
    {
      if (m_Pieces.PieceOf(run) == run && this->IsFragment(run) && this->VoxelsOf(run) >= m_MinimumVoxels)
      {
        m_Vertex.emplace(run, result.numberOfVertices++);
      }
    }
    const std::map<RunId, VertexId> large = m_Vertex;
    this->FindContacts();
    this->ChooseForSmall();
    for (const auto & [piece, vertex] : m_Vertex)
    {
      result.fragments.push_back({ this->VertexOf(piece), this->VoxelsOf(piece), vertex, large.count(piece) != 0 });
    }
    if (!result.fragments.empty())
    {
      this->AppendRanges(large, result);
    }
    return result;
  }

private:
  VertexId
  VertexOf(RunId piece) const
  {
    return m_Pieces.GetRuns()[static_cast<std::size_t>(piece)].vertex;
  }

  std::int64_t
  VoxelsOf(RunId piece) const
  {
    return m_Largest.voxels[static_cast<std::size_t>(piece)];
  }

  bool
  IsFragment(RunId piece) const
  {
    const VertexId vertex = this->VertexOf(piece);
    return vertex != ExteriorVertex && m_Largest.ofVertex[static_cast<std::size_t>(vertex)] != piece;
  }

  void
  AddContact(RunId runA, RunId runB, std::int64_t faces)
  {
    const RunId a = m_Pieces.PieceOf(runA);
    const RunId b = m_Pieces.PieceOf(runB);
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
    for (std::size_t row = 0; row < m_Pieces.NumberOfRows(); ++row)
    {
      for (RunId run = m_Pieces.RowBegin(row) + 1; run < m_Pieces.RowBegin(row + 1); ++run)
      {
        this->AddContact(run - 1, run, 1);
      }
      m_Pieces.VisitContacts(row, 0, [&](RunId a, RunId b, std::int32_t common) { this->AddContact(a, b, common); });
    }
  }

  /** In rounds: the fragments of a round go into pieces that stay, or that have found their place in an earlier one.
   * Two fragments that went into each other's cells at once would swap labels for ever. */
  void
  ChooseForSmall()
  {
    std::map<RunId, VertexId> round;
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
            ofVertex[known != m_Vertex.end() ? known->second : this->VertexOf(other)] += count;
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
  AppendRanges(const std::map<RunId, VertexId> & large, Fragments & result)
  {
    for (std::size_t row = 0; row < m_Pieces.NumberOfRows(); ++row)
    {
      const std::size_t first = row * static_cast<std::size_t>(m_Size);
      for (RunId run = m_Pieces.RowBegin(row); run < m_Pieces.RowBegin(row + 1); ++run)
      {
        const auto at = m_Vertex.find(m_Pieces.PieceOf(run));
        if (at != m_Vertex.end())
        {
          const auto & r = m_Pieces.GetRuns()[static_cast<std::size_t>(run)];
          auto &       ranges = large.count(at->first) != 0 ? result.ofLarge : result.ofSmall;
          ranges.push_back(
            { first + static_cast<std::size_t>(r.begin), first + static_cast<std::size_t>(r.end), at->second });
        }
      }
    }
  }

  std::int32_t  m_Size;
  VertexId      m_NumberOfVertices;
  std::int64_t  m_MinimumVoxels;
  Pieces        m_Pieces;
  LargestPieces m_Largest;
  Contacts      m_Contacts;
  /** The vertex of each fragment, large or small. */
  std::map<RunId, VertexId> m_Vertex;
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
    std::fill(volume.vertices.begin() + static_cast<std::ptrdiff_t>(range.begin),
              volume.vertices.begin() + static_cast<std::ptrdiff_t>(range.end),
              range.vertex);
  }
}
} // namespace tissue
