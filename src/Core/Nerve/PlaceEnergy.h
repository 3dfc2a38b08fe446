/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PlaceEnergy_h
#define TissueTessellationCore_PlaceEnergy_h

#include "Nerve/GeneralMove.h"
#include "Nerve/TissuePlaces.h"
#include "Nerve/TupleCounts.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

namespace tissue
{
/** What counts how much where a complex cannot have all of the image's walls and corners and no others. */
struct PlacePreferences
{
  /** What a wall too many or too few costs, in corners too many or too few. */
  double wallWeight = 2.0;
  /** Of two cells' walls in the image those of fewer voxel faces are noise; but the largest counts in any case. */
  std::int64_t minimumFaces = 10;
  /** The share of the votes, where there are votes on corners, from which on a corner is better than none. */
  double leastVote = 0.7;
  /** What a corner of four cells too many or too few costs where the four do meet and the complex has a corner of
   * theirs: only the number is wrong then, not which cells meet. */
  double repeatedCorner = 1.0;

  /** Which cells touch is right before all else. */
  static PlacePreferences
  WallsFirst()
  {
    return {};
  }

  /** Which four cells meet is right before all else. The image asks for corners of cells that do not all touch, and
   * each two of them need a false wall: below a weight of 1 they are worth it, whatever the weight, above 1 never.
   * Likewise one more group of four that meets is worth a corner too many of another group that does, for any weight
   * of the latter below 1. But two walls and a corner too many must cost more than 1 together: else every group that
   * is missing is put between two copies of a wall, as often as not where it means nothing. */
  static PlacePreferences
  JunctionsFirst()
  {
    return { 0.5, 1, 0.7, 0.75 };
  }

  /** For votes, which know corners better than an image that is an estimate itself knows walls. Corners are asked for
   * more than an even chance, and thereby walls not to be crowded: each false one makes several. Weights of .2 to .4
   * and votes of .6 to .8 are within .002 of each other in adjacency4 on the mean of six tissues. */
  static PlacePreferences
  ByVotes()
  {
    return { 0.3, 10, 0.7 };
  }
};

/** \brief The number of walls and corners that a complex has more or fewer than the image, the walls weighted.
 *
 * By cells: of two cells that have two walls in the image the complex should have two edges, of four cells that meet at
 * two places two tetrahedra. The energy is the sum of all absolute differences.
 *
 * Where there are votes on corners (TissueVotes.h), as for an image that is an estimate, they take the place of the
 * image's corners: a tetrahedron costs the preferences' least vote, less the share of the votes for its four cells if
 * it is the first of these. */
class PlaceEnergy
{
public:
  /** \param votes on quadruples of ascending cells, each once; none: the corners of the image count. */
  PlaceEnergy(const TissuePlaces & places, const PlacePreferences & preferences, const GeneralComplex & complex,
              const std::vector<JunctionVote> & votes = {});

  /** By how much a move of the complex would change the energy. */
  double
  Difference(const GeneralComplex & complex, const GeneralMove & move) const;

  /** Keeps the counts up to date; to be called before the move is applied. */
  void
  Account(const GeneralComplex & complex, const GeneralMove & move);

  /** From the counts, in O(their number). */
  double
  Total() const;

  /** \name What one edge or tetrahedron more or fewer of these vertices, in any order, would cost.
   *
   * The energy is convex in each number: what a move costs is never less than the sum of what its parts would cost one
   * by one. So a move whose parts cost too much need not be made to be judged.
   * @{ */
  double
  CostOfEdge(VertexId u, VertexId v) const;

  double
  CostOfTetrahedron(const VertexQuadruple & vertices) const;

  double
  CostWithoutEdge(VertexId u, VertexId v) const;

  double
  CostWithoutTetrahedron(const VertexQuadruple & vertices) const;

  /** The same by the index among the corners' counts. */
  double
  CostWithoutTetrahedron(std::int32_t index) const
  {
    return this->ChangeOfEnergy(m_Corners.GetEntries()[static_cast<std::size_t>(index)], -1);
  }
  /** @} */

  /** Where the counts of a tetrahedron that is, or was, in the complex are, now and later. */
  std::int32_t
  IndexOfTetrahedron(const VertexQuadruple & vertices) const;

  /** What a wall costs in corners. */
  double
  GetWallWeight() const
  {
    return m_WallWeight;
  }

  const TupleCounts<2> &
  GetWalls() const
  {
    return m_Walls;
  }
  const TupleCounts<4> &
  GetCorners() const
  {
    return m_Corners;
  }

private:
  double
  EnergyOf(const TupleCounts<2>::Entry & wall, std::int32_t number) const
  {
    return m_WallWeight * std::abs(number - wall.wanted);
  }

  double
  EnergyOf(const TupleCounts<4>::Entry & corner, std::int32_t number) const
  {
    if (m_HasVotes)
    {
      return m_LeastVote * number - (number > 0 ? corner.share : 0.0F);
    }
    const double repeated = m_RepeatedCorner * std::abs(number - corner.wanted);
    return corner.wanted == 0 ? number : number > 0 ? repeated : repeated + 1.0 - m_RepeatedCorner;
  }

  template <typename TEntry>
  double
  ChangeOfEnergy(const TEntry & entry, std::int32_t change) const
  {
    return this->EnergyOf(entry, entry.present + change) - this->EnergyOf(entry, entry.present);
  }

  double         m_WallWeight;
  double         m_LeastVote;
  double         m_RepeatedCorner;
  bool           m_HasVotes;
  TupleCounts<2> m_Walls;
  TupleCounts<4> m_Corners;
};
} // namespace tissue

#endif
