/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TemporaryFolder.h"

#include <sys/wait.h>

#include <cstdlib>

namespace
{
/** Runs the program with its output and errors in files. */
class SyntheticTissueProgram : public TemporaryFolderTest
{
protected:
  /** Returns the exit code. */
  int
  Run(const std::string & arguments)
  {
    const std::string command = std::string(SYNTHETIC_TISSUE_PROGRAM) + " --size 32 30 28 " + arguments + " > " +
                                this->PathOf("out") + " 2> " + this->PathOf("err");
    const int status = std::system(command.c_str());
    m_Output = ReadBytes(this->PathOf("out"));
    m_Errors = ReadBytes(this->PathOf("err"));
    std::filesystem::remove(this->PathOf("out"));
    std::filesystem::remove(this->PathOf("err"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void
  ExpectFailure(const std::string & arguments, const std::string & message)
  {
    EXPECT_EQ(this->Run(arguments), 1) << arguments;
    EXPECT_NE(m_Errors.find(message), std::string::npos) << arguments << ": " << m_Errors;
    EXPECT_EQ(this->List(), "") << arguments;
  }

  std::string m_Output;
  std::string m_Errors;
};
} // namespace

TEST_F(SyntheticTissueProgram, WritesTheImageAsAsked)
{
  const std::string path = this->PathOf("labels.mha");
  ASSERT_EQ(this->Run("--cells 20 --spacing 0.5 0.5 1 --pixelType uint8 " + path), 0) << m_Errors;
  EXPECT_EQ(this->List(), "labels.mha ");
  EXPECT_NE(m_Output.find("20 cells"), std::string::npos) << m_Output;
  const std::string bytes = ReadBytes(path);
  EXPECT_NE(bytes.find("DimSize = 32 30 28\n"), std::string::npos);
  EXPECT_NE(bytes.find("ElementSpacing = 0.5 0.5 1\n"), std::string::npos);
  EXPECT_NE(bytes.find("ElementType = MET_UCHAR\n"), std::string::npos);
  const std::string voxels = bytes.substr(bytes.size() - 32 * 30 * 28);
  EXPECT_EQ(std::set<char>(voxels.begin(), voxels.end()).size(), 21u) << "cells and exterior";
}

TEST_F(SyntheticTissueProgram, QuietSaysNothing)
{
  ASSERT_EQ(this->Run("--cells 20 --quiet " + this->PathOf("labels.mha")), 0);
  EXPECT_EQ(m_Output + m_Errors, "");
}

TEST_F(SyntheticTissueProgram, HasTheSameBytesForAnyNumberOfThreads)
{
  const std::string shared = "--cells 20 --shape flower --model division --seed 7 --margin 1 ";
  ASSERT_EQ(this->Run(shared + "--threads 1 " + this->PathOf("one.mha")), 0) << m_Errors;
  ASSERT_EQ(this->Run(shared + "--threads 3 " + this->PathOf("three.mha")), 0) << m_Errors;
  EXPECT_EQ(ReadBytes(this->PathOf("one.mha")), ReadBytes(this->PathOf("three.mha")));
}

TEST_F(SyntheticTissueProgram, ReplacesAnOldFileAndWritesFormatsOfDoubleExtension)
{
  std::ofstream(this->PathOf("labels.nii.gz")) << "old";
  ASSERT_EQ(this->Run("--cells 20 --compress " + this->PathOf("labels.nii.gz")), 0) << m_Errors;
  EXPECT_EQ(this->List(), "labels.nii.gz ");
  EXPECT_EQ(ReadBytes(this->PathOf("labels.nii.gz")).substr(0, 2), "\x1f\x8b") << "gzip";
}

TEST_F(SyntheticTissueProgram, RefusesBadOptions)
{
  const std::string path = this->PathOf("labels.mha");
  this->ExpectFailure("--celsl 5 " + path, "--celsl");
  this->ExpectFailure("", "labels is required");
  this->ExpectFailure("--cells 0 " + path, "--cells: Value 0 not in range 1 to");
  this->ExpectFailure("--cells many " + path, "--cells");
  this->ExpectFailure("--seed -1 " + path, "--seed: Value -1 not in range 0 to");
  this->ExpectFailure("--exteriorLabel -1 " + path, "--exteriorLabel: Value -1 not in range 0 to 4294967295");
  this->ExpectFailure("--firstLabel -1 " + path, "--firstLabel: Value -1 not in range 0 to 4294967295");
  this->ExpectFailure("--spacing 1 1 0 " + path, "--spacing: Value 0 not in range");
  this->ExpectFailure("--spacing 1 1 nan " + path, "Spacing is [1, 1, nan]");
  this->ExpectFailure("--shape ball " + path, "--shape");
  this->ExpectFailure("--model foam " + path, "--model");
  this->ExpectFailure("--pixelType float " + path, "--pixelType");
  this->ExpectFailure("--anisotropy 0.5 " + path, "--anisotropy: Value 0.5 not in range 1");
}

TEST_F(SyntheticTissueProgram, RefusesTissuesThatDoNotFit)
{
  const std::string path = this->PathOf("labels.mha");
  this->ExpectFailure("--cells 5000 " + path, "NumberOfCells is 5000");
  this->ExpectFailure("--cells 20 --margin 14 " + path, "Margin of 14");
  this->ExpectFailure("--cells 20 --pixelType uint8 --firstLabel 240 " + path, "greatest value of 255");
  this->ExpectFailure("--cells 20 --pixelType uint8 --exteriorLabel 256 " + path, "--exteriorLabel is 256");
}

TEST_F(SyntheticTissueProgram, RefusesFilesThatCannotBeWritten)
{
  this->ExpectFailure("--cells 20 " + this->PathOf("missing/labels.mha"), "there is no folder");
  this->ExpectFailure("--cells 20 " + this->PathOf("labels.xyz"), "no image format of this extension");
  this->ExpectFailure("--cells 20 " + this->PathOf("labels"), "no image format of this extension");
  this->ExpectFailure("--cells 20 " + this->PathOf("labels.png"), "cannot hold a 3-D image");
  this->ExpectFailure("--cells 20 " + this->PathOf("labels.mhd"), "two files");
}
