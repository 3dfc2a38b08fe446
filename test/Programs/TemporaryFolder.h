/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <string>

/** A new empty folder for each test, removed after it. */
class TemporaryFolderTest : public testing::Test
{
protected:
  void
  SetUp() override
  {
    // Its name is by chance: the same test may run elsewhere on the machine.
    std::random_device chance;
    do
    {
      m_Folder = std::filesystem::temp_directory_path() / ("TissueTessellation" + std::to_string(chance()));
    } while (!std::filesystem::create_directory(m_Folder));
  }
  void
  TearDown() override
  {
    std::filesystem::remove_all(m_Folder);
  }

  std::string
  PathOf(const std::string & name) const
  {
    return (m_Folder / name).string();
  }

  /** Names of all that is in the folder, hidden files too. */
  std::string
  List() const
  {
    std::set<std::string> names;
    for (const auto & entry : std::filesystem::directory_iterator(m_Folder))
    {
      names.insert(entry.path().filename().string());
    }
    std::string list;
    for (const std::string & name : names)
    {
      list += name + " ";
    }
    return list;
  }

  static std::string
  ReadBytes(const std::filesystem::path & path)
  {
    std::ifstream      file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
  }

  void
  WriteLines(const std::string & name, const std::string & lines) const
  {
    std::ofstream(m_Folder / name, std::ios::binary) << lines;
  }

  std::filesystem::path m_Folder;
};

#endif
