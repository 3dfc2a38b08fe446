/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/OutputFiles.h"

#include "Shared/Files/ImageDataFiles.h"

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

void
RemoveQuietly(const std::string & path)
{
  std::error_code ignored;
  fs::remove(path, ignored);
}

/** Makes an empty file, so that a reason that the folder has against it is known by the system's own word. */
void
CreateEmpty(const std::string & temporaryPath, const std::string & path)
{
  errno = 0;
  std::ofstream file(temporaryPath, std::ios::binary);
  if (!file)
  {
    Refuse(path, std::strerror(errno));
  }
}
} // namespace

OutputFiles::~OutputFiles()
{
  for (const File & file : m_Files)
  {
    RemoveQuietly(file.temporaryPath);
  }
}

void
OutputFiles::RequireWritable(const std::string & path)
{
  const std::string temporaryPath = MakeTemporaryPath(ResolveTarget(path));
  CreateEmpty(temporaryPath, path);
  RemoveQuietly(temporaryPath);
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
  const File     file{ MakeTemporaryPath(target), target.string() };
  for (const File & other : m_Files)
  {
    if (other.path == file.path)
    {
      Refuse(path, "another output has the same name");
    }
  }
  CreateEmpty(file.temporaryPath, path);
  m_Files.push_back(file);
  try
  {
    write(file.temporaryPath);
  }
  catch (const std::exception & error)
  {
    Refuse(path, error.what());
  }
}

void
OutputFiles::Commit()
{
  for (const File & file : m_Files)
  {
    std::error_code error;
    fs::rename(file.temporaryPath, file.path, error);
    if (error)
    {
      Refuse(file.path, error.message());
    }
  }
  m_Files.clear();
}
} // namespace tissue
