/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VoxelFiles_h
#define VoxelFiles_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tissue
{
enum class VoxelEncoding
{
  Raw,
  /** Numbers with at least a character between them. */
  Text,
  /** Deflate, as of gzip and zlib: at most 1032 bytes of each. */
  Compressed
};

/** What the header of an image promises of its voxels, and where they are. */
struct VoxelFiles
{
  /** Adds an axis, or components. Throws std::runtime_error where the bytes cannot be counted any more. */
  void
  Multiply(std::uint64_t size);

  /** How many numbers there are, of how many bytes in memory. */
  std::uint64_t numbers = 1;
  std::uint64_t bytesOfNumber = 1;
  VoxelEncoding encoding = VoxelEncoding::Raw;
  /** Bytes before the voxels in each file, the header among them. */
  std::uint64_t skipped = 0;
  /** Of the voxels. */
  std::vector<std::filesystem::path> files;
};

/** Throws std::runtime_error where the files are shorter than the voxels need at the least. */
void
RequireVoxels(const VoxelFiles & voxels);

/** \brief The path of a file of voxels that a header names.
 *
 * Throws std::runtime_error where the name is longer than 1023 characters, leads out of the folder of the header (a
 * link there may lead anywhere), or is that of no regular file, or of the header itself. */
std::filesystem::path
FindVoxelFile(const std::filesystem::path & header, const std::string & name);

/** A name or a text of a file as a message can have it: at most 60 characters, none of which controls a terminal. */
std::string
Shorten(const std::string & text);

/** Numbers of a pattern of file names. */
struct NumberRange
{
  /** Throws std::runtime_error where the step does not lead to the last number in at most 1000000 steps. */
  void
  RequireBounded() const;

  double first = 0;
  double last = 0;
  double step = 1;
};

/** \brief The names that a pattern stands for, as "slice%03d.raw".
 *
 * Throws std::runtime_error where it has another conversion than one of a whole number of at most 99 digits. */
std::vector<std::string>
ExpandNumbers(const std::string & pattern, const NumberRange & range);
} // namespace tissue

#endif
