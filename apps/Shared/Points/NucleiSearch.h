/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NucleiSearch_h
#define NucleiSearch_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Images/ScalarImageInput.h"
#include "itkDifferenceOfGaussiansBlobDetectionFilter.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace tissue
{
/** How nuclei are found in their image: see itk::DifferenceOfGaussiansBlobDetectionFilter. */
struct DetectionOptions
{
  double       minimumScale = 0.0;
  double       maximumScale = 0.0;
  unsigned int stepsPerOctave = 4;
  double       threshold = 0.0;
  double       relativeThreshold = 0.0;
  double       maximumOverlap = 0.5;
  double       maximumHessianRatio = 10.0;
  double       borderMargin = 0.0;
  bool         isDark = false;
};

using DetectionFilter = itk::DifferenceOfGaussiansBlobDetectionFilter<ScalarImage>;

/** Of the options that say how. */
inline const std::string DetectionGroup = "Detection";

void
AddDetectionOptions(CLI::App & app, DetectionOptions & options);

/** After a number of nuclei: what was looked for, `verb` being with or have. */
std::string
DescribeSearch(const DetectionFilter & detection, const std::string & verb);

/** What is to be said of nuclei that may be none. */
std::vector<std::string>
WarningsOf(const DetectionFilter & detection);

/** The filter, updated. */
DetectionFilter::Pointer
DetectNuclei(const ScalarImage * image, const DetectionOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
