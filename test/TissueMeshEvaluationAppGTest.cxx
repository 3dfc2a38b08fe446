/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationAppTest.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>

namespace
{
class TissueMeshEvaluationApp : public TissueTessellationAppTest
{
protected:
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    this->WriteTissue<unsigned short>("tissue.mha");
  }

  int
  Evaluate(const std::string & arguments)
  {
    // After the main program, that does nothing: Run() is of one command.
    return this->Run("--version > nothing.txt; " + std::string(TISSUE_MESH_EVALUATION_PROGRAM) + " " + arguments);
  }

  /** Writes a mesh of the tissue, and reads it. */
  vtkSmartPointer<vtkPolyData>
  MakeMesh()
  {
    EXPECT_EQ(this->Run("tissue.mha walls.vtp --report report.json"), 0) << m_Errors;
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->PathOf("walls.vtp").c_str());
    reader->Update();
    return reader->GetOutput();
  }

  void
  WriteMesh(vtkPolyData * mesh, const std::string & name)
  {
    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(mesh);
    writer->SetFileName(this->PathOf(name).c_str());
    ASSERT_EQ(writer->Write(), 1);
  }

  void
  ExpectRefusal(const std::string & arguments, const std::vector<std::string> & parts)
  {
    EXPECT_EQ(this->Evaluate(arguments), 1) << arguments;
    EXPECT_EQ(m_Errors.find("TissueMeshEvaluation: "), 0u) << m_Errors;
    EXPECT_EQ(m_Errors.find('\n'), m_Errors.size() - 1) << m_Errors;
    for (const std::string & part : parts)
    {
      EXPECT_NE(m_Errors.find(part), std::string::npos) << "'" << part << "' is not in " << m_Errors;
    }
  }
};
} // namespace

TEST_F(TissueMeshEvaluationApp, AgreesWithTheProgramThatMadeTheMesh)
{
  this->MakeMesh();
  const auto made = this->ReadReport();
  ASSERT_EQ(this->Evaluate("walls.vtp tissue.mha --report report.json"), 0) << m_Errors;
  const auto report = this->ReadReport();
  EXPECT_EQ(report["cells"], 40);
  EXPECT_EQ(report["spheres"], 40);
  EXPECT_EQ(report["triangles"], made["mesh"]["triangles"]);
  EXPECT_DOUBLE_EQ(report["adjacency2"], made["stages"]["optimized"]["adjacency2"]);
  EXPECT_DOUBLE_EQ(report["adjacency4"], made["stages"]["optimized"]["adjacency4"]);
  EXPECT_EQ(report["cornersOfMoreThanFourCells"], 0);
  EXPECT_EQ(report["crossingPairs"], 0);
  EXPECT_GT(report["meanDice"], 0.85);
  EXPECT_EQ(report["byCell"].size(), 40u);
  EXPECT_NE(m_Output.find("Adjacency2, adjacency4"), std::string::npos) << m_Output;
}

TEST_F(TissueMeshEvaluationApp, HoleAndTurnedTriangleOpenTheirCells)
{
  const auto              mesh = this->MakeMesh();
  const vtkNew<vtkIdList> triangle;
  mesh->BuildCells();
  mesh->GetCellPoints(0, triangle);
  const vtkIdType turned[3] = { triangle->GetId(0), triangle->GetId(2), triangle->GetId(1) };
  mesh->ReplaceCell(0, 3, turned);
  this->WriteMesh(mesh, "turned.vtp");
  ASSERT_EQ(this->Evaluate("turned.vtp tissue.mha --report report.json"), 0) << m_Errors;
  EXPECT_LT(this->ReadReport()["closedCells"], 40);
}

TEST_F(TissueMeshEvaluationApp, RefusesMeshesThatItCannotJudge)
{
  const auto mesh = this->MakeMesh();
  this->ExpectRefusal("absent.vtp tissue.mha", { "absent.vtp", "no such file" });
  this->ExpectRefusal("tissue.mha tissue.mha", { "tissue.mha", "no VTK file" });
  this->ExpectRefusal("walls.vtp absent.mha", { "absent.mha" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Cells", { "walls.vtp", "Cells" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Label", { "walls.vtp", "1 components", "2" });
  this->ExpectRefusal("walls.vtp tissue.mha --report folder/absent.json", { "folder/absent.json" });
  this->ExpectRefusal("walls.vtp tissue.mha --refinement 2", { "--refinement" });

  const vtkNew<vtkPolyData> foreign;
  foreign->DeepCopy(mesh);
  foreign->GetCellData()->GetArray("BoundaryLabels")->SetComponent(3, 0, 777.0);
  this->WriteMesh(foreign, "foreign.vtp");
  this->ExpectRefusal("foreign.vtp tissue.mha", { "foreign.vtp", "777" });

  const vtkNew<vtkPolyData> infinite;
  infinite->DeepCopy(mesh);
  infinite->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->WriteMesh(infinite, "infinite.vtp");
  this->ExpectRefusal("infinite.vtp tissue.mha", { "infinite.vtp", "point 5" });

  const vtkNew<vtkPolyData> empty;
  this->WriteMesh(empty, "empty.vtp");
  this->ExpectRefusal("empty.vtp tissue.mha", { "empty.vtp", "triangles" });
}
