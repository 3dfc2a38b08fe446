/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueMeshEvaluationProgramTest_h
#define TissueMeshEvaluationProgramTest_h

#include "TissueTessellationProgramTest.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>
#include <vector>

/** A tissue, `tissue.mha`, and the program that judges meshes of it. */
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

#endif
