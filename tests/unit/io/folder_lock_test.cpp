// A folder belongs to one run at a time; what a killed one left behind hinders nobody.
#include "io/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "support/run_program.h"

namespace marketgen {
namespace {

TEST(FolderLock, OneAtATime) {
  const ScratchFolder scratch;
  {
    const auto first = io::FolderLock::take(scratch.path());
    ASSERT_TRUE(first.ok()) << to_string(first.error());
    const auto second = io::FolderLock::take(scratch.path());
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().code, "io.in_use");
    EXPECT_NE(second.error().message.find(std::to_string(getpid())), std::string::npos)
        << second.error().message;
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / ".lock")) << "the refused one removed it";
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path())) << "it left its file behind";
  EXPECT_TRUE(io::FolderLock::take(scratch.path()).ok());
}

TEST(FolderLock, ThatOfADeadProcessIsTakenOver) {
  const ScratchFolder scratch;
  const pid_t owner = fork();
  if (owner == 0) {
    const auto held = io::FolderLock::take(scratch.path());
    raise(SIGKILL);
    _exit(held.ok() ? 0 : 1);
  }
  waitpid(owner, nullptr, 0);
  ASSERT_TRUE(std::filesystem::exists(scratch.path() / ".lock"));
  const auto taken = io::FolderLock::take(scratch.path());
  EXPECT_TRUE(taken.ok()) << to_string(taken.error());
}

TEST(FolderLock, AFolderThatIsNoneIsSaid) {
  const ScratchFolder scratch;
  EXPECT_EQ(io::FolderLock::take(scratch.path() / "none").error().code, "io.cannot_write");
}

}  // namespace
}  // namespace marketgen
