/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"
#include "RunBackwards.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace testing_nerve;

namespace
{
/** The violations but those of vertices that have no corner, or links that the image itself splits. */
void
ExpectGluedThroughout(const GeneralComplex & complex)
{
  for (const std::string & violation : FindViolations(complex))
  {
    EXPECT_NE(violation.find("vertex"), std::string::npos) << violation;
    EXPECT_EQ(violation.find("neighbour"), std::string::npos) << violation;
  }
}

/** Every region's boundary in the image is what its link is in the nerve. */
void
ExpectLinksOfImage(const LabelVolume & volume, const GeneralComplex & complex)
{
  const auto characteristics = EulerCharacteristics(complex);
  for (VertexId v = 0; v < complex.NumberOfVertices(); ++v)
  {
    std::int32_t sum = 0;
    for (const std::int32_t c : characteristics[v])
    {
      sum += c;
    }
    EXPECT_EQ(sum, BoundaryEulerCharacteristic(volume, v)) << "vertex " << v;
  }
}

/** A ring of cells: around the vertical axis `around` of them, in the ring's section 2x2. */
LabelVolume
Torus(int around)
{
  return MakeImage({ { 48, 48, 24 } }, [=](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const double dx = x - 23.7;
    const double dy = y - 23.6;
    const double dz = z - 11.8;
    const double r = std::hypot(dx, dy) - 15.2;
    if (std::hypot(r, dz) > 7.1)
    {
      return ExteriorVertex;
    }
    const double turn = std::atan2(dy, dx) / 6.283185307179586 + 0.5;
    // The sections are staggered, so that no more than four cells meet.
    const int quarter = (dz > 0.0 ? 2 : 0) + ((dz > 0.0 ? r > 1.1 : r > -1.2) ? 1 : 0);
    const int section = static_cast<int>(turn * around + 0.25 * quarter) % around;
    return 1 + 4 * section + quarter;
  });
}

/** Two balls and the film between, in the exterior, and a third one between the two of them and it. */
LabelVolume
Bubbles(int count)
{
  return MakeImage({ { 30, 30, 30 } }, [=](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    VertexId nearest = 0;
    double   least = 8.3;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 6.283185307179586 * i / count + 0.1;
      const double d = std::hypot(x - 14.6 - 5.0 * std::cos(angle), y - 14.7 - 5.0 * std::sin(angle), z - 14.5);
      if (d < least)
      {
        nearest = 1 + i;
        least = d;
      }
    }
    return nearest;
  });
}
} // namespace

TEST(KuhnSimplex, PivotIsItsOwnInverseAndKeepsTheOrder)
{
  for (int first = 0; first < 3; ++first)
  {
    for (int second = 0; second < 3; ++second)
    {
      if (first == second)
      {
        continue;
      }
      const KuhnSimplex start = KuhnSimplex::FromWay({ { 3, 4, 5 } }, first, second);
      const auto        key = start.GetKey();
      EXPECT_EQ(key.base, (VoxelIndex{ { 3, 4, 5 } }));
      EXPECT_EQ(key.first, first);
      EXPECT_EQ(key.second, second);
      for (int i = 0; i < 4; ++i)
      {
        KuhnSimplex other = start;
        other.Pivot(i);
        const auto        there = other.GetKey();
        const KuhnSimplex again = KuhnSimplex::FromWay(there.base, there.first, there.second);
        for (const VoxelIndex & voxel : again.voxels)
        {
          EXPECT_EQ(std::count(other.voxels.begin(), other.voxels.end(), voxel), 1);
        }
        other.Pivot(i);
        EXPECT_EQ(other.voxels, start.voxels);
      }
    }
  }
}

TEST(ImageNerve, OfTwoLayersOfBricksIsASphere)
{
  const LabelVolume volume = Bricks({ { 4, 4, 2 } }, 6);
  const ImageNerve  nerve = NerveOf(volume);
  const auto        violations = FindViolations(nerve.complex);
  EXPECT_TRUE(violations.empty()) << violations.front();
  EXPECT_EQ(EulerCharacteristics(nerve.complex)[0], std::vector<std::int32_t>{ 2 });
  ExpectLinksOfImage(volume, nerve.complex);
}

TEST(ImageNerve, OfCubesWithEightAtACornerIsASphereToo)
{
  const LabelVolume volume = Bricks({ { 3, 3, 3 } }, 4, false);
  const ImageNerve  nerve = NerveOf(volume);
  const auto        violations = FindViolations(nerve.complex);
  EXPECT_TRUE(violations.empty()) << violations.front();
  ExpectLinksOfImage(volume, nerve.complex);
}

TEST(ImageNerve, OfASheetHasTwoWallsToTheExterior)
{
  const LabelVolume volume = Bricks({ { 4, 4, 1 } }, 6);
  const ImageNerve  nerve = NerveOf(volume);
  EXPECT_TRUE(FindViolations(nerve.complex).empty());
  auto count = CountEdges(nerve.complex);
  for (const VertexId inner : { 6, 7, 10, 11 })
  {
    EXPECT_EQ((count[{ { 0, inner } }]), 2) << inner;
  }
  EXPECT_EQ((count[{ { 0, 1 } }]), 1) << "at the rim top and bottom are one wall";
  ExpectLinksOfImage(volume, nerve.complex);
}

TEST(ImageNerve, OfATorusGivesTheExteriorAHandle)
{
  const LabelVolume volume = Torus(5);
  const ImageNerve  nerve = NerveOf(volume);
  const auto        violations = FindViolations(nerve.complex);
  EXPECT_TRUE(violations.empty()) << violations.front();
  EXPECT_EQ(EulerCharacteristics(nerve.complex)[0], std::vector<std::int32_t>{ 0 });
  ExpectLinksOfImage(volume, nerve.complex);
}

TEST(ImageNerve, OfAShellGivesTheExteriorTwoLinks)
{
  LabelVolume volume = Bricks({ { 3, 3, 3 } }, 5, false);
  volume.vertices.Replace(14, ExteriorVertex);
  const ImageNerve nerve = NerveOf(volume);
  const auto       characteristics = EulerCharacteristics(nerve.complex);
  EXPECT_EQ(characteristics[0], (std::vector<std::int32_t>{ 2, 2 }));
  EXPECT_EQ(FindViolations(nerve.complex), std::vector<std::string>{ "vertex 14 is in no tetrahedron" });
}

TEST(ImageNerve, OfThreeBubblesIsTwoTetrahedra)
{
  const ImageNerve nerve = NerveOf(Bubbles(3));
  EXPECT_EQ(nerve.complex.NumberOfTetrahedra(), 2u);
  EXPECT_EQ(nerve.lines.size(), 4u);
  EXPECT_TRUE(FindViolations(nerve.complex).empty());
  // The axis in which the three meet runs from corner to corner, straight.
  for (int i = 0; i < 4; ++i)
  {
    const auto & t = nerve.complex.GetTetrahedron(0);
    if (t.vertices[i] == ExteriorVertex)
    {
      const ImageLine & line = nerve.lines[static_cast<std::size_t>(t.lines[i])];
      const double      distance = Distance(nerve.corners[0], nerve.corners[1]);
      EXPECT_NEAR(line.length, distance, 2.0);
      EXPECT_LT(Distance(line.middle, 0.5 * (nerve.corners[0] + nerve.corners[1])), 1.5);
    }
  }
}

TEST(ImageNerve, OfTwoBubblesIsEmptyAndSaysSo)
{
  const auto violations = FindViolations(NerveOf(Bubbles(2)).complex);
  EXPECT_EQ(violations.size(), 3u) << "no vertex has a corner";
}

TEST(ImageNerve, KeepsTwoWallsBetweenTwoCells)
{
  // A bar through the wall between two boxes: they touch on both sides of it.
  const LabelVolume volume =
    MakeImage({ { 20, 12, 12 } }, [](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
      if (x < 2 || x > 17 || y < 1 || y > 10 || z < 1 || z > 10)
      {
        return ExteriorVertex;
      }
      return x > 7 && x < 12 && y > 3 && y < 7 ? 3 : x < 10 ? 1 : 2;
    });
  const ImageNerve nerve = NerveOf(volume);
  EXPECT_TRUE(FindViolations(nerve.complex).empty());
  EXPECT_EQ((CountEdges(nerve.complex)[{ { 1, 2 } }]), 2);
  EXPECT_EQ((CountEdges(nerve.complex)[{ { 0, 3 } }]), 2);
  ExpectLinksOfImage(volume, nerve.complex);
}

TEST(ImageNerve, OfANestedCellHasNoCornerOfIt)
{
  LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  const auto  vertices = NumberOfVertices(volume);
  volume.vertices.Put(static_cast<std::size_t>((9 * volume.size[1] + 15) * volume.size[0] + 15), vertices);
  EXPECT_EQ(FindViolations(NerveOf(volume).complex),
            std::vector<std::string>{ "vertex " + std::to_string(vertices) + " is in no tetrahedron" });
}

TEST(ImageNerve, OfNoiseIsGluedThroughout)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    const auto       size = static_cast<std::int32_t>(1 + seed % 9);
    const ImageNerve nerve = NerveOf(Noise({ { size, 6, 5 } }, static_cast<VertexId>(3 + seed % 20), seed));
    ExpectGluedThroughout(nerve.complex);
    EXPECT_EQ(2 * nerve.lines.size(), 4 * nerve.complex.NumberOfTetrahedra());
  }
}

TEST(ImageNerve, IsTheSameForAnyOrderOfTheLoops)
{
  const Execution   backwards(tissue_test::RunBackwards);
  const LabelVolume volume = Torus(6);
  const auto        blocks = FindCrowdedBlocks(volume, backwards);
  const ImageNerve  nerve = MakeImageNerve(volume, NumberOfVertices(volume), blocks, backwards);
  const ImageNerve  other = NerveOf(volume);
  EXPECT_EQ(Dump(nerve.complex), Dump(other.complex));
  EXPECT_EQ(nerve.corners, other.corners);
}

TEST(ImageNerve, IsOrientedAlikeInMirroredAxes)
{
  LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  volume.steps[0] = { { -0.5, 0.0, 0.0 } };
  const ImageNerve nerve = NerveOf(volume);
  EXPECT_TRUE(FindViolations(nerve.complex).empty());
  // Of a corner whose place is clear: the signed volume of the centres of four bricks that meet.
  int                positive = 0;
  std::vector<Point> sums(static_cast<std::size_t>(NumberOfVertices(volume)), Point{ { 0.0, 0.0, 0.0 } });
  std::vector<int>   counts(sums.size(), 0);
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < volume.size[0]; ++x)
      {
        const auto v = static_cast<std::size_t>(volume.At(x, y, z));
        sums[v] = sums[v] + volume.ToPhysical({ { double(x), double(y), double(z) } });
        ++counts[v];
      }
    }
  }
  int all = 0;
  for (TetrahedronId id = 0; id < nerve.complex.TetrahedronIdBound(); ++id)
  {
    const auto & t = nerve.complex.GetTetrahedron(id).vertices;
    if (LocalIndex(t, ExteriorVertex) < 0)
    {
      const auto center = [&](int i) { return (1.0 / counts[t[i]]) * sums[t[i]]; };
      positive += Dot(center(1) - center(0), Cross(center(2) - center(0), center(3) - center(0))) > 0.0 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(all, 5);
  EXPECT_EQ(positive, all);
}
