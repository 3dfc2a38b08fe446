/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OutputFiles_h
#define OutputFiles_h

#include <functional>
#include <string>
#include <vector>

namespace tissue
{
/** \brief Output files that appear complete and together, or not at all.
 *
 * Each file is first written under a temporary name, beside its place and with the same extension; Commit() gives all
 * of them their names. What was not committed is removed by the destructor. A file that was there before is replaced; a
 * symbolic link stays, and its target is replaced. Errors are std::runtime_error: what, path, why. */
class OutputFiles
{
public:
  /** Writes a file of the given path, or throws. */
  using Writer = std::function<void(const std::string & path)>;

  OutputFiles() = default;
  OutputFiles(const OutputFiles &) = delete;
  OutputFiles &
  operator=(const OutputFiles &) = delete;
  ~OutputFiles();

  /** Throws where a file could not be written to this path. Leaves nothing behind; to be called before the work. */
  static void
  RequireWritable(const std::string & path);

  /** Throws where the path is that of an input, or of the voxels of an image of several files, which would be lost. */
  static void
  RequireNotInput(const std::string & path, const std::string & input);

  /** Writes a file that Commit() will name `path`; no two may have the same. */
  void
  Add(const std::string & path, const Writer & write);

  /** Gives the files their names, in the order of Add(). */
  void
  Commit();

private:
  struct File
  {
    std::string temporaryPath;
    std::string path;
  };
  std::vector<File> m_Files;
};
} // namespace tissue

#endif
