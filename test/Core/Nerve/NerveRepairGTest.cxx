/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnFragments.h"
#include "Nerve/NerveRepair.h"
#include "Nerve/PlaceDescent.h"
#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <set>

using namespace testing_nerve;

namespace
{
struct Repaired
{
  ImageNerve                     nerve;
  TissuePlaces                   places;
  std::vector<NerveRepairRecord> records;
};

Repaired
RepairedNerveOf(const LabelVolume & volume)
{
  Repaired repaired{ NerveOf(volume),
                     { FindImageWalls(volume), FindCornerPlaces(volume, FindCrowdedBlocks(volume)) },
                     {} };
  repaired.records = Repair(repaired.nerve, repaired.places);
  return repaired;
}

std::set<RepairKind>
KindsOf(const std::vector<NerveRepairRecord> & records)
{
  std::set<RepairKind> kinds;
  for (const NerveRepairRecord & record : records)
  {
    kinds.insert(record.kind);
  }
  return kinds;
}

/** Two tetrahedra glued along all their triangles, added to a complex. */
void
AddPillow(GeneralComplex & complex, const VertexQuadruple & t)
{
  const TetrahedronId first = complex.Add(t);
  complex.Add({ { t[1], t[0], t[2], t[3] } });
  for (int i = 0; i < 4; ++i)
  {
    complex.Glue({ first, i }, { first + 1, i == 0 ? 1 : i == 1 ? 0 : i });
  }
}

ImageNerve
Nerve(VertexId numberOfVertices, const std::vector<VertexQuadruple> & pillows)
{
  ImageNerve nerve{ GeneralComplex(numberOfVertices), {}, {} };
  for (const VertexQuadruple & t : pillows)
  {
    AddPillow(nerve.complex, t);
  }
  return nerve;
}
} // namespace

TEST(NerveRepair, LeavesASoundNerveAsItIs)
{
  const LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  const Repaired    repaired = RepairedNerveOf(volume);
  EXPECT_TRUE(repaired.records.empty());
  EXPECT_EQ(Dump(repaired.nerve.complex), Dump(NerveOf(volume).complex));
}

TEST(NerveRepair, DropsThePartThatHasNoVertexOfItsOwn)
{
  ImageNerve nerve = Nerve(6, { { { 0, 1, 2, 3 } }, { { 1, 2, 3, 4 } }, { { 0, 2, 4, 5 } } });
  const auto records = Repair(nerve, {});
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(records[0].kind, RepairKind::PartDropped);
  EXPECT_TRUE(FindViolations(nerve.complex).empty()) << FindViolations(nerve.complex).front();
}

TEST(NerveRepair, JoinsPartsAtTheExterior)
{
  ImageNerve nerve = Nerve(6, { { { 0, 1, 2, 3 } }, { { 0, 1, 4, 5 } } });
  const auto records = Repair(nerve, {});
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].kind, RepairKind::JoinedAtExterior);
  EXPECT_EQ(records[0].vertex, 1);
  EXPECT_TRUE(FindViolations(nerve.complex).empty()) << FindViolations(nerve.complex).front();
}

TEST(NerveRepair, JoinsPartsAtACellThatIsSplitAsWell)
{
  ImageNerve nerve = Nerve(6, { { { 0, 1, 2, 3 } }, { { 1, 2, 4, 5 } } });
  const auto records = Repair(nerve, {});
  ASSERT_EQ(records.size(), 1u) << "cells 1 and 2 are whole by one move";
  EXPECT_EQ(records[0].kind, RepairKind::JoinedAtCell);
  EXPECT_TRUE(FindViolations(nerve.complex).empty()) << FindViolations(nerve.complex).front();
}

TEST(NerveRepair, BridgesPartsWithOneCellInCommon)
{
  ImageNerve nerve = Nerve(7, { { { 0, 1, 2, 3 } }, { { 1, 4, 5, 6 } } });
  const auto records = Repair(nerve, {});
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].kind, RepairKind::Bridged);
  EXPECT_TRUE(FindViolations(nerve.complex).empty()) << FindViolations(nerve.complex).front();
}

TEST(NerveRepair, CutsTheHandleOfALink)
{
  // Two edges (1, 3) of one link, joined: the links of both ends have a handle.
  ImageNerve nerve = Nerve(6, { { { 1, 2, 4, 3 } } });
  nerve.complex.Apply(InsertPillow(nerve.complex, { 0, 0 }, 5).move);
  nerve.complex.Apply(InsertPillow(nerve.complex, { 0, 1 }, 0).move);
  const auto edgesOf = [&] {
    std::vector<LocalEdge> edges;
    for (const auto & edge : nerve.complex.FindEdges())
    {
      if (edge.vertices == VertexPair{ { 1, 3 } })
      {
        edges.push_back(edge.local);
      }
    }
    return edges;
  };
  const EdgeRing ring = nerve.complex.GetRing(edgesOf()[0]);
  nerve.complex.Apply(SplitEdge(nerve.complex, ring, 0, 1).move);
  const EdgeRing first = nerve.complex.GetRing(edgesOf()[0]);
  const EdgeRing second = nerve.complex.GetRing(edgesOf()[1]);
  const bool     isSame = nerve.complex.GetRingVertices(first)[0] == nerve.complex.GetRingVertices(second)[0];
  nerve.complex.Apply(JoinEdges(nerve.complex, first, 0, second, isSame ? 1 : 0).move);
  ASSERT_EQ(FindViolations(nerve.complex).size(), 2u);
  EXPECT_EQ(EulerCharacteristics(nerve.complex)[1], std::vector<std::int32_t>{ 0 });
  const auto records = Repair(nerve, {});
  EXPECT_EQ(records[0].kind, RepairKind::HandleCut);
  EXPECT_TRUE(FindViolations(nerve.complex).empty()) << FindViolations(nerve.complex).front();
}

TEST(NerveRepair, OfABarThroughAirGivesTheExteriorTheHandleThatItHasInTheImage)
{
  // Two blocks of bricks and a bar between them, all of one cell, around which the air goes.
  LabelVolume        block = Bricks({ { 3, 3, 2 } }, 6);
  const auto         half = NumberOfVertices(block) - 1;
  const std::int32_t width = block.size[0];
  const LabelVolume  volume = MakeImage(
    { { 2 * width, block.size[1], block.size[2] } }, [&](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
      const bool     isSecond = x >= width;
      const VertexId v = block.At(isSecond ? 2 * width - 1 - x : x, y, z);
      const VertexId at = v == 0 ? 0 : v + (isSecond ? half : 0);
      const bool     isBar = v == 0 && x > 15 && x < 2 * width - 16 && y > 13 && y < 17 && z > 7 && z < 11;
      // The cells at the two ends of the bar are one with it.
      const VertexId end = block.At(23, 15, 9);
      return isBar || v == end ? end : at;
    });
  const Repaired repaired = RepairedNerveOf(volume);
  EXPECT_EQ(KindsOf(repaired.records), std::set<RepairKind>{ RepairKind::JoinedAtExterior });
  for (const auto & violation : FindViolations(repaired.nerve.complex))
  {
    EXPECT_NE(violation.find("is in no tetrahedron"), std::string::npos) << violation;
  }
}

TEST(NerveRepair, PutsNestedCellsIntoTrianglesOfTheirNeighbours)
{
  LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  const auto  vertices = NumberOfVertices(volume);
  volume.vertices.Put(static_cast<std::size_t>((9 * volume.size[1] + 15) * volume.size[0] + 15), vertices);
  const Repaired repaired = RepairedNerveOf(volume);
  ASSERT_EQ(repaired.records.size(), 1u);
  EXPECT_EQ(repaired.records[0].kind, RepairKind::PutIntoTriangle);
  EXPECT_EQ(repaired.records[0].vertex, vertices);
  EXPECT_TRUE(FindViolations(repaired.nerve.complex).empty());
  auto edges = CountEdges(repaired.nerve.complex);
  EXPECT_EQ((edges[{ { volume.At(14, 15, 9), vertices } }]), 1) << "to the cell around it";
}

TEST(NerveRepair, SaysWhatHasNoComplexAtAll)
{
  const LabelVolume volume =
    MakeImage({ { 4, 2, 2 } }, [](std::int32_t x, std::int32_t, std::int32_t) { return VertexId{ 1 + x / 2 }; });
  const Repaired repaired = RepairedNerveOf(volume);
  ASSERT_EQ(repaired.records.size(), 2u);
  EXPECT_EQ(repaired.records[0].kind, RepairKind::NotRepaired);
}

TEST(NerveRepair, OfNoiseLeavesHardlyAHandle)
{
  int                  handles = 0;
  int                  repairs = 0;
  std::set<RepairKind> met;
  for (std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    const auto  edge = static_cast<std::int32_t>(3 + seed % 8);
    LabelVolume volume = Noise({ { edge, edge, edge } }, static_cast<VertexId>(5 + seed % 37), seed);
    const auto  fragments = FindFragments(volume, NumberOfVertices(volume), seed % 2 ? 2 : 1000);
    Relabel(volume, fragments.ofLarge);
    Relabel(volume, fragments.ofSmall);
    Repaired repaired = RepairedNerveOf(volume);
    repairs += static_cast<int>(repaired.records.size());
    Descend(repaired.nerve.complex, repaired.places, PlacePreferences::WallsFirst());
    const auto kinds = KindsOf(repaired.records);
    met.insert(kinds.begin(), kinds.end());
    for (const std::string & violation : FindViolations(repaired.nerve.complex))
    {
      const bool isHandle = violation.find("is no sphere") != std::string::npos;
      handles += isHandle ? 1 : 0;
      EXPECT_TRUE(isHandle || violation.find("is in no tetrahedron") != std::string::npos) << seed << ": " << violation;
    }
    EXPECT_TRUE(kinds.count(RepairKind::NotRepaired) == 0 || repaired.nerve.complex.NumberOfTetrahedra() == 0) << seed;
  }
  EXPECT_GT(repairs, 100);
  EXPECT_EQ(met.count(RepairKind::JoinedAtExterior), 1u);
  EXPECT_EQ(met.count(RepairKind::PutIntoTriangle), 1u);
  EXPECT_LT(handles, 3) << "of cells that are rings";
}

TEST(NerveRepair, JoinsCellsInManyPiecesInAllItsWays)
{
  std::set<RepairKind> met;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    // Cells of some six voxels, most of them in several pieces, which are left as they are.
    LabelVolume volume = Noise({ { 8, 8, 8 } }, 80, seed);
    for (std::size_t i = 0; i < volume.vertices.size(); ++i)
    {
      volume.vertices.Put(i, volume.vertices[i] + 1);
    }
    const Repaired repaired = RepairedNerveOf(volume);
    const auto     kinds = KindsOf(repaired.records);
    met.insert(kinds.begin(), kinds.end());
    for (const std::string & violation : FindViolations(repaired.nerve.complex))
    {
      EXPECT_EQ(violation.find("split"), std::string::npos) << violation;
      EXPECT_EQ(violation.find("neighbour"), std::string::npos) << violation;
    }
  }
  for (const RepairKind kind : { RepairKind::JoinedAtExterior,
                                 RepairKind::JoinedAtCell,
                                 RepairKind::GluedCrosswise,
                                 RepairKind::FalseDigon,
                                 RepairKind::Bridged })
  {
    EXPECT_EQ(met.count(kind), 1u) << ToString(kind);
  }
}
