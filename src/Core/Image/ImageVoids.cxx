/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ImageVoids.h"

#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Voxels of the exterior in one row of the image. */
struct Run
{
  std::int32_t begin;
  std::int32_t end;
};

/** \brief The runs of the exterior, row by row, and which of them hang together. */
class ExteriorRuns
{
public:
  explicit ExteriorRuns(const LabelVolume & volume)
    : m_Volume(volume)
  {
    const std::size_t numberOfRows =
      static_cast<std::size_t>(volume.size[1]) * static_cast<std::size_t>(volume.size[2]);
    m_First.reserve(numberOfRows + 1);
    for (std::size_t row = 0; row < numberOfRows; ++row)
    {
      this->AddRow(row);
    }
    m_First.push_back(m_Runs.size());
  }

  std::vector<ImageVoid>
  FindVoids()
  {
    std::vector<ImageVoid> ofSet(m_Runs.size());
    std::vector<bool>      isOpen(m_Runs.size(), false);
    for (std::size_t row = 0; row + 1 < m_First.size(); ++row)
    {
      for (std::size_t run = m_First[row]; run < m_First[row + 1]; ++run)
      {
        const auto set = static_cast<std::size_t>(m_Sets.Find(static_cast<std::int64_t>(run)));
        if (isOpen[set] || this->IsAtBorder(row, m_Runs[run]) || !this->TakeCells(row, m_Runs[run], ofSet[set].cell))
        {
          isOpen[set] = true;
          continue;
        }
        if (set == run)
        {
          ofSet[set].first = { { m_Runs[run].begin, this->Y(row), this->Z(row) } };
        }
        ofSet[set].voxels += m_Runs[run].end - m_Runs[run].begin;
      }
    }
    std::vector<ImageVoid> voids;
    for (std::size_t set = 0; set < m_Runs.size(); ++set)
    {
      if (ofSet[set].voxels > 0 && !isOpen[set])
      {
        voids.push_back(ofSet[set]);
      }
    }
    return voids;
  }

private:
  std::int32_t
  Y(std::size_t row) const
  {
    return static_cast<std::int32_t>(row % static_cast<std::size_t>(m_Volume.size[1]));
  }

  std::int32_t
  Z(std::size_t row) const
  {
    return static_cast<std::int32_t>(row / static_cast<std::size_t>(m_Volume.size[1]));
  }

  void
  AddRow(std::size_t row)
  {
    m_First.push_back(m_Runs.size());
    m_Volume.vertices.Visit([&](const auto * vertices) {
      const auto * const begin = vertices + row * static_cast<std::size_t>(m_Volume.size[0]);
      const auto * const end = begin + m_Volume.size[0];
      const auto         isCell = [](VertexId vertex) { return vertex != ExteriorVertex; };
      for (auto at = std::find(begin, end, ExteriorVertex); at != end; at = std::find(at, end, ExteriorVertex))
      {
        const auto last = std::find_if(at, end, isCell);
        m_Runs.push_back({ static_cast<std::int32_t>(at - begin), static_cast<std::int32_t>(last - begin) });
        m_Sets.Add();
        at = last;
      }
    });
    if (this->Y(row) > 0)
    {
      this->Unite(row, row - 1);
    }
    if (this->Z(row) > 0)
    {
      this->Unite(row, row - static_cast<std::size_t>(m_Volume.size[1]));
    }
  }

  /** Unites the runs of the last row with those of one before it that they have voxel faces with. */
  void
  Unite(std::size_t row, std::size_t before)
  {
    std::size_t a = m_First[row];
    std::size_t b = m_First[before];
    while (a < m_Runs.size() && b < m_First[before + 1])
    {
      if (m_Runs[a].begin < m_Runs[b].end && m_Runs[b].begin < m_Runs[a].end)
      {
        m_Sets.Unite(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
      }
      (m_Runs[a].end < m_Runs[b].end ? a : b) += 1;
    }
  }

  bool
  IsAtBorder(std::size_t row, const Run & run) const
  {
    return run.begin == 0 || run.end == m_Volume.size[0] || this->Y(row) == 0 || this->Y(row) + 1 == m_Volume.size[1] ||
           this->Z(row) == 0 || this->Z(row) + 1 == m_Volume.size[2];
  }

  /** Whether the run, which is not at the border, has faces with one cell alone: `cell`, or whatever, where that is not
   * known yet. */
  bool
  TakeCells(std::size_t row, const Run & run, VertexId & cell) const
  {
    const std::int32_t y = this->Y(row);
    const std::int32_t z = this->Z(row);
    const auto         takes = [&cell](VertexId vertex) {
      cell = cell == ExteriorVertex ? vertex : cell;
      return vertex == ExteriorVertex || vertex == cell;
    };
    bool isOne = takes(m_Volume.At(run.begin - 1, y, z)) && takes(m_Volume.At(run.end, y, z));
    for (std::int32_t x = run.begin; isOne && x < run.end; ++x)
    {
      isOne = takes(m_Volume.At(x, y - 1, z)) && takes(m_Volume.At(x, y + 1, z)) && takes(m_Volume.At(x, y, z - 1)) &&
              takes(m_Volume.At(x, y, z + 1));
    }
    return isOne;
  }

  const LabelVolume &      m_Volume;
  std::vector<Run>         m_Runs;
  std::vector<std::size_t> m_First;
  DisjointSets             m_Sets;
};
} // namespace

std::vector<ImageVoid>
FindVoidsInCells(const LabelVolume & volume)
{
  return volume.vertices.empty() ? std::vector<ImageVoid>() : ExteriorRuns(volume).FindVoids();
}
} // namespace tissue
