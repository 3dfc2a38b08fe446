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
 * Each file is first written under a temporary name, beside its place and with the same extension, or in a temporary
 * folder there; Commit() gives all
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

  /** \brief Writes a file of several pieces, as those of VTK's composite data sets.
   *
   * They are in a folder beside it, of its name without the extension, and are called as the folder, with `_`, a number
   * and their own extension: `a.vtm` has `a/a_0.vtp`, ... The writer makes both; the folder of a file that was there
   * before is replaced with all that is in it. */
  void
  AddWithPieces(const std::string & path, const Writer & write);

  /** Like RequireWritable(), for AddWithPieces(). Throws also where there is such a folder with other files in it,
   * which would be lost. */
  static void
  RequireWritableWithPieces(const std::string & path);

  /** Gives the files their names, in the order they were added. */
  void
  Commit();

private:
  struct File
  {
    std::string temporaryPath;
    std::string path;
  };
  void
  RequireNewName(const std::string & target, const std::string & path) const;
  static void
  Write(const Writer & write, const std::string & temporaryPath, const std::string & path);
  void
  RemoveTemporaryFolders();

  std::vector<File> m_Files;
  /** Of files with pieces. */
  std::vector<std::string> m_TemporaryFolders;
};
} // namespace tissue

#endif
