/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The programs as 3D Slicer runs them: it composes the command line from the XML that they print.
#include "MembraneImage.h"
#include "SlicerModule.h"
#include "TissueTessellationProgramTest.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace
{
using Values = std::map<std::string, std::string>;

class SlicerModules : public TissueTessellationAppTest
{
protected:
  SlicerModuleXML
  Describe(const std::string & program)
  {
    m_Program = program;
    EXPECT_EQ(this->Run("--xml"), 0) << program;
    EXPECT_EQ(m_Errors, "") << program;
    const SlicerModuleXML module(m_Output);
    std::set<std::string> names;
    for (const SlicerParameter & parameter : module.parameters)
    {
      EXPECT_TRUE(names.insert(parameter.Text("name")).second) << parameter.Text("name");
    }
    return module;
  }

  /** Runs a program in Slicer's way, which must tell its progress and its results. */
  void
  RunAsSlicer(const std::string & program, const Values & values)
  {
    const SlicerModuleXML module = this->Describe(program);
    const std::string     line = module.ComposeCommandLine(values, "results.params");
    ASSERT_EQ(this->Run(line), 0) << line << ": " << m_Errors;
    EXPECT_NE(m_Output.find("<filter-progress>"), std::string::npos) << m_Output;
    EXPECT_EQ(WithoutProgress(m_Output).find("<filter"), std::string::npos) << m_Output;
    const std::string results = ReadBytes(this->PathOf("results.params"));
    std::string       expected;
    for (const SlicerParameter & parameter : module.parameters)
    {
      expected += SlicerModuleXML::IsResult(parameter) ? parameter.Text("name") + " = N\n" : "";
    }
    EXPECT_EQ(std::regex_replace(results, std::regex("= [0-9.e+-]+"), "= N"), expected);
  }

  /** What Slicer leaves of the output. */
  static std::string
  WithoutProgress(std::string text)
  {
    for (const char * name : { "progress", "name", "comment", "time", "start", "end" })
    {
      const std::string tag = std::string("filter-") + name;
      text = std::regex_replace(text, std::regex("<" + tag + ">[^<]*</" + tag + ">\\s*"), "");
    }
    return text;
  }
};
} // namespace

TEST_F(SlicerModules, LeaveOutWhatMakesNoSenseInSlicer)
{
  const SlicerModuleXML ofLabels = this->Describe(TISSUE_TESSELLATION_PROGRAM);
  for (const char * name : { "help", "version", "quiet", "strict", "preset", "membrane", "xml", "echo", "seed" })
  {
    EXPECT_TRUE(ofLabels.HasNone(name)) << name;
  }
  EXPECT_EQ(ofLabels.Find("labels").tag, "image");
  EXPECT_EQ(ofLabels.Find("walls").tag, "geometry");
  EXPECT_EQ(ofLabels.Find("statistics").tag, "table");
  EXPECT_EQ(ofLabels.Find("wallStatistics").tag, "table");
  EXPECT_EQ(ofLabels.Find("channel").tag, "string");
  EXPECT_EQ(ofLabels.Find("exteriorLabel").tag, "integer-vector");
  EXPECT_EQ(ofLabels.Find("dropCells").tag, "string-vector");
  EXPECT_EQ(ofLabels.Find("triangles").Text("default"), "150");
  const SlicerModuleXML ofPoints = this->Describe(NUCLEI_TESSELLATION_PROGRAM);
  for (const char * name : { "columns", "centersOf", "minimumScale" })
  {
    EXPECT_TRUE(ofPoints.HasNone(name)) << name;
  }
  EXPECT_EQ(ofPoints.Find("points").tag, "pointfile");
  EXPECT_EQ(ofPoints.Find("layer").tag, "string-enumeration");
  const SlicerModuleXML ofNuclei = this->Describe(NUCLEI_DETECTION_PROGRAM);
  EXPECT_EQ(ofNuclei.Find("points").Text("channel"), "output");
  EXPECT_EQ(ofNuclei.Find("dark").tag, "boolean");
}

TEST_F(SlicerModules, MakeOfLabelsWhatTheProgramMakes)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  ASSERT_EQ(this->Run("tissue.mha plain.vtp --statistics plain.csv"), 0) << m_Errors;
  const std::string said = m_Output;
  this->RunAsSlicer(TISSUE_TESSELLATION_PROGRAM,
                    { { "labels", "tissue.mha" }, { "walls", "slicer.vtp" }, { "statistics", "slicer.csv" } });
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.vtp")), ReadBytes(this->PathOf("plain.vtp")));
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.csv")), ReadBytes(this->PathOf("plain.csv")));
  EXPECT_FALSE(said.empty());
}

TEST_F(SlicerModules, TakeEveryKindOfOptionInSlicersForm)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  ASSERT_EQ(this->Run("--exteriorLabel 0 --exteriorLabel 7 --spacing 2 2 3 --closeGaps=0.5 --channel 1 --prefer "
                      "junctions --zeroIsCell --triangles 80 tissue.mha plain.vtp"),
            0)
    << m_Errors;
  this->RunAsSlicer(TISSUE_TESSELLATION_PROGRAM,
                    { { "labels", "tissue.mha" },
                      { "walls", "slicer.vtp" },
                      { "exteriorLabel", "0,7" },
                      { "spacing", "2,2,3" },
                      { "closeGaps", "0.5" },
                      { "channel", "1" },
                      { "prefer", "junctions" },
                      { "zeroIsCell", "true" },
                      { "triangles", "80" } });
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.vtp")), ReadBytes(this->PathOf("plain.vtp")));
}

TEST_F(SlicerModules, TakeTheImageForMembranesWhereItIsToBe)
{
  const auto tissue = MakeSyntheticTestTissue<unsigned char>();
  this->WriteImage(tissue_test::MakeMembraneImage<unsigned char>(tissue.GetPointer()).GetPointer(), "membranes.mha");
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  ASSERT_EQ(this->Run("--membrane membranes.mha plain.vtp --refinement 0"), 0) << m_Errors;
  this->RunAsSlicer(
    TISSUE_TESSELLATION_PROGRAM,
    { { "labels", "membranes.mha" }, { "imageIs", "membranes" }, { "refinement", "0" }, { "walls", "slicer.vtp" } });
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.vtp")), ReadBytes(this->PathOf("plain.vtp")));
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  this->ExpectRefusal("--membrane membranes.mha --imageIs labels w.vtp", { "--imageIs", "--membrane" });
}

TEST_F(SlicerModules, PassNucleiFromOneToTheOther)
{
  m_Program = SYNTHETIC_TISSUE_PROGRAM;
  ASSERT_EQ(this->Run("labels.mha --nuclei nuclei.mha --size 64 64 40 --spacing 0.5 0.5 1 --cells 40 --quiet"), 0)
    << m_Errors;
  m_Program = NUCLEI_DETECTION_PROGRAM;
  ASSERT_EQ(this->Run("nuclei.mha plain.mrk.json"), 0) << m_Errors;
  this->RunAsSlicer(NUCLEI_DETECTION_PROGRAM, { { "image", "nuclei.mha" }, { "points", "slicer.mrk.json" } });
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.mrk.json")), ReadBytes(this->PathOf("plain.mrk.json")));
  EXPECT_EQ(ReadBytes(this->PathOf("results.params")).rfind("numberOfNuclei = 40\n", 0), 0u);

  m_Program = NUCLEI_TESSELLATION_PROGRAM;
  ASSERT_EQ(this->Run("plain.mrk.json plain.vtp --box nuclei.mha --refinement 0"), 0) << m_Errors;
  this->RunAsSlicer(
    NUCLEI_TESSELLATION_PROGRAM,
    { { "points", "slicer.mrk.json" }, { "box", "nuclei.mha" }, { "refinement", "0" }, { "walls", "slicer.vtp" } });
  EXPECT_EQ(ReadBytes(this->PathOf("slicer.vtp")), ReadBytes(this->PathOf("plain.vtp")));
}

TEST_F(SlicerModules, WriteNoResultsWhereTheRunFails)
{
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("tissue.mha walls.vtp --returnparameterfile none/results", { "none/results", "no folder" });
  this->ExpectRefusal("missing.mha walls.vtp --returnparameterfile results", { "missing.mha" });
}

TEST_F(SlicerModules, SegmentCellsInAFileWithPieces)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  for (const char * cells : { "cells.vtu", "cells.seg.vtm", "cells.seg.vtm" })
  {
    ASSERT_EQ(this->Run(std::string("tissue.mha walls.vtp --refinement 0 --cells ") + cells), 0) << m_Errors;
  }
  EXPECT_EQ(this->List(), "cells.seg cells.seg.vtm cells.vtu tissue.mha walls.vtp ");

  const vtkNew<vtkXMLUnstructuredGridReader> gridReader;
  gridReader->SetFileName(this->PathOf("cells.vtu").c_str());
  gridReader->Update();
  vtkUnstructuredGrid * const              grid = gridReader->GetOutput();
  const vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(this->PathOf("cells.seg.vtm").c_str());
  reader->Update();
  auto * const segmentation = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  ASSERT_EQ(static_cast<vtkIdType>(segmentation->GetNumberOfBlocks()), grid->GetNumberOfCells());
  std::set<std::string> colors;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    auto * const block = vtkPolyData::SafeDownCast(segmentation->GetBlock(static_cast<unsigned int>(i)));
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->GetNumberOfCells(), grid->GetCell(i)->GetNumberOfFaces());
    colors.insert(block->GetFieldData()->GetArray("Segment_Color")->GetVariantValue(0).ToString());
  }
  EXPECT_GT(colors.size(), 1u);

  std::ofstream(this->PathOf("cells.seg/notes.txt")) << "mine";
  this->ExpectRefusal("tissue.mha walls.vtp --cells cells.seg.vtm", { "cells.seg.vtm", "notes.txt" });
  this->ExpectRefusal("tissue.mha walls.vtp --cells cells.vtk", { "must end in .vtu or .vtm" });
}
