/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/ProgressBar.h"

#include <gtest/gtest.h>

#include <regex>

using namespace tissue;

namespace
{
/** Whose progress the test sets. */
class Worker : public itk::ProcessObject
{
public:
  using Self = Worker;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);
  itkTypeMacro(Worker, itk::ProcessObject);
};

/** What is written of two phases, the second of which takes `length` of time; on standard output for Slicer. */
std::string
Written(ProgressStyle style, std::chrono::milliseconds length)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    ProgressBar bar(style);
    const auto  worker = Worker::New();
    bar.Begin("Reading");
    bar.Observe(worker.GetPointer(), [] { return std::string("Fitting the walls"); });
    worker->UpdateProgress(0.25f);
    std::this_thread::sleep_for(length);
  }
  const std::string output = testing::internal::GetCapturedStdout();
  const std::string errors = testing::internal::GetCapturedStderr();
  EXPECT_EQ(style == ProgressStyle::Slicer ? errors : output, "");
  return style == ProgressStyle::Slicer ? output : errors;
}
} // namespace

TEST(ProgressBar, WritesLinesWithPhaseAndPercent)
{
  const std::string lines = Written(ProgressStyle::Lines, std::chrono::milliseconds(0));
  EXPECT_EQ(lines, "0 s: Reading, 0 %\n0 s: Fitting the walls, 25 %\n");
}

TEST(ProgressBar, MovesEverySecondThoughNothingIsReported)
{
  const std::string lines = Written(ProgressStyle::Lines, std::chrono::milliseconds(2500));
  EXPECT_NE(lines.find("1 s: Fitting the walls, 25 %\n2 s: Fitting the walls, 25 %\n"), std::string::npos) << lines;
}

TEST(ProgressBar, TellsSlicerThePhasesAndHowFarTheyAre)
{
  std::string text = Written(ProgressStyle::Slicer, std::chrono::milliseconds(1500));
  text = std::regex_replace(text, std::regex("[0-9.]+</filter-time>"), "T</filter-time>");
  const auto phase = [](const std::string & name, const std::string & progress) {
    return "<filter-start>\n<filter-name>" + name + "</filter-name>\n<filter-comment>" + name +
           "</filter-comment>\n</filter-start>\n" + progress + "<filter-end>\n<filter-name>" + name +
           "</filter-name>\n<filter-time>T</filter-time>\n</filter-end>\n";
  };
  EXPECT_EQ(text,
            phase("Reading", "<filter-progress>0.00</filter-progress>\n") +
              phase("Fitting the walls", "<filter-progress>0.25</filter-progress>\n"));
  EXPECT_EQ(ChooseProgressStyle("slicer"), ProgressStyle::Slicer);
}

TEST(ProgressBar, IsOneLineOnATerminal)
{
  const std::string bar = Written(ProgressStyle::Bar, std::chrono::milliseconds(0));
  EXPECT_EQ(bar.find('\n'), std::string::npos) << bar;
  EXPECT_TRUE(std::regex_search(bar, std::regex("Fitting the walls +\\[#{10} +\\]  25 %"))) << bar;
}

TEST(ProgressBar, IsSilentIfItIsToBe)
{
  EXPECT_EQ(Written(ProgressStyle::None, std::chrono::milliseconds(0)), "");
  EXPECT_EQ(ChooseProgressStyle("none"), ProgressStyle::None);
  EXPECT_EQ(ChooseProgressStyle("lines"), ProgressStyle::Lines);
  EXPECT_EQ(ChooseProgressStyle("bar"), ProgressStyle::Bar);
}
