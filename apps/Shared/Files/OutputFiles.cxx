/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/OutputFiles.h"

#include "Shared/Files/ImageDataFiles.h"
#include "Shared/Files/TemporaryFiles.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void
Refuse(const std::string & path, const std::string & why)
{
  throw std::runtime_error("Cannot write '" + path + "': " + why);
}

/** A name beside the path that no file has. */
std::string
MakeTemporaryPath(const fs::path & path)
{
  for (int attempt = 0;; ++attempt)
  {
    // The whole name is kept: writers go by the extension, which may be double.
    const std::string name = ".part" + std::to_string(attempt) + "." + path.filename().string();
    const fs::path    temporary = path.parent_path() / name;
    std::error_code   error;
    if (!fs::exists(fs::symlink_status(temporary, error)))
    {
      return temporary.string();
    }
  }
}

/** Where the file goes: the path itself, or what it links to. Throws where something else than a file is there. */
fs::path
ResolveTarget(const std::string & path)
{
  std::error_code error;
  fs::path        target = fs::absolute(path, error);
  if (!error)
  {
    target = fs::weakly_canonical(target, error);
  }
  if (error)
  {
    Refuse(path, error.message());
  }
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    Refuse(path, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  const fs::path folder = target.parent_path();
  if (!fs::is_directory(folder, error))
  {
    Refuse(path, "there is no folder '" + folder.string() + "'");
  }
  return target;
}

/** The folder of the pieces of a file. */
fs::path
PiecesFolderOf(const fs::path & path)
{
  return path.parent_path() / path.stem();
}

/** Whether all that there is under the name of the folder is such a folder, with pieces. */
void
RequirePiecesAlone(const fs::path & folder, const std::string & path)
{
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error)))
  {
    return;
  }
  if (!fs::is_directory(fs::symlink_status(folder, error)))
  {
    Refuse(path, "'" + folder.string() + "', where its pieces go, is no folder");
  }
  const std::string beginning = folder.filename().string() + "_";
  for (const auto & entry : fs::directory_iterator(folder))
  {
    const std::string stem = entry.path().stem().string();
    const bool        isPiece = stem.rfind(beginning, 0) == 0 && stem.size() > beginning.size() &&
                         stem.find_first_not_of("0123456789", beginning.size()) == std::string::npos;
    if (!isPiece || !entry.is_regular_file())
    {
      Refuse(path,
             "the folder of its pieces, '" + folder.string() + "', has '" + entry.path().filename().string() +
               "', which is none and would be lost");
    }
  }
}

/** Makes an empty temporary file, so that a reason that the folder has against it is known by the system's own word.
 * Returns its name. */
std::string
MakeTemporaryFile(const fs::path & target, const std::string & path)
{
  TemporaryFiles &  temporaryFiles = TemporaryFiles::GetInstance();
  const auto        lock = temporaryFiles.Hold();
  const std::string temporaryPath = MakeTemporaryPath(target);
  temporaryFiles.Add(temporaryPath);
  errno = 0;
  std::ofstream file(temporaryPath, std::ios::binary);
  if (!file)
  {
    const std::string reason = std::strerror(errno);
    temporaryFiles.Forget(temporaryPath);
    Refuse(path, reason);
  }
  return temporaryPath;
}

/** Makes a temporary folder beside the target. Returns its name. */
fs::path
MakeTemporaryFolder(const fs::path & target, const std::string & path)
{
  TemporaryFiles & temporaryFiles = TemporaryFiles::GetInstance();
  const auto       lock = temporaryFiles.Hold();
  const fs::path   temporary = MakeTemporaryPath(target);
  temporaryFiles.Add(temporary.string());
  std::error_code error;
  if (!fs::create_directory(temporary, error))
  {
    temporaryFiles.Forget(temporary.string());
    Refuse(path, error.message());
  }
  return temporary;
}
} // namespace

OutputFiles::~OutputFiles()
{
  for (const File & file : m_Files)
  {
    TemporaryFiles::GetInstance().Remove(file.temporaryPath);
  }
  this->RemoveTemporaryFolders();
}

void
OutputFiles::RemoveTemporaryFolders()
{
  for (const std::string & folder : m_TemporaryFolders)
  {
    TemporaryFiles::GetInstance().Remove(folder);
  }
  m_TemporaryFolders.clear();
}

void
OutputFiles::RequireWritable(const std::string & path)
{
  TemporaryFiles::GetInstance().Remove(MakeTemporaryFile(ResolveTarget(path), path));
}

void
OutputFiles::RequireWritableWithPieces(const std::string & path)
{
  RequireWritable(path);
  RequirePiecesAlone(PiecesFolderOf(ResolveTarget(path)), path);
}

void
OutputFiles::RequireNotInput(const std::string & path, const std::string & input)
{
  std::error_code isOther;
  if (fs::equivalent(path, input, isOther))
  {
    Refuse(path, "it is the input");
  }
  for (const std::string & file : FindImageDataFiles(input))
  {
    if (fs::equivalent(path, file, isOther))
    {
      Refuse(path, "it holds the voxels of the input '" + input + "'");
    }
  }
}

void
OutputFiles::Add(const std::string & path, const Writer & write)
{
  const fs::path target = ResolveTarget(path);
  this->RequireNewName(target.string(), path);
  const File file{ MakeTemporaryFile(target, path), target.string() };
  m_Files.push_back(file);
  Write(write, file.temporaryPath, path);
}

void
OutputFiles::AddWithPieces(const std::string & path, const Writer & write)
{
  const fs::path target = ResolveTarget(path);
  const fs::path pieces = PiecesFolderOf(target);
  this->RequireNewName(target.string(), path);
  RequirePiecesAlone(pieces, path);
  const fs::path temporary = MakeTemporaryFolder(target, path);
  m_TemporaryFolders.push_back(temporary.string());
  const std::string file = (temporary / target.filename()).string();
  Write(write, file, path);
  // The file comes last: it names the pieces.
  m_Files.push_back({ (temporary / pieces.filename()).string(), pieces.string() });
  m_Files.push_back({ file, target.string() });
}

void
OutputFiles::RequireNewName(const std::string & target, const std::string & path) const
{
  for (const File & other : m_Files)
  {
    if (other.path == target)
    {
      Refuse(path, "another output has the same name");
    }
  }
}

void
OutputFiles::Write(const Writer & write, const std::string & temporaryPath, const std::string & path)
{
  try
  {
    write(temporaryPath);
  }
  catch (const std::exception & error)
  {
    Refuse(path, error.what());
  }
}

void
OutputFiles::Commit()
{
  TemporaryFiles & temporaryFiles = TemporaryFiles::GetInstance();
  const auto       lock = temporaryFiles.Hold();
  for (const File & file : m_Files)
  {
    std::error_code error;
    if (fs::is_directory(file.temporaryPath, error) && fs::exists(file.path, error))
    {
      // No folder can take the place of another: that of before goes to the temporary ones, and with them.
      fs::rename(file.path, file.temporaryPath + ".before", error);
    }
    fs::rename(file.temporaryPath, file.path, error);
    if (error)
    {
      Refuse(file.path, error.message());
    }
    temporaryFiles.Forget(file.temporaryPath);
  }
  m_Files.clear();
  this->RemoveTemporaryFolders();
}
} // namespace tissue
