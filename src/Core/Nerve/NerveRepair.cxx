/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/NerveRepair.h"

#include "Nerve/LinkJoin.h"
#include "Nerve/LinkLoop.h"
#include "Nerve/VertexLinks.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace tissue
{
namespace
{
/** The tetrahedra of each connected part of the complex, the smallest part first. */
std::vector<std::vector<TetrahedronId>>
FindParts(const GeneralComplex & complex)
{
  DisjointSets sets(static_cast<std::size_t>(complex.TetrahedronIdBound()));
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      sets.Unite(id, complex.GetTetrahedron(id).neighbors[i]);
    }
  }
  std::map<std::int64_t, std::vector<TetrahedronId>> ofRoot;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      ofRoot[sets.Find(id)].push_back(id);
    }
  }
  std::vector<std::vector<TetrahedronId>> parts;
  for (auto & part : ofRoot)
  {
    parts.push_back(std::move(part.second));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto & a, const auto & b) { return a.size() < b.size(); });
  return parts;
}

std::set<VertexId>
VerticesOf(const GeneralComplex & complex, const std::vector<TetrahedronId> & part)
{
  std::set<VertexId> vertices;
  for (const TetrahedronId id : part)
  {
    const VertexQuadruple & t = complex.GetTetrahedron(id).vertices;
    vertices.insert(t.begin(), t.end());
  }
  return vertices;
}

/** Drops the parts that have no vertex of their own. */
void
DropParts(GeneralComplex & complex, std::vector<NerveRepairRecord> & records)
{
  const auto parts = FindParts(complex);
  if (parts.size() < 2)
  {
    return;
  }
  std::vector<int> numberOfParts(static_cast<std::size_t>(complex.NumberOfVertices()), 0);
  for (const auto & part : parts)
  {
    for (const VertexId v : VerticesOf(complex, part))
    {
      ++numberOfParts[v];
    }
  }
  for (const auto & part : parts)
  {
    const auto vertices = VerticesOf(complex, part);
    if (std::all_of(
          vertices.begin(), vertices.end(), [&](VertexId v) { return numberOfParts[v] > 1 || complex.IsOutside(v); }))
    {
      for (const VertexId v : vertices)
      {
        --numberOfParts[v];
      }
      complex.Remove(part);
      records.push_back({ RepairKind::PartDropped, *vertices.begin(), *vertices.begin() });
    }
  }
}

/** Joins the links of each cell that has several. */
void
JoinLinks(GeneralComplex & complex, const TissuePlaces & places, std::vector<NerveRepairRecord> & records)
{
  const VertexLinks     links = FindVertexLinks(complex);
  std::vector<VertexId> split;
  for (VertexId v = 1; v < complex.NumberOfVertices(); ++v)
  {
    if (!complex.IsOutside(v) && links.NumberOfLinks(v) > 1)
    {
      split.push_back(v);
    }
  }
  if (split.empty())
  {
    return;
  }
  LinkJoin join(complex, links, places);
  for (const VertexId v : split)
  {
    while (join.NumberOfLinks(v) > 1)
    {
      records.push_back(join.Step(v));
      if (records.back().kind == RepairKind::NotRepaired)
      {
        break;
      }
    }
  }
}

/** How far the links of the cells are from spheres: handles, and links too many. */
std::int64_t
CountFaults(const GeneralComplex & complex, const VertexLinks & links)
{
  std::int64_t faults = 0;
  for (std::size_t i = 0; i < links.links.size(); ++i)
  {
    const VertexLink & link = links.links[i];
    if (!complex.IsOutside(link.vertex))
    {
      faults += (2 - link.eulerCharacteristic) / 2 + (i > links.firstOfVertex[link.vertex] ? 1 : 0);
    }
  }
  return faults;
}

/** Cuts a handle of the link, if that leaves the links of all other cells as good as they are. */
bool
CutHandle(GeneralComplex & complex, const VertexLink & link, std::int64_t faults)
{
  const Side apex{ link.first, LocalIndex(complex.GetTetrahedron(link.first).vertices, link.vertex) };
  LinkLoop   loop = FindHandleLoop(complex, LinkSurface(complex, apex));
  for (std::size_t turn = 0; turn < loop.vertices.size(); ++turn)
  {
    // Any vertex of the loop may be that of the fan.
    std::rotate(loop.vertices.begin(), loop.vertices.begin() + 1, loop.vertices.end());
    std::rotate(loop.triangles.begin(), loop.triangles.begin() + 1, loop.triangles.end());
    const MoveProposal proposal = CutAlongLoop(complex, link.vertex, loop.triangles, loop.vertices);
    if (!proposal)
    {
      continue;
    }
    const GeneralMove inverse = complex.Apply(proposal.move);
    if (CountFaults(complex, FindVertexLinks(complex)) < faults)
    {
      return true;
    }
    complex.Apply(inverse);
  }
  return false;
}

/** Cuts the handles of cells' links, one after the other. */
void
CutHandles(GeneralComplex & complex, std::vector<NerveRepairRecord> & records)
{
  bool hasCut = true;
  while (hasCut)
  {
    hasCut = false;
    const VertexLinks links = FindVertexLinks(complex);
    for (const VertexLink & link : links.links)
    {
      if (!complex.IsOutside(link.vertex) && link.eulerCharacteristic < 2 &&
          CutHandle(complex, link, CountFaults(complex, links)))
      {
        records.push_back({ RepairKind::HandleCut, link.vertex, link.vertex });
        hasCut = true;
        break;
      }
    }
  }
}

/** A triangle for a cell without corners: how many of the cell's neighbours it has, then how near it is. */
struct Fit
{
  Side   triangle;
  int    numberOfNeighbors = 0;
  double distance = 0.0;

  bool
  IsBetterThan(const Fit & other) const
  {
    return numberOfNeighbors != other.numberOfNeighbors ? numberOfNeighbors > other.numberOfNeighbors
                                                        : distance < other.distance;
  }
};

/** The cells without corners, each with its walls. */
using AbsentCells = std::map<VertexId, std::vector<const ImageWall *>>;

AbsentCells
FindAbsent(const GeneralComplex & complex, const TissuePlaces & places)
{
  std::vector<bool> isPresent(static_cast<std::size_t>(complex.NumberOfVertices()), false);
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      isPresent[complex.GetTetrahedron(id).vertices[i]] = true;
    }
  }
  AbsentCells absent;
  for (const ImageWall & wall : places.walls)
  {
    for (const VertexId v : wall.cells)
    {
      if (!isPresent[v] && !complex.IsOutside(v))
      {
        absent[v].push_back(&wall);
      }
    }
  }
  return absent;
}

/** The best triangle that has a neighbour of the cell; none, with no neighbours, where the complex has no such. */
Fit
FindTriangle(const ImageNerve & nerve, VertexId cell, const std::vector<const ImageWall *> & walls)
{
  Point              center{ { 0.0, 0.0, 0.0 } };
  std::set<VertexId> neighbors;
  for (const ImageWall * wall : walls)
  {
    center = center + (1.0 / static_cast<double>(walls.size())) * wall->center;
    neighbors.insert(wall->cells[0] == cell ? wall->cells[1] : wall->cells[0]);
  }
  Fit best;
  for (TetrahedronId id = 0; id < nerve.complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; nerve.complex.IsAlive(id) && i < 4; ++i)
    {
      const auto & t = nerve.complex.GetTetrahedron(id);
      Fit          fit{ { id, i }, 0, 0.0 };
      for (int j = 0; j < 4; ++j)
      {
        fit.numberOfNeighbors += j != i && neighbors.count(t.vertices[j]) != 0 ? 1 : 0;
      }
      // A triangle that a repair has made has no place: it comes last.
      fit.distance = t.lines[i] == NoPlace ? std::numeric_limits<double>::max()
                                           : Distance(center, nerve.lines[static_cast<std::size_t>(t.lines[i])].middle);
      if (fit.numberOfNeighbors > 0 && fit.IsBetterThan(best))
      {
        best = fit;
      }
    }
  }
  return best;
}

/** Puts in the cells without corners; those whose neighbours are all without corners wait for them. */
void
AddAbsent(ImageNerve & nerve, const TissuePlaces & places, std::vector<NerveRepairRecord> & records)
{
  AbsentCells absent = FindAbsent(nerve.complex, places);
  bool        hasAdded = true;
  while (hasAdded)
  {
    hasAdded = false;
    for (auto it = absent.begin(); it != absent.end();)
    {
      const Fit fit = FindTriangle(nerve, it->first, it->second);
      if (fit.numberOfNeighbors == 0)
      {
        ++it;
        continue;
      }
      const VertexId partner =
        nerve.complex.GetTetrahedron(fit.triangle.tetrahedron).vertices[fit.triangle.opposite == 0 ? 1 : 0];
      nerve.complex.Apply(InsertPillow(nerve.complex, fit.triangle, it->first).move);
      records.push_back({ RepairKind::PutIntoTriangle, it->first, partner });
      it = absent.erase(it);
      hasAdded = true;
    }
  }
  for (const auto & cell : absent)
  {
    records.push_back({ RepairKind::NotRepaired, cell.first, cell.first });
  }
}
} // namespace

const char *
ToString(RepairKind kind)
{
  switch (kind)
  {
    case RepairKind::PartDropped:
      return "a part of the complex was dropped";
    case RepairKind::JoinedAtExterior:
      return "two links were joined at the exterior";
    case RepairKind::JoinedAtCell:
      return "two links were joined at a cell";
    case RepairKind::GluedCrosswise:
      return "two triangles were glued crosswise";
    case RepairKind::FalseDigon:
      return "a false wall brought two links nearer";
    case RepairKind::Bridged:
      return "two links were bridged by three false walls";
    case RepairKind::HandleCut:
      return "a handle of a link was cut";
    case RepairKind::PutIntoTriangle:
      return "a cell without corners was put into a triangle";
    case RepairKind::NotRepaired:
      return "not repaired";
  }
  return "unknown";
}

std::vector<NerveRepairRecord>
Repair(ImageNerve & nerve, const TissuePlaces & places)
{
  std::vector<NerveRepairRecord> records;
  DropParts(nerve.complex, records);
  JoinLinks(nerve.complex, places, records);
  CutHandles(nerve.complex, records);
  // Where two handles go at once the link of a third cell may be split: that is the lesser fault.
  JoinLinks(nerve.complex, places, records);
  AddAbsent(nerve, places, records);
  return records;
}
} // namespace tissue
