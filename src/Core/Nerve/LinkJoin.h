/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LinkJoin_h
#define TissueTessellationCore_LinkJoin_h

#include "Nerve/GeneralMoves.h"
#include "Nerve/LinkSurface.h"
#include "Nerve/NerveRepair.h"
#include "Nerve/PlaceEnergy.h"
#include "Nerve/VertexLinks.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

namespace tissue
{
/** \brief Joins the links of cells that have several, move by move.
 *
 * Keeps account of which links have become one, so that none need be found anew. Of the possible places of a move the
 * one that costs the least by the image's places is taken. */
class LinkJoin
{
public:
  /** \param links those of the complex as it is. All must outlive this object but the places. */
  LinkJoin(GeneralComplex & complex, const VertexLinks & links, const TissuePlaces & places);

  std::size_t
  NumberOfLinks(VertexId v)
  {
    return this->RootsOf(v).size();
  }

  /** One move towards one link less of a cell that has several. */
  NerveRepairRecord
  Step(VertexId v);

private:
  /** A move that is possible, and what it costs. */
  struct Choice
  {
    GeneralMove move;
    double      cost;
    VertexId    partner;
  };

  std::vector<std::int64_t>
  RootsOf(VertexId v);

  /** Edges of a vertex, each next to the one before in its link. */
  using Path = std::vector<LocalEdge>;

  /** In the link of a neighbour, the shortest path from a link of v to another one of v; empty where there is none. */
  Path
  FindPath(VertexId v, std::int64_t own, const LinkSurface & surface);

  bool
  JoinAtEdges(bool isExterior);

  bool
  GlueCrosswise(VertexId v);

  bool
  MakeDigon(VertexId v);

  bool
  Bridge(VertexId v);

  void
  ConsiderJoin(const LocalEdge & first, const LocalEdge & second, VertexId partner);

  void
  Consider(const MoveProposal & proposal, double cost, VertexId partner);

  /** Two tetrahedra that are glued have the links of their three common vertices in common: what is not known of the
   * one is that of the other, and where both are known they have become one. */
  void
  Meet(const Side & a, const Side & b);

  /** Carries out the best of the choices, if there is one. */
  bool
  Carry();

  std::int64_t
  LinkOf(TetrahedronId id, int local)
  {
    return m_Sets.Find(m_LinkOf[static_cast<std::size_t>(id)][static_cast<std::size_t>(local)]);
  }

  /** The link at an edge's other end. */
  std::int64_t
  LinkAtEnd(const LocalEdge & edge)
  {
    return this->LinkOf(edge.tetrahedron, edge.to);
  }

  VertexId
  EndOf(const LocalEdge & edge) const
  {
    return m_Complex.GetTetrahedron(edge.tetrahedron).vertices[edge.to];
  }

  GeneralComplex &                         m_Complex;
  const VertexLinks &                      m_Links;
  PlaceEnergy                              m_Energy;
  std::vector<std::array<std::int32_t, 4>> m_LinkOf;
  DisjointSets                             m_Sets;
  /** The surfaces of the cell in hand, the largest first. */
  std::vector<LinkSurface> m_Surfaces;
  std::vector<Choice>      m_Best;
  int                      m_NumberOfProposals = 0;
};
} // namespace tissue

#endif
