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

class Absorption
{
public:
  Absorption(LabelVolume & volume, VertexId numberOfVertices)
    : m_Volume(volume)
    , m_Pieces(volume)
    , m_Largest(FindLargest(m_Pieces, numberOfVertices))
  {}

  std::vector<AbsorbedFragment>
  Run()
  {
    this->FindContacts();
    this->Choose();
    std::vector<AbsorbedFragment> absorbed;
    for (const auto & [fragment, into] : m_Into)
    {
      absorbed.push_back({ this->VertexOf(fragment), into, m_Largest.voxels[static_cast<std::size_t>(fragment)] });
    }
    if (!absorbed.empty())
    {
      this->Relabel();
    }
    return absorbed;
  }

private:
  VertexId
  VertexOf(RunId piece) const
  {
    return m_Pieces.GetRuns()[static_cast<std::size_t>(piece)].vertex;
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
  Choose()
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
          const auto known = m_Into.find(other);
          if (!this->IsFragment(other) || known != m_Into.end())
          {
            ofVertex[known != m_Into.end() ? known->second : this->VertexOf(other)] += count;
          }
        }
        if (m_Into.count(fragment) == 0 && !ofVertex.empty())
        {
          const auto most = std::max_element(
            ofVertex.begin(), ofVertex.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
          round.emplace(fragment, most->first);
        }
      }
      m_Into.insert(round.begin(), round.end());
    } while (!round.empty());
  }

  void
  Relabel()
  {
    const auto & runs = m_Pieces.GetRuns();
    for (std::size_t row = 0; row < m_Pieces.NumberOfRows(); ++row)
    {
      const auto begin = m_Volume.vertices.begin() + static_cast<std::ptrdiff_t>(row) * m_Volume.size[0];
      for (RunId run = m_Pieces.RowBegin(row); run < m_Pieces.RowBegin(row + 1); ++run)
      {
        const auto at = m_Into.find(m_Pieces.PieceOf(run));
        if (at != m_Into.end())
        {
          const auto & r = runs[static_cast<std::size_t>(run)];
          std::fill(begin + r.begin, begin + r.end, at->second);
        }
      }
    }
  }

  LabelVolume &             m_Volume;
  Pieces                    m_Pieces;
  LargestPieces             m_Largest;
  Contacts                  m_Contacts;
  std::map<RunId, VertexId> m_Into;
};
} // namespace

std::vector<AbsorbedFragment>
AbsorbFragments(LabelVolume & volume, VertexId numberOfVertices)
{
  return Absorption(volume, numberOfVertices).Run();
}
} // namespace tissue
