/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MembraneInput_h
#define MembraneInput_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Images/ScalarImageInput.h"
#include "Shared/Reconstruction/JunctionInput.h"
#include "Shared/Reconstruction/TissueInput.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

namespace tissue
{
/** How an image of membranes is segmented: see itk::MembraneToTissueLabelImageFilter. */
struct MembraneOptions
{
  /** Empty: there is none. */
  std::string  file;
  ImageOptions image;
  /** Of the smoothing before the watershed, in physical units; 0: none. */
  double sigma = 0.0;
  /** Of the smoothing for the minima, in physical units; 0: by a voxel. */
  double markerSigma = 0.0;
  /** Least depth of a minimum, of the range of intensities; 0 .. 1. */
  double markerDepth = 0.015;
  /** Least depth of a minimum over the deviation of the smoothed image's noise. */
  double noiseDepth = 3.0;
  /** Membranes are darker than the cells. */
  bool isDark = false;
};

/** Adds the options that all programs have of it. \param dark the names of the flag for dark membranes. */
void
AddMembraneOptions(CLI::App & app, const std::string & dark, MembraneOptions & options);

/** The options for the report, if there is such an image. */
void
AddToJson(const MembraneOptions & options, nlohmann::ordered_json & json);

/** What is made of images of membranes and of points; 0 is the exterior. */
using TissueLabelImage = itk::Image<std::uint32_t, 3>;

/** The image of a stain, and what is to be said of it. */
struct Stain
{
  ScalarImage::Pointer     image;
  ImageDescription         description;
  std::vector<std::string> warnings;
  double                   readSeconds = 0.0;
};

/** \throws FileError as ReadScalarImage(). */
Stain
ReadStain(const std::string & path, const ImageOptions & options);

struct MembraneSegmentation
{
  TissueLabelImage::Pointer labels;
  MembraneMinima            minima;
  double                    seconds = 0.0;
};

/** The cells of an image of membranes. \param cells where they are, about; null: the image's minima tell.
 * \throws itk::ExceptionObject as the filter. */
MembraneSegmentation
SegmentMembranes(const ScalarImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress);

/** Reads the image of membranes and extracts the junctions of the cells that its minima tell.
 * \throws FileError as ReadStain() and ExtractTissue(). */
TissueInput
ReadMembranes(const MembraneOptions & options, const JunctionOptions & junctionOptions, ProgressBar & progress);
} // namespace tissue

#endif
