/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FuzzTargets.h"
#include "Shared/Images/MetaImageHeader.h"
#include "Shared/Images/NiftiHeader.h"
#include "Shared/Images/NrrdHeader.h"
#include "Shared/Points/PointTable.h"
#include "TissueTessellation/TissueTessellationOptions.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace tissue_test
{
namespace
{
/** Does what may throw any exception of the standard. */
template <typename TWork>
int
Accept(const TWork & work)
{
  try
  {
    work();
  }
  catch (const std::exception &)
  {
    // It is said in a line.
  }
  return 0;
}
} // namespace

int
FuzzPointTable(const std::uint8_t * bytes, std::size_t size)
{
  std::istringstream stream(std::string(bytes, bytes + size));
  return Accept([&stream] { tissue::ReadPointTable(stream, tissue::PointFileOptions()); });
}

int
FuzzImageHeader(const std::uint8_t * bytes, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const char * const extensions[] = { ".mha", ".nrrd", ".nii" };
  const std::string  name = "fuzz" + std::to_string(getpid()) + extensions[bytes[0] % 3];
  const std::string  path = (std::filesystem::temp_directory_path() / name).string();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char *>(bytes) + 1, static_cast<long>(size) - 1);
  Accept([&path] { tissue::IsMetaImage(path) ? tissue::RequireSoundMetaImage(path) : void(); });
  Accept([&path] { tissue::IsNrrd(path) ? tissue::RequireSoundNrrd(path) : void(); });
  Accept([&path] { tissue::RequireSoundNifti(path); });
  std::filesystem::remove(path);
  return 0;
}

int
FuzzCommandLine(const std::uint8_t * bytes, std::size_t size)
{
  std::istringstream       stream(std::string(bytes, bytes + size));
  std::vector<std::string> words{ "TissueTessellation" };
  for (std::string word; std::getline(stream, word);)
  {
    words.push_back(word);
  }
  std::vector<char *> arguments;
  for (std::string & word : words)
  {
    arguments.push_back(word.data());
  }
  return Accept([&] { tissue::ParseCommandLine(static_cast<int>(arguments.size()), arguments.data()); });
}
} // namespace tissue_test
