/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef FuzzTargets_h
#define FuzzTargets_h

#include <cstddef>
#include <cstdint>

/** \brief What is fed with arbitrary bytes: by libFuzzer (FuzzMain.cxx), and by a test with the files of the corpus, a
 * folder a target (FuzzCorpusGTest.cxx).
 *
 * Each turns the bytes into an input and accepts whatever the code promises to throw for a bad one. All else ends the
 * program: other exceptions, faults, what the sanitizers find. Returns 0. */
namespace tissue_test
{
/** A label image of at most 6 voxels a side, from the label to the fitted stars. */
int
FuzzLabelImage(const std::uint8_t * bytes, std::size_t size);

/** At most 30 points, from the positions to the mesh of the preset for points of the paper. */
int
FuzzPoints(const std::uint8_t * bytes, std::size_t size);

/** A table of points. */
int
FuzzPointTable(const std::uint8_t * bytes, std::size_t size);

/** The header of an image, before ITK's reader; the first byte chooses the extension. */
int
FuzzImageHeader(const std::uint8_t * bytes, std::size_t size);

/** Arguments of TissueTessellation, one a line. */
int
FuzzCommandLine(const std::uint8_t * bytes, std::size_t size);
} // namespace tissue_test

#endif
