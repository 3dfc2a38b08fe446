/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Meshes as other programs write them.
#include "LabelImageTestHelpers.h"
#include "TissueMeshEvaluationProgramTest.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

namespace
{
/** The evaluation of meshes as other programs write them, which must be that of the walls they are made of. */
class MeshesOfOthers : public TissueMeshEvaluationApp
{
protected:
  void
  SetUp() override
  {
    TissueMeshEvaluationApp::SetUp();
    ASSERT_EQ(this->Run("tissue.mha walls.vtp --refinement 0 --cells cells.vtu"), 0) << m_Errors;
    const vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->PathOf("walls.vtp").c_str());
    reader->Update();
    m_Walls = reader->GetOutput();
    m_Labels = m_Walls->GetCellData()->GetArray("BoundaryLabels");
    m_Expected = this->Judge("walls.vtp");
    m_Bare->SetPoints(m_Walls->GetPoints());
    m_Bare->SetPolys(m_Walls->GetPolys());
  }

  nlohmann::json
  Judge(const std::string & arguments)
  {
    EXPECT_EQ(this->Evaluate(arguments + " tissue.mha --report report.json"), 0) << arguments << ": " << m_Errors;
    return this->ReadReport();
  }

  void
  ExpectTheSame(const std::string & arguments)
  {
    const auto report = this->Judge(arguments);
    for (const char * figure : { "cells", "adjacency2", "adjacency4", "cellsOfSpheres", "crossingPairs", "triangles" })
    {
      EXPECT_EQ(report[figure], m_Expected[figure]) << arguments << ": " << figure;
    }
    for (const char * figure : { "meanVolumeError", "wallDistance" })
    {
      EXPECT_NEAR(report[figure].get<double>(), m_Expected[figure].get<double>(), 1e-5) << arguments << ": " << figure;
    }
  }

  /** Adds an array of one component of the labels on a side. */
  void
  AddSide(const std::string & name, int side)
  {
    const vtkNew<vtkIntArray> array;
    array->SetName(name.c_str());
    for (vtkIdType i = 0; i < m_Labels->GetNumberOfTuples(); ++i)
    {
      array->InsertNextValue(static_cast<int>(m_Labels->GetComponent(i, side)));
    }
    m_Bare->GetCellData()->AddArray(array);
  }

  std::array<vtkIdType, 3>
  TriangleAt(vtkIdType i) const
  {
    const vtkNew<vtkIdList> ids;
    m_Walls->GetPolys()->GetCellAtId(i, ids);
    return { { ids->GetId(0), ids->GetId(1), ids->GetId(2) } };
  }

  vtkSmartPointer<vtkPolyData> m_Walls;
  vtkDataArray *               m_Labels = nullptr;
  nlohmann::json               m_Expected;
  /** The walls without arrays. */
  vtkNew<vtkPolyData> m_Bare;
};
} // namespace

TEST_F(MeshesOfOthers, HaveTwoArraysOfLabels)
{
  this->AddSide("label1", 0);
  this->AddSide("label2", 1);
  this->WriteMesh(m_Bare, "arrays.vtp");
  this->ExpectTheSame("arrays.vtp");
  this->ExpectTheSame("arrays.vtp --labelArray label1,label2");
  // By these the normals point from the second cell to the first, which the volumes tell.
  this->ExpectTheSame("arrays.vtp --labelArray label2,label1");
}

TEST_F(MeshesOfOthers, HaveAnOutsideOfMinusOne)
{
  const vtkNew<vtkIntArray> labels;
  labels->DeepCopy(m_Labels);
  labels->SetName("FaceLabels");
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    labels->SetComponent(i, 1, labels->GetComponent(i, 1) == 0.0 ? -1.0 : labels->GetComponent(i, 1));
  }
  m_Bare->GetCellData()->AddArray(labels);
  this->WriteMesh(m_Bare, "dream3d.vtp");
  this->ExpectTheSame("dream3d.vtp");
}

TEST_F(MeshesOfOthers, AreUnstructuredGridsAndLegacyFiles)
{
  const vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(m_Walls->GetPoints());
  grid->SetCells(VTK_TRIANGLE, m_Walls->GetPolys());
  m_Labels->SetName("Labels");
  grid->GetCellData()->AddArray(m_Labels);
  const vtkNew<vtkXMLUnstructuredGridWriter> xml;
  xml->SetInputData(grid);
  xml->SetFileName(this->PathOf("grid.vtu").c_str());
  ASSERT_EQ(xml->Write(), 1);
  this->ExpectTheSame("grid.vtu");
  const vtkNew<vtkUnstructuredGridWriter> legacy;
  legacy->SetInputData(grid);
  legacy->SetFileTypeToBinary();
  legacy->SetFileName(this->PathOf("grid.vtk").c_str());
  ASSERT_EQ(legacy->Write(), 1);
  this->ExpectTheSame("grid.vtk");
}

// The polyhedra of our own file of cells, each with the label of its own.
TEST_F(MeshesOfOthers, AreCellsWithFaces)
{
  this->ExpectTheSame("cells.vtu --labelArray Label");
}

TEST_F(MeshesOfOthers, HaveGroupsOfWallsOrOfCells)
{
  std::ofstream walls(this->PathOf("walls.obj"));
  std::ofstream cells(this->PathOf("cells.obj"));
  for (vtkIdType i = 0; i < m_Walls->GetNumberOfPoints(); ++i)
  {
    double p[3];
    m_Walls->GetPoint(i, p);
    for (std::ofstream * file : { &walls, &cells })
    {
      *file << std::setprecision(9) << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
  }
  std::map<int, std::string> surfaceOf;
  for (vtkIdType i = 0; i < m_Labels->GetNumberOfTuples(); ++i)
  {
    const auto         triangle = this->TriangleAt(i);
    const int          labels[] = { static_cast<int>(m_Labels->GetComponent(i, 0)),
                                    static_cast<int>(m_Labels->GetComponent(i, 1)) };
    std::ostringstream face;
    face << "f " << triangle[0] + 1 << ' ' << triangle[1] + 1 << ' ' << triangle[2] + 1 << '\n';
    walls << "g wall_" << labels[0] << '_' << labels[1] << '\n' << face.str();
    surfaceOf[labels[0]] += face.str();
    std::ostringstream turned;
    turned << "f " << triangle[0] + 1 << ' ' << triangle[2] + 1 << ' ' << triangle[1] + 1 << '\n';
    surfaceOf[labels[1]] += turned.str();
  }
  surfaceOf.erase(0);
  for (const auto & [label, surface] : surfaceOf)
  {
    cells << "g cell" << label << '\n' << surface;
  }
  walls.close();
  cells.close();
  this->ExpectTheSame("walls.obj");
  this->ExpectTheSame("cells.obj");
}

TEST_F(MeshesOfOthers, HaveQuads)
{
  // The faces of 2 x 2 x 2 cubes of 4 voxels each.
  const auto cubes = tissue_test::MakeImage<unsigned short>({ { 12, 12, 12 } }, [](long x, long y, long z) {
    const auto isIn = [](long i) { return i >= 2 && i < 10; };
    return isIn(x) && isIn(y) && isIn(z) ? 1 + (x >= 6) + 2 * (y >= 6) + 4 * (z >= 6) : 0;
  });
  this->WriteImage(cubes.GetPointer(), "cubes.mha");
  const vtkNew<vtkPoints>    points;
  const vtkNew<vtkCellArray> quads;
  const vtkNew<vtkIntArray>  labels;
  labels->SetName("CellIds");
  labels->SetNumberOfComponents(2);
  const auto labelAt = [](const std::array<int, 3> & cube) {
    const bool isIn = std::all_of(cube.begin(), cube.end(), [](int i) { return i >= 0 && i < 2; });
    return isIn ? 1 + cube[0] + 2 * cube[1] + 4 * cube[2] : 0;
  };
  for (int i = 0; i < 27 * 3; ++i)
  {
    const int                axis = i % 3;
    const std::array<int, 3> upper{ { i / 3 % 3, i / 9 % 3, i / 27 } };
    std::array<int, 3>       lower = upper;
    --lower[axis];
    if (labelAt(lower) != labelAt(upper))
    {
      vtkIdType ids[4];
      for (int c = 0; c < 4; ++c)
      {
        // All sides point along the axes, whichever label is the first.
        std::array<int, 3> corner = upper;
        corner[(axis + 1) % 3] += c == 1 || c == 2 ? 1 : 0;
        corner[(axis + 2) % 3] += c >= 2 ? 1 : 0;
        ids[c] = points->InsertNextPoint(1.5 + 4.0 * corner[0], 1.5 + 4.0 * corner[1], 1.5 + 4.0 * corner[2]);
      }
      quads->InsertNextCell(4, ids);
      const std::array<int, 2> sides{ { labelAt(lower), labelAt(upper) } };
      labels->InsertNextTuple2(std::max(sides[0], sides[1]), std::min(sides[0], sides[1]));
    }
  }
  const vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->GetCellData()->AddArray(labels);
  this->WriteMesh(mesh, "quads.vtp");
  ASSERT_EQ(this->Evaluate("quads.vtp cubes.mha --report report.json"), 0) << m_Errors;
  const auto report = this->ReadReport();
  EXPECT_NE(m_Errors.find("turned so that they do"), std::string::npos) << m_Errors;
  EXPECT_EQ(report["triangles"], 2 * 36);
  EXPECT_EQ(report["closedCells"], 8);
  EXPECT_LT(report["meanVolumeError"], 1e-6);
}

TEST_F(MeshesOfOthers, WithoutLabelsAreRefusedByWhatIsMissing)
{
  this->AddSide("Area", 0);
  this->WriteMesh(m_Bare, "bare.vtp");
  this->ExpectRefusal("bare.vtp tissue.mha",
                      { "bare.vtp", "BoundaryLabels", "label1 and label2", "arrays: Area of 1" });
  std::ofstream(this->PathOf("bare.stl")) << "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                             "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  this->ExpectRefusal("bare.stl tissue.mha", { "bare.stl", "no labels" });
  std::ofstream(this->PathOf("bare.ply"))
    << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  this->ExpectRefusal("bare.ply tissue.mha", { "bare.ply", "no labels" });
}
