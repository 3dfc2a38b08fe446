/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Signals, limits and faults of the system, from any phase of a program: the old output or the whole new one, and
// nothing else is left.
#include "TissueTessellationProgramTest.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <chrono>
#include <thread>

namespace
{
using Clock = std::chrono::steady_clock;

class ProgramFaultsTest : public TissueTessellationAppTest
{
protected:
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    this->WriteTissue<unsigned char>("tissue.mha");
    this->WriteLines("walls.vtp", "old");
  }

  /** Starts the program in the folder; it writes several files. */
  pid_t
  Start() const
  {
    const pid_t process = fork();
    if (process == 0)
    {
      // A shell ignores them for what runs behind it.
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGHUP, SIG_DFL);
      const bool isThere = chdir(m_Folder.c_str()) == 0;
      execl(m_Program.c_str(),
            m_Program.c_str(),
            "tissue.mha",
            "walls.vtp",
            "--cells",
            "cells.vtu",
            "--statistics",
            "cells.csv",
            "--quiet",
            "--threads",
            "2",
            static_cast<char *>(nullptr));
      _exit(isThere ? 126 : 127);
    }
    return process;
  }

  /** Ends it by a signal after a while. Returns the status of waitpid(). */
  int
  EndAfter(std::chrono::milliseconds wait, int signal, double & seconds) const
  {
    const pid_t process = this->Start();
    std::this_thread::sleep_for(wait);
    const auto begin = Clock::now();
    kill(process, signal);
    int status = 0;
    waitpid(process, &status, 0);
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return status;
  }
};

constexpr int waits[] = { 20, 60, 150, 400, 1000 };
} // namespace

TEST_F(ProgramFaultsTest, SignalsEndAtOnceAndLeaveNoTemporaryFile)
{
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    for (const int wait : waits)
    {
      this->WriteLines("walls.vtp", "old");
      std::filesystem::remove(this->PathOf("cells.vtu"));
      std::filesystem::remove(this->PathOf("cells.csv"));
      double    seconds = 0.0;
      const int status = this->EndAfter(std::chrono::milliseconds(wait), signal, seconds);
      EXPECT_TRUE(WIFSIGNALED(status) || wait > waits[1]) << signal << " after " << wait << " ms";
      if (WIFSIGNALED(status))
      {
        EXPECT_EQ(WTERMSIG(status), signal);
        EXPECT_LT(seconds, 1.0) << signal << " after " << wait << " ms";
      }
      const bool isOld = ReadBytes(this->PathOf("walls.vtp")) == "old";
      EXPECT_EQ(this->List(), isOld ? "tissue.mha walls.vtp " : "cells.csv cells.vtu tissue.mha walls.vtp ")
        << signal << " after " << wait << " ms";
    }
  }
}

TEST_F(ProgramFaultsTest, AKillLeavesTheOldFileOrTheWholeNewOne)
{
  ASSERT_EQ(this->Run("tissue.mha whole.vtp --threads 2"), 0) << m_Errors;
  const std::string whole = ReadBytes(this->PathOf("whole.vtp"));
  for (const int wait : waits)
  {
    this->WriteLines("walls.vtp", "old");
    double seconds = 0.0;
    this->EndAfter(std::chrono::milliseconds(wait), SIGKILL, seconds);
    const std::string bytes = ReadBytes(this->PathOf("walls.vtp"));
    EXPECT_TRUE(bytes == "old" || bytes == whole) << wait << " ms: " << bytes.size() << " bytes";
  }
}

TEST_F(ProgramFaultsTest, ALackOfMemoryIsALine)
{
  // 1000 x 1000 x 1000 voxels of two bytes, sparse.
  this->WriteLines(
    "large.mha",
    "ObjectType = Image\nNDims = 3\nDimSize = 1000 1000 1000\nElementType = MET_USHORT\nElementDataFile = "
    "LOCAL\n");
  std::filesystem::resize_file(this->PathOf("large.mha"), 2000001000);
  this->ExpectRefusal("large.mha walls.vtp", { "out of memory: 2000 MB more were wanted" }, "ulimit -v 1500000 &&");
}

TEST_F(ProgramFaultsTest, AFolderThatVanishesOrIsReadOnly)
{
  std::filesystem::create_directory(this->PathOf("gone"));
  const std::string remove = "{ (sleep 0.1; rm -r gone) & } &&";
  const int         code = this->Run("tissue.mha gone/walls.vtp", remove);
  EXPECT_EQ(code, 1) << "the program was done before its folder vanished";
  EXPECT_NE(m_Errors.find("Cannot write 'gone/walls.vtp'"), std::string::npos) << m_Errors;
  if (geteuid() != 0)
  {
    std::filesystem::create_directory(this->PathOf("closed"));
    ASSERT_EQ(chmod(this->PathOf("closed").c_str(), 0500), 0);
    this->ExpectRefusal("tissue.mha closed/walls.vtp", { "Cannot write 'closed/walls.vtp': Permission denied" });
  }
}
