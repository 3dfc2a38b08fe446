/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef StackLayout_h
#define StackLayout_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** \brief What the planes of a file are, by its own description: slices of channels of frames; and the size of a voxel.
 */
struct StackLayout
{
  std::size_t numberOfChannels = 1;
  std::size_t numberOfSlices = 1;
  std::size_t numberOfFrames = 1;
  /** The page of the file of each plane, channels fastest, then slices; negative where another file holds it. */
  std::vector<std::ptrdiff_t> pages;
  /** x, y, z in micrometres, where the description tells them. */
  std::array<std::optional<double>, 3> voxelSize;
  /** The unit of the resolution in the file's tags and of the distance of slices; empty: not told. */
  std::string unit;
  /** The distance of slices in `unit`. */
  std::optional<double> sliceDistance;
  /** What is to be said of it; a sentence each. */
  std::vector<std::string> warnings;

  std::ptrdiff_t
  PageOf(std::size_t channel, std::size_t slice, std::size_t frame) const
  {
    return pages[(frame * numberOfSlices + slice) * numberOfChannels + channel];
  }
};

/** An axis of the planes of a file: C, Z or T, and how many there are. */
struct StackAxis
{
  char        name;
  std::size_t size;
};

/** The layout of planes that are the pages of a file one after another, the first axis fastest. Axes that are absent
 * have a size of one. */
StackLayout
MakeStackLayout(const std::vector<StackAxis> & fastestFirst);

/** One plane of a file that has several. */
struct PlaneFormat
{
  std::size_t width;
  std::size_t height;
  /** Samples of a pixel. */
  std::size_t numberOfSamples;
};

/** \brief The layout that the description of a TIFF file tells; nothing where it tells none that is known.
 *
 * Known are those of ImageJ and Fiji ("ImageJ=..." and lines of name=value), of tifffile and scikit-image (JSON with
 * the shape, perhaps with axes), and OME-XML, see ReadOMELayout(). Where the axes of a shape have no names, the last
 * one before the rows is z and those before it are frames. Many channels (more than four) of a single slice, as
 * tifffile writes a stack whose axes it was not told, are taken for its slices, with a warning. \param fileName of the
 * file itself, without folders. \throws std::runtime_error: a description of a known kind that is broken. */
std::optional<StackLayout>
ReadStackLayout(const std::string & description, const PlaneFormat & plane, const std::string & fileName);
} // namespace tissue

#endif
