/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LabelSpecks_h
#define LabelSpecks_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace tissue
{
/** The labels other than 0 that were looked at, and how many of them are specks. */
struct SpeckCount
{
  std::size_t labels = 0;
  std::size_t specks = 0;

  /** Whether most labels are specks, and there are enough, 8, to say so. */
  bool
  IsNoLabelImage() const
  {
    return labels >= 8 && 2 * specks > labels;
  }
};

/** \brief Counts the labels that are specks, as the grey values of a stain are.
 *
 * A label is specks where its voxels share 1.5 faces or fewer with others of it on average: those of a piece of 2 x 2 x
 * 2 voxels share 3, of a line 2, of single voxels none. Looked at are the middle planes, at most four million voxels.
 * \param fewestVoxels of a label that counts as specks. */
template <typename TImage>
SpeckCount
CountSpecks(const TImage * image, std::size_t fewestVoxels = 1)
{
  constexpr std::size_t mostVoxels = 4000000;
  constexpr std::size_t fewestPlanes = 8;
  struct Tally
  {
    std::size_t voxels = 0;
    std::size_t faces = 0;
  };
  const auto        size = image->GetLargestPossibleRegion().GetSize();
  const std::size_t row = size[0];
  const std::size_t plane = size[0] * size[1];
  const std::size_t planes = std::min<std::size_t>(size[2], std::max(fewestPlanes, mostVoxels / plane));
  const auto *      begin = image->GetBufferPointer() + (size[2] - planes) / 2 * plane;
  const std::size_t end = planes * plane;

  std::unordered_map<Label, Tally> tallies;
  Tally *                          tally = nullptr;
  for (std::size_t i = 0; i < end; ++i)
  {
    const auto label = begin[i];
    if (i == 0 || label != begin[i - 1])
    {
      tally = &tallies[static_cast<Label>(label)];
    }
    ++tally->voxels;
    // Each face counts for both of its voxels.
    tally->faces += (i % row > 0 && begin[i - 1] == label ? 2 : 0) +
                    (i % plane >= row && begin[i - row] == label ? 2 : 0) +
                    (i >= plane && begin[i - plane] == label ? 2 : 0);
  }
  tallies.erase(0);
  SpeckCount count;
  count.labels = tallies.size();
  for (const auto & [label, t] : tallies)
  {
    count.specks += t.voxels >= fewestVoxels && 2 * t.faces <= 3 * t.voxels ? 1 : 0;
  }
  return count;
}

/** Refuses what is no label image of cells but, say, a stain.
 * \throws std::runtime_error that says what to do with one. */
template <typename TImage>
void
RequireNoSpecks(const TImage * image, std::size_t fewestVoxels = 1)
{
  const SpeckCount count = CountSpecks(image, fewestVoxels);
  if (count.IsNoLabelImage())
  {
    throw std::runtime_error(std::to_string(count.specks) + " of " + std::to_string(count.labels) +
                             " labels are specks of a few voxels: this is no label image of cells; for an image of "
                             "membranes there is TissueTessellation --membrane, for one of nuclei NucleiTessellation; "
                             "--acceptSpecks takes it for labels all the same");
  }
}

/** Likewise of labels that are in many pieces, 8 or more, as the grey values of a smooth stain are. */
void
RequireFewPieces(const JunctionSet & junctions);
} // namespace tissue

#endif
