/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/ImageTopology.h"
#include "Nerve/TestGeneralComplexes.h"
#include "Nerve/TestImages.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

using namespace testing_nerve;

namespace
{
/** Cells of a random Voronoi diagram, in a ball. */
LabelVolume
RandomCells(std::int32_t edge, int count, std::uint64_t seed)
{
  Random             random(seed);
  std::vector<Point> seeds;
  for (int i = 0; i < count; ++i)
  {
    seeds.push_back({ { random.Uniform() * edge, random.Uniform() * edge, random.Uniform() * edge } });
  }
  const Point center{ { 0.5 * edge, 0.5 * edge, 0.5 * edge } };
  return MakeImage({ { edge, edge, edge } }, [&](std::int32_t x, std::int32_t y, std::int32_t z) -> VertexId {
    const Point p{ { x + 0.5, y + 0.5, z + 0.5 } };
    if (Distance(p, center) > 0.45 * edge)
    {
      return ExteriorVertex;
    }
    const auto nearest = std::min_element(
      seeds.begin(), seeds.end(), [&](const Point & a, const Point & b) { return Distance(a, p) < Distance(b, p); });
    return static_cast<VertexId>(1 + (nearest - seeds.begin()));
  });
}

/** Of any size, down to one voxel: noise of few labels or many, checkerboards, cells with cavities, scattered pieces.
 */
LabelVolume
AnyImage(std::uint64_t seed)
{
  Random           random(seed);
  const auto       edge = [&] { return static_cast<std::int32_t>(1 + random.Index(10)); };
  const VoxelIndex size{ { edge(), edge(), edge() } };
  const auto       labels = 2 + random.Index(random.Index(2) != 0 ? 6 : 40);
  const auto       period = static_cast<std::int32_t>(1 + random.Index(3));
  const auto       kind = seed % 5;
  return MakeImage(size, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const std::size_t tile = static_cast<std::size_t>(x / period + y / period + z / period);
    const std::size_t any = random.Index(labels);
    const bool        isRare = random.Index(5) == 0;
    const std::size_t ofKind[] = {
      any, tile % 2, 1 + tile % (labels - 1), isRare ? any : std::size_t{ 1 }, isRare ? 1 + any % 2 : std::size_t{ 0 }
    };
    return static_cast<VertexId>(ofKind[kind]);
  });
}

/** The pairs of cells that the complex has and the image has not, and the other way round. */
std::pair<int, int>
FalseAndMissingPairs(const ImageTopology & topology)
{
  const auto ofCells = [&](const VertexPair & vertices) {
    const auto [a, b] = std::minmax(topology.cellOf[vertices[0]], topology.cellOf[vertices[1]]);
    return VertexPair{ { a, b } };
  };
  std::set<VertexPair> inComplex;
  for (const auto & edge : topology.nerve.complex.FindEdges())
  {
    inComplex.insert(ofCells(edge.vertices));
  }
  std::set<VertexPair> inImage;
  for (const ImageWall & wall : topology.places.walls)
  {
    inImage.insert(ofCells(wall.cells));
  }
  const auto count = [](const std::set<VertexPair> & pairs, const std::set<VertexPair> & others) {
    return static_cast<int>(std::count_if(pairs.begin(), pairs.end(), [&](const VertexPair & pair) {
      return pair[0] != pair[1] && others.count(pair) == 0;
    }));
  };
  return { count(inComplex, inImage), count(inImage, inComplex) };
}
} // namespace

TEST(ImageTopology, OfRandomCellsHasNearlyAllPairs)
{
  const LabelVolume   volume = RandomCells(48, 120, 7);
  const ImageTopology topology = FindImageTopology(volume, NumberOfVertices(volume));
  const auto [wrong, missing] = FalseAndMissingPairs(topology);
  EXPECT_LE(wrong + missing, static_cast<int>(topology.places.walls.size()) / 200);
  EXPECT_TRUE(topology.unsoundCells.empty());
  EXPECT_LT(topology.descent.energyAfter, topology.descent.energyBefore);
}

TEST(ImageTopology, OfASheetIsExact)
{
  const LabelVolume   volume = Bricks({ { 5, 5, 1 } }, 6);
  const ImageTopology topology = FindImageTopology(volume, NumberOfVertices(volume));
  EXPECT_EQ(FalseAndMissingPairs(topology), (std::pair<int, int>{ 0, 0 }));
  std::map<VertexPair, int> walls;
  for (const ImageWall & wall : topology.places.walls)
  {
    ++walls[wall.cells];
  }
  EXPECT_EQ(CountEdges(topology.nerve.complex), walls) << "each as often as in the image";
  EXPECT_TRUE(topology.repairs.empty());
}

TEST(ImageTopology, TellsFragmentsAndDividedCells)
{
  LabelVolume volume = Bricks({ { 3, 3, 2 } }, 6);
  const auto  vertices = NumberOfVertices(volume);
  const auto  at = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return static_cast<std::size_t>((z * volume.size[1] + y) * volume.size[0] + x);
  };
  // A nucleus within a cell, and a far voxel of another cell within a third.
  volume.vertices.Put(at(15, 15, 9), vertices);
  const VertexId around = volume.vertices[at(9, 9, 9)];
  volume.vertices.Put(at(9, 9, 9), volume.vertices[at(15, 21, 9)]);
  const VertexId      ofNucleus = volume.vertices[at(15, 14, 9)]; // one of the two that it touches
  const ImageTopology topology = FindImageTopology(volume, vertices + 1);
  ASSERT_EQ(topology.fragments.fragments.size(), 1u);
  EXPECT_EQ(topology.fragments.fragments[0].vertex, around);
  EXPECT_FALSE(topology.fragments.fragments[0].isLarge);
  const auto divided = std::find_if(
    topology.divided.begin(), topology.divided.end(), [&](const DividedCell & cell) { return cell.cell == ofNucleus; });
  ASSERT_NE(divided, topology.divided.end());
  EXPECT_EQ(divided->numberOfPieces, std::count(topology.cellOf.begin(), topology.cellOf.end(), ofNucleus));
  EXPECT_TRUE(topology.repairs.empty());
  EXPECT_TRUE(topology.unsoundCells.empty());
}

TEST(ImageTopology, IsTheSameForAnyNumberOfThreads)
{
  const Execution     threads([](std::size_t count, const Execution::LoopBody & body) {
    std::vector<std::thread> all;
    for (std::size_t t = 0; t < 3; ++t)
    {
      all.emplace_back([&, t] {
        for (std::size_t i = t; i < count; i += 3)
        {
          body(i);
        }
      });
    }
    for (std::thread & thread : all)
    {
      thread.join();
    }
  });
  const LabelVolume   volume = RandomCells(70, 60, 3);
  const ImageTopology one = FindImageTopology(volume, NumberOfVertices(volume));
  const ImageTopology many = FindImageTopology(volume, NumberOfVertices(volume), {}, threads);
  EXPECT_EQ(Dump(one.nerve.complex), Dump(many.nerve.complex));
  ASSERT_EQ(one.places.walls.size(), many.places.walls.size());
  for (std::size_t i = 0; i < one.places.walls.size(); ++i)
  {
    EXPECT_EQ(one.places.walls[i].cells, many.places.walls[i].cells);
    EXPECT_EQ(one.places.walls[i].center, many.places.walls[i].center);
  }
  ASSERT_EQ(one.nerve.lines.size(), many.nerve.lines.size());
  for (std::size_t i = 0; i < one.nerve.lines.size(); ++i)
  {
    EXPECT_EQ(one.nerve.lines[i].middle, many.nerve.lines[i].middle);
    EXPECT_EQ(one.nerve.lines[i].length, many.nerve.lines[i].length);
  }
}

TEST(ImageTopology, OfAnyImageIsValid)
{
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    const LabelVolume   volume = AnyImage(seed);
    const VertexId      vertices = NumberOfVertices(volume);
    const ImageTopology topology = FindImageTopology(volume, vertices);
    EXPECT_TRUE(topology.unsoundCells.empty());
    const LabelVolume &      image = topology.volume.vertices.empty() ? volume : topology.volume;
    const std::set<VertexId> present(image.vertices.begin(), image.vertices.end());
    for (const std::string & violation : FindViolations(topology.nerve.complex))
    {
      // A vertex that has no voxel, as of a small fragment's cell or of the exterior, need not be there.
      const bool isOfAbsent = violation.find("is in no tetrahedron") != std::string::npos &&
                              present.count(static_cast<VertexId>(std::stoi(violation.substr(7)))) == 0;
      EXPECT_TRUE(isOfAbsent || violation.rfind("vertex 0 ", 0) == 0) << violation;
    }
  }
}
