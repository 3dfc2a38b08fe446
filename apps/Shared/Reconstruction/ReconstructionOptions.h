/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionOptions_h
#define ReconstructionOptions_h

#include "TissueTessellationCore/Common/Types.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** How an image of membranes is segmented. */
struct MembraneOptions
{
  /** Empty: there is none. */
  std::string file;
  /** Of the smoothing before the watershed, in physical units; 0: none. */
  double sigma = 0.0;
  /** See itk::MembraneToTissueLabelImageFilter. */
  double markerSigma = 0.0;
  double markerDepth = 0.015;
};

/** What the user asked of the program. */
struct ReconstructionOptions
{
  /** The segmented image; of other programs what they take the cells from. */
  std::string labels;
  std::string walls;
  std::string complex;
  std::string cells;
  std::string statistics;
  std::string junctions;
  std::string report;
  std::string picture;

  std::optional<Label>                 exteriorLabel;
  bool                                 zeroIsCell = false;
  std::optional<std::array<double, 3>> spacing;
  /** Widest gap to close, in physical units; 0 for the automatic width. */
  std::optional<double> closeGaps;

  MembraneOptions membrane;
  /** A label image that judges the stages of the complex; empty: none. */
  std::string evaluateAgainst;
  bool        evaluateByLabel = false;
  /** Further files that are read. */
  std::vector<std::string> otherInputs;

  std::string              preset = "default";
  ReconstructionParameters parameters;

  unsigned int threads = 0;
  bool         isQuiet = false;
  /** Whether the image is wanted beside what is found in it; no option of the command line. */
  bool keepsImage = false;

  struct Output
  {
    std::string path;
    /** In words. */
    std::string content;
  };

  /** The file that the cells are from, for messages. */
  const std::string &
  MainInput() const
  {
    return labels.empty() ? membrane.file : labels;
  }

  /** All files that are read. */
  std::vector<std::string>
  Inputs() const;

  /** All files that are to be written. */
  std::vector<Output>
  Outputs() const;
};
} // namespace tissue

#endif
