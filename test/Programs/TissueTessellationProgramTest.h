/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationProgramTest_h
#define TissueTessellationProgramTest_h

#include "SyntheticTestTissue.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

/** Runs the main program, or another one, on images made in code, in a folder of its own. */
class TissueTessellationAppTest : public TemporaryFolderTest
{
protected:
  /** Returns the exit code; `before` is put before the program in the shell's command. */
  int
  Run(const std::string & arguments, const std::string & before = "");

  /** Writes an image of a type that TissueTessellationProgramTest.cxx lists, in the format of the name. */
  template <typename TImage>
  void
  WriteImage(const TImage * image, const std::string & name, bool isCompressed = false);

  template <typename TPixel>
  void
  WriteTissue(const std::string & name, bool isCompressed = false);

  nlohmann::json
  ReadReport() const;

  nlohmann::json
  RunAndReport(const std::string & arguments);

  /** Labels with a remark of this reason. */
  static std::set<long>
  LabelsOf(const nlohmann::json & report, const std::string & reason);

  /** Every part must be in the message. */
  void
  ExpectRefusal(const std::string & arguments, const std::vector<std::string> & parts, const std::string & before = "");

  std::string m_Program = TISSUE_TESSELLATION_PROGRAM;
  std::string m_Output;
  std::string m_Errors;
};

#endif
