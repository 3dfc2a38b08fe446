/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

// Tissues whose every corner is known: Laguerre tessellations (power diagrams), voxelized.

namespace
{
using ImageType = itk::Image<unsigned short, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
  CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, Structure>;
using Seed = Regular::Weighted_point;

constexpr long   Side = 64;            // of the image, in voxels
constexpr double LatticeConstant = 16; // the edges of its truncated octahedra are 5.7 voxels long

/** The body-centred cubic lattice over the image and beyond, displaced and weighted at random by this share of its
 * constant. Its cells are truncated octahedra. */
std::vector<Seed>
MakeSeeds(double share)
{
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> symmetric(-share * LatticeConstant, share * LatticeConstant);
  std::vector<Seed>                      seeds;
  for (int i = -2; i <= 11; ++i)
  {
    for (int j = -2; j <= 11; ++j)
    {
      for (int k = -2; k <= 11; ++k)
      {
        if ((i + j) % 2 == 0 && (j + k) % 2 == 0)
        {
          // Off the voxels' centres, so that none is at equal distances.
          const double x = 0.5 * LatticeConstant * i + 0.31 + symmetric(random);
          const double y = 0.5 * LatticeConstant * j + 0.17 + symmetric(random);
          const double z = 0.5 * LatticeConstant * k + 0.43 + symmetric(random);
          seeds.emplace_back(Kernel::Point_3(x, y, z), LatticeConstant * symmetric(random));
        }
      }
    }
  }
  return seeds;
}

double
Power(const Seed & seed, const Kernel::Point_3 & p)
{
  return CGAL::squared_distance(seed.point(), p) - seed.weight();
}

/** Labels are the numbers of the seeds, from 1, in a layer of exterior, 0. */
ImageType::Pointer
Voxelize(const std::vector<Seed> & seeds)
{
  return tissue_test::MakeImage<unsigned short>({ { Side, Side, Side } }, [&seeds](long x, long y, long z) {
    if (std::min({ x, y, z }) == 0 || std::max({ x, y, z }) == Side - 1)
    {
      return std::ptrdiff_t{ 0 };
    }
    const Kernel::Point_3 p(x, y, z);
    const auto            least = std::min_element(
      seeds.begin(), seeds.end(), [&p](const Seed & a, const Seed & b) { return Power(a, p) < Power(b, p); });
    return 1 + (least - seeds.begin());
  });
}

using Labels = std::array<tissue::Label, 4>;

/** The true corners at least `margin` voxels within the image, by their four labels. */
std::map<Labels, Kernel::Point_3>
FindTrueCorners(const std::vector<Seed> & seeds, double margin)
{
  std::vector<std::pair<Seed, int>> numbered;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    numbered.emplace_back(seeds[i], static_cast<int>(i) + 1);
  }
  const Regular                     triangulation(numbered.begin(), numbered.end());
  std::map<Labels, Kernel::Point_3> corners;
  for (auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell)
  {
    const Kernel::Point_3 corner = triangulation.dual(cell);
    const auto            isInside = [margin](double x) { return x >= margin && x <= Side - 1 - margin; };
    if (isInside(corner.x()) && isInside(corner.y()) && isInside(corner.z()))
    {
      Labels labels;
      for (int i = 0; i < 4; ++i)
      {
        labels[i] = cell->vertex(i)->info();
      }
      std::sort(labels.begin(), labels.end());
      corners.emplace(labels, corner);
    }
  }
  return corners;
}

itk::CellWallMesh::Pointer
Reconstruct(const std::vector<Seed> & seeds)
{
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(Voxelize(seeds));
  filter->SetExteriorLabel(0);
  filter->Update();
  return filter->GetOutput();
}

/** The tetrahedra of the mesh by their labels. */
std::set<Labels>
LabelsOfTetrahedra(const itk::CellWallMesh & mesh)
{
  std::set<Labels> all;
  for (const tissue::VertexQuadruple & t : mesh.GetReconstruction().tetrahedra)
  {
    Labels labels;
    for (int i = 0; i < 4; ++i)
    {
      labels[i] = mesh.GetJunctionSet().cells[t[i]].label;
    }
    std::sort(labels.begin(), labels.end());
    all.insert(labels);
  }
  return all;
}
} // namespace

TEST(KnownTissue, EveryTrueCornerOfALaguerreTessellationIsFound)
{
  const std::vector<Seed> seeds = MakeSeeds(0.04);
  const auto              corners = FindTrueCorners(seeds, 4.0);
  ASSERT_GT(corners.size(), 450u);
  const auto found = LabelsOfTetrahedra(*Reconstruct(seeds));
  for (const auto & [labels, corner] : corners)
  {
    EXPECT_EQ(found.count(labels), 1u) << labels[0] << " " << labels[1] << " " << labels[2] << " " << labels[3]
                                       << " meet at " << corner;
  }
}

TEST(KnownTissue, RegularPackingIsOneOfTruncatedOctahedra)
{
  const std::vector<Seed>                          seeds = MakeSeeds(0.0);
  const auto                                       mesh = Reconstruct(seeds);
  std::map<tissue::Label, int>                     numberOfCorners;
  std::map<tissue::Label, std::set<tissue::Label>> neighbors;
  for (const Labels & labels : LabelsOfTetrahedra(*mesh))
  {
    for (const tissue::Label label : labels)
    {
      ++numberOfCorners[label];
      neighbors[label].insert(labels.begin(), labels.end());
    }
  }
  int numberOfInnerCells = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const auto isInside = [](double x) { return x >= LatticeConstant && x <= Side - 1 - LatticeConstant; };
    if (isInside(seeds[i].x()) && isInside(seeds[i].y()) && isInside(seeds[i].z()))
    {
      const auto label = static_cast<tissue::Label>(i + 1);
      EXPECT_EQ(numberOfCorners[label], 24) << label;
      EXPECT_EQ(neighbors[label].size(), 1u + 14u) << label;
      ++numberOfInnerCells;
    }
  }
  EXPECT_EQ(numberOfInnerCells, 16);
}
