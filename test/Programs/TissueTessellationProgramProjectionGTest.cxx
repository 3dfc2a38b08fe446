/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationProgramTest.h"

#include <sstream>

namespace
{
/** What is projected on the cells of a label image, by the main program or that of points. */
class TissueTessellationProjection : public TissueTessellationAppTest
{
protected:
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    this->WriteTissue<unsigned char>("labels.mha");
    this->WriteSignal("signal.mha", 0.0);
  }

  /** A ramp along x on the grid of the labels, moved along x. */
  void
  WriteSignal(const std::string & name, double shift)
  {
    using Signal = itk::Image<unsigned short, 3>;
    const auto labels = MakeSyntheticTestTissue<unsigned char>();
    const auto signal = Signal::New();
    signal->CopyInformation(labels);
    signal->SetRegions(labels->GetLargestPossibleRegion());
    signal->Allocate();
    auto origin = labels->GetOrigin();
    origin[0] += shift;
    signal->SetOrigin(origin);
    const std::size_t row = labels->GetLargestPossibleRegion().GetSize(0);
    for (std::size_t i = 0; i < labels->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
    {
      signal->GetBufferPointer()[i] = static_cast<unsigned short>(i % row);
    }
    this->WriteImage(signal.GetPointer(), name);
  }

  void
  Refuse(const std::string & arguments, const std::vector<std::string> & parts)
  {
    this->ExpectRefusal("labels.mha walls.vtp --refinement 0 " + arguments, parts);
  }

  std::string
  HeaderOf(const std::string & name) const
  {
    std::istringstream text(ReadBytes(this->PathOf(name)));
    std::string        line;
    std::getline(text, line);
    return line;
  }
};
} // namespace

TEST_F(TissueTessellationProjection, TablesAndSignalsAreColumnsOfCellsAndWalls)
{
  this->WriteLines("a.csv", "label,rate\n1,0.5\n2,1.5\n9999,3\n");
  this->WriteLines("b.tsv", "id\tfate\n2\tsepal\n");
  const auto report = this->RunAndReport("labels.mha walls.vtp --refinement 0 --cellData a.csv --cellData b.tsv "
                                         "--signal S=signal.mha --statistics cells.csv --walls walls.csv --quiet");
  EXPECT_NE(this->HeaderOf("cells.csv").find("MinimumCurvature,rate,fate,SMean,SIntegral,SNearWalls"),
            std::string::npos);
  EXPECT_NE(this->HeaderOf("walls.csv").find("CutArea,SMean,rate0,rate1,fate0,fate1,SMean0,SMean1"), std::string::npos);
  EXPECT_EQ(report["cellData"][0]["unknownLabels"], nlohmann::json({ "9999" }));
  EXPECT_EQ(report["signals"][0]["name"], "S");
  EXPECT_TRUE(report["signals"][0]["cellsOutside"].empty());
  EXPECT_NE(m_Errors.find("a.csv: 1 of 3 rows have labels that no cell has ('9999')"), std::string::npos) << m_Errors;
  EXPECT_NE(m_Errors.find("b.tsv: "), std::string::npos) << m_Errors;
}

TEST_F(TissueTessellationProjection, AnyNumberOfThreadsGivesTheSameFiles)
{
  const std::string arguments = "labels.mha walls.vtp --refinement 0 --signal signal.mha --wallDistance 1.5 --quiet ";
  ASSERT_EQ(0, this->Run(arguments + "--statistics a.csv --walls aw.csv --threads 1")) << m_Errors;
  ASSERT_EQ(0, this->Run(arguments + "--statistics b.csv --walls bw.csv --threads 3")) << m_Errors;
  EXPECT_EQ(ReadBytes(this->PathOf("a.csv")), ReadBytes(this->PathOf("b.csv")));
  EXPECT_EQ(ReadBytes(this->PathOf("aw.csv")), ReadBytes(this->PathOf("bw.csv")));
}

TEST_F(TissueTessellationProjection, WhatCannotBeProjectedIsRefusedAndNothingIsWritten)
{
  this->WriteLines("none.csv", "label,x\n9998,1\n");
  this->WriteLines("own.csv", "label,Volume\n1,1\n");
  this->WriteLines("nolabel.csv", "a,b\n1,1\n");
  this->WriteLines("text.csv", "label,x\n1,2\n2,much\n");
  this->WriteLines("twice.csv", "label,x\n1,2\n1,3\n");
  this->WriteLines("empty.csv", "");
  this->WriteLines("infinite.csv", "label,x\n1,inf\n");
  this->WriteLines("same.csv", "label,signalMean\n1,2\n");
  this->WriteSignal("far.mha", 1e4);
  this->Refuse("--cellData none.csv", { "none.csv: no row has the label of a cell", "'9998'" });
  this->Refuse("--cellData own.csv", { "own.csv: the column 'Volume' has the name of one of the statistics" });
  this->Refuse("--cellData nolabel.csv", { "nolabel.csv: there is no column of labels", "'a', 'b'" });
  this->Refuse("--cellData text.csv", { "text.csv: line 3: 'much' in column 2 ('x') is no number" });
  this->Refuse("--cellData twice.csv", { "twice.csv: line 3: the label '1' is that of line 2" });
  this->Refuse("--cellData empty.csv", { "empty.csv: the table is empty" });
  this->Refuse("--cellData infinite.csv", { "infinite.csv: line 2: 'inf'", "finite" });
  this->Refuse("--cellData absent.csv", { "absent.csv: no such file" });
  this->Refuse("--cellData same.csv --signal signal.mha",
               { "'signalMean' has the name of one of same.csv", "NAME=FILE" });
  this->Refuse("--signal far.mha", { "far.mha: the image lies beside the tissue" });
  this->Refuse("--signal empty.csv", { "empty.csv: not an image" });
  this->Refuse("--signal signal.mha --signalChannel 2", { "signal.mha: the file has 1 channel", "no channel 2" });
  this->Refuse("--cellData twice.csv --statistics twice.csv", { "twice.csv", "it is the input" });
  this->Refuse("--picture p.png --colorBy Size", { "no column 'Size'", "Volume, ", "Layer, " });
}

TEST_F(TissueTessellationProjection, AnExtensionThatNoWriterKnowsIsRefusedBeforeTheWork)
{
  for (const char * const output : { "--walls w.xls",
                                     "--graph g.gml",
                                     "--cells c.stl",
                                     "--cellSurfaces c.ply",
                                     "--complex c.vtp",
                                     "--simulation m.inp",
                                     "--export m.off",
                                     "--statistics s.json",
                                     "--junctions j.txt",
                                     "--report r.txt",
                                     "--page p.php",
                                     "--picture p.jpg" })
  {
    this->Refuse(output, { "must end in ." });
  }
}

TEST_F(TissueTessellationProjection, PointsHaveTablesByTheirNamesAndSignals)
{
  m_Program = NUCLEI_TESSELLATION_PROGRAM;
  std::string points = "x,y,z,label\n";
  for (int i = 0; i < 27; ++i)
  {
    points += std::to_string(8 * (i % 3) + i % 2) + "," + std::to_string(8 * (i / 3 % 3)) + "," +
              std::to_string(8 * (i / 9) + i % 5) + ",n" + std::to_string(i) + "\n";
  }
  this->WriteLines("points.csv", points);
  this->WriteLines("a.csv", "name,rate\nn3,0.5\nn0,1.5\n");
  const std::string arguments = "points.csv walls.vtp --refinement 0 --voxelsPerCell 300 --quiet --cellData a.csv ";
  ASSERT_EQ(0, this->Run(arguments + "--signal signal.mha --statistics cells.csv")) << m_Errors;
  EXPECT_NE(this->HeaderOf("cells.csv").find("Name,rate,signalMean,"), std::string::npos);
  EXPECT_NE(ReadBytes(this->PathOf("cells.csv")).find(",n3,0.5,"), std::string::npos);
  this->ExpectRefusal("points.csv w.vtp --preset paper --signal signal.mha", { "--signal needs a label image" });
}
