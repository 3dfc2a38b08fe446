/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/NucleiSearch.h"

#include "Shared/CommandLine/OptionChecks.h"

#include <sstream>

namespace tissue
{
void
AddDetectionOptions(CLI::App & app, DetectionOptions & options)
{
  const auto positive = InRange(0.0, 1e12);
  app
    .add_option("--minimumScale",
                options.minimumScale,
                "Standard deviation of the smallest nuclei, in the image's units: their radius over 1.73; 0, and so "
                "--maximumScale: both are found from the image")
    ->group(DetectionGroup)
    ->check(positive);
  app.add_option("--maximumScale", options.maximumScale, "Standard deviation of the largest nuclei")
    ->group(DetectionGroup)
    ->check(positive);
  app.add_option("--stepsPerOctave", options.stepsPerOctave, "Scales for each doubling")
    ->group(DetectionGroup)
    ->check(InRange(1, 64));
  app.add_option("--threshold", options.threshold, "Least response, in the image's units; 0: see the next")
    ->group(DetectionGroup)
    ->check(positive);
  app
    .add_option("--relativeThreshold",
                options.relativeThreshold,
                "Least response relative to the greatest; 0: found from the noise and all responses")
    ->group(DetectionGroup)
    ->check(InRange(0.0, 0.999));
  app
    .add_option("--maximumOverlap",
                options.maximumOverlap,
                "Greatest share of the smaller of two nuclei that they have in common")
    ->group(DetectionGroup)
    ->check(InRange(0.0, 1.0));
  app
    .add_option("--maximumHessianRatio",
                options.maximumHessianRatio,
                "Greatest elongation, as the ratio of the Hessian's eigenvalues; 0: any")
    ->group(DetectionGroup)
    ->check(positive);
  app
    .add_option(
      "--borderMargin", options.borderMargin, "Leave out nuclei nearer to the border of the image, in its units")
    ->group(DetectionGroup)
    ->check(positive);
  app.add_flag("--dark", options.isDark, "Nuclei are darker than what is around them")->group(DetectionGroup);
}

std::string
DescribeSearch(const DetectionFilter & detection, const std::string & verb)
{
  std::ostringstream text;
  if (!(detection.GetUsedMaximumScale() > 0.0))
  {
    text << ", nor any blob that tells their scales";
    if (detection.GetNoise() > 0.0)
    {
      text << " and exceeds the noise, of deviation " << detection.GetNoise()
           << " (--threshold takes weaker ones, --dark darker ones)";
    }
    return text.str();
  }
  text << " of scales from " << detection.GetUsedMinimumScale() << " to " << detection.GetUsedMaximumScale() << ' '
       << verb << " a response of " << detection.GetUsedThreshold() << " or more";
  return text.str();
}

std::vector<std::string>
WarningsOf(const DetectionFilter & detection)
{
  if (!detection.GetHasWeakEvidence())
  {
    return {};
  }
  const auto number = detection.GetOutput()->GetNumberOfPoints();
  return { "weak evidence: the image has dark blobs as strong as the bright ones, as noise has; the " +
           std::to_string(number) + " that are stronger than all of the others are taken (--threshold takes more)" };
}

DetectionFilter::Pointer
DetectNuclei(const ScalarImage * image, const DetectionOptions & options, ProgressBar & progress)
{
  const auto detection = DetectionFilter::New();
  detection->SetInput(image);
  detection->SetMinimumScale(options.minimumScale);
  detection->SetMaximumScale(options.maximumScale);
  detection->SetStepsPerOctave(options.stepsPerOctave);
  detection->SetThreshold(options.threshold);
  detection->SetRelativeThreshold(options.relativeThreshold);
  detection->SetMaximumOverlap(options.maximumOverlap);
  detection->SetMaximumHessianRatio(options.maximumHessianRatio);
  detection->SetBorderMargin(options.borderMargin);
  detection->SetDarkBlobs(options.isDark);
  progress.Begin("Detecting");
  progress.Observe(detection);
  detection->Update();
  return detection;
}
} // namespace tissue
