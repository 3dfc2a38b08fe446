/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// What of the adjacency the program for points finds, from centres of cells that are exact and from displaced ones.
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationProgramTest.h"
#include "itkSyntheticTissueImageSource.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <string>
#include <utility>

namespace
{
using ImageType = itk::Image<unsigned short, 3>;

class AdjacencyFromPoints : public TissueTessellationAppTest
{
protected:
  AdjacencyFromPoints() { m_Program = NUCLEI_TESSELLATION_PROGRAM; }

  /** `tissue.mha` of 500 cells by division. */
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    const auto source = itk::SyntheticTissueImageSource<ImageType>::New();
    source->SetSize({ { 100, 100, 80 } });
    source->SetNumberOfCells(500);
    source->SetCellModel(itk::SyntheticTissueEnums::CellModel::Division);
    source->SetSeed(5);
    source->Update();
    m_Tissue = source->GetOutput();
    this->WriteImage(m_Tissue.GetPointer(), "tissue.mha");
  }

  /** `points.csv`: the centres, displaced by so much of a cell's diameter (root mean square). */
  void
  WritePoints(double displacement)
  {
    const tissue::JunctionSet junctions = tissue_test::Extract(m_Tissue.GetPointer());
    tissue::Random            random(1);
    std::ofstream             file(this->PathOf("points.csv"));
    file << "label,x,y,z\n" << std::setprecision(17);
    for (std::size_t v = 1; v < junctions.cells.size(); ++v)
    {
      const tissue::Cell & cell = junctions.cells[v];
      file << cell.label;
      for (int axis = 0; axis < 3; ++axis)
      {
        // Uniform, of deviation displacement * diameter / sqrt(3).
        const double range = 2.0 * displacement * std::cbrt(6.0 * cell.volume / itk::Math::pi);
        const double last = static_cast<double>(m_Tissue->GetLargestPossibleRegion().GetSize(axis)) - 1.0;
        file << ',' << std::clamp(cell.center[axis] + range * (random.Uniform() - 0.5), 0.0, last);
      }
      file << '\n';
    }
  }

  nlohmann::json
  Reconstruct(const std::string & options)
  {
    return this->RunAndReport("points.csv walls.vtp --box tissue.mha --refinement 0 --evaluateAgainst tissue.mha "
                              "--evaluateByLabel " +
                              options);
  }

  ImageType::Pointer m_Tissue;
};
} // namespace

TEST_F(AdjacencyFromPoints, IsNearerToTheTissueThanThatOfTheCleanedComplex)
{
  // Least gains of adjacency4 that are asked for.
  for (const auto & [displacement, gain] : { std::pair{ 0.0, 0.03 }, { 0.1, 0.01 }, { 0.2, 0.0 } })
  {
    this->WritePoints(displacement);
    const auto   paper = this->Reconstruct("--preset paper")["evaluation"];
    const auto   tissue = this->Reconstruct("")["evaluation"]["optimized"];
    const double cleaned = paper["cleaned"]["adjacency4"];
    EXPECT_GT(tissue["adjacency4"], cleaned + gain) << displacement;
    EXPECT_GE(paper["optimized"]["adjacency4"], cleaned) << displacement;
  }
}

TEST_F(AdjacencyFromPoints, PaperPresetMakesTheComplexMoreRegular)
{
  // Table 2 of the paper, but for adjacencies that are not lost.
  this->WritePoints(0.0);
  const auto   report = this->Reconstruct("--preset paper");
  const auto & cleaned = report["stages"]["cleaned"];
  const auto & optimized = report["stages"]["optimized"];
  EXPECT_LE(optimized["neighborhoodError"], 0.07);
  EXPECT_LT(optimized["neighborhoodError"], cleaned["neighborhoodError"]);
  EXPECT_LE(optimized["eccentricity"], 0.31);
  EXPECT_LT(optimized["eccentricity"], cleaned["eccentricity"]);
  EXPECT_EQ(optimized["invertedTetrahedra"], 0);
  EXPECT_EQ(report["options"]["corners"], "lifted");
  // By the paper's terms alone they are.
  const auto alone = this->Reconstruct("--preset paper --delaunayWeight 0")["evaluation"];
  EXPECT_LT(alone["optimized"]["adjacency4"], alone["cleaned"]["adjacency4"]);
}
