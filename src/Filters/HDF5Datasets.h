/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef HDF5Datasets_h
#define HDF5Datasets_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** A set of numbers in a file of HDF5. */
struct HDF5Dataset
{
  /** With all its groups, "/label". */
  std::string name;
  /** Slowest axis first. */
  std::vector<std::size_t> shape;
  /** \brief What the axes are, a letter each: x, y, z, c and t, or 1 for another one.
   *
   * By the attribute axistags, as ilastik writes it. Without it three axes longer than 1 are z, y and x; one more is
   * the channels, the first of the axes or, where that is the shortest and of 4 or less, the last; two more are frames
   * and channels. */
  std::string axes;
  /** i, u or f: signed and unsigned integers, floats. */
  char        kind = 'u';
  std::size_t bytes = 1;
  /** x, y, z by the attributes element_size_um (PlantSeg) or axistags. */
  std::array<std::optional<double>, 3> voxelSize;
  /** Whether the sizes are known to be micrometres. */
  bool isInMicrometers = false;
  /** The name of a compression that this HDF5 has not; empty where it can be read. */
  std::string missingFilter;
  /** Of the numbers in the file, compressed as they are. */
  std::uint64_t storedBytes = 0;

  /** Whether what is stored can be so many numbers: a million bytes of each stored one, as of an image that is nearly
   * empty. */
  bool
  IsStored() const;

  /** Of x, y, z, c or t; 1 where there is no such axis. */
  std::size_t
  SizeOf(char axis) const;

  /** Whether it is longer than 1 along x, y and z. */
  bool
  IsVolume() const;

  /** For messages: "/label (40 x 44 x 48, uint16)". */
  std::string
  Describe() const;
};

/** All sets of numbers of a file, by their names. \throws std::runtime_error where the file is not of HDF5. */
std::vector<HDF5Dataset>
ListHDF5Datasets(const std::string & file);

/** What is read of a set: a box, of one channel and one frame. */
struct HDF5Region
{
  /** x, y, z. */
  std::array<std::size_t, 3> begin;
  std::array<std::size_t, 3> size;
  std::size_t                channel;
  std::size_t                frame;
};

/** Reads a region, x fastest, in the machine's byte order. \param pixels room for them.
 * \throws std::runtime_error where HDF5 cannot read it. */
void
ReadHDF5Region(const std::string & file, const HDF5Dataset & dataset, const HDF5Region & region, char * pixels);
} // namespace tissue

#endif
