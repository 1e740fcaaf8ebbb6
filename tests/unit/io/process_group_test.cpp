// Programs end with everything that they started: when they are ended, and when we die.
#include "io/process_group.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "io/program.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

constexpr std::array ours{-1, -1, -1};

std::vector<std::string> shell(const std::string& text) {
  return {"/bin/sh", "-c", text};
}

// The number that a script wrote into the file; waits for it.
pid_t number_in(const std::filesystem::path& file) {
  pid_t number = 0;
  for (int i = 0; i < 2000 && number == 0; ++i) {
    std::ifstream(file) >> number;
    usleep(10'000);
  }
  return number;
}

// A zombie that nobody waits for runs no more, either.
bool runs(pid_t pid) {
  const std::string about = contents_of("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t state = about.rfind(") ");
  return state != std::string::npos && about[state + 2] != 'Z' && about[state + 2] != 'X';
}

bool is_gone(pid_t pid) {
  for (int i = 0; i < 2000 && runs(pid); ++i)
    usleep(10'000);
  return !runs(pid);
}

// Starts a child of its own that sleeps, and is stuck itself.
std::vector<std::string> stuck(const ScratchFolder& scratch) {
  return shell("sleep 1000 & echo $! > " + (scratch.path() / "child").string() +
               "; while true; do true; done");
}

TEST(ProcessGroup, ItsChildrenEndWithIt) {
  const ScratchFolder scratch;
  auto group = io::ProcessGroup::start(stuck(scratch), ours);
  ASSERT_TRUE(group.ok()) << to_string(group.error());
  const pid_t child = number_in(scratch.path() / "child");
  ASSERT_TRUE(runs(child));
  EXPECT_FALSE(group->is_over());
  EXPECT_EQ(io::end_of_program(group->end()), "signal 9");
  EXPECT_TRUE(is_gone(child));
  EXPECT_EQ(io::end_of_program(group->end()), "signal 9") << "told again";
}

TEST(ProcessGroup, WhatAProgramLeavesBehindEndsToo) {
  const ScratchFolder scratch;
  auto group = io::ProcessGroup::start(
      shell("sleep 1000 & echo $! > " + (scratch.path() / "child").string() + "; exit 3"), ours);
  ASSERT_TRUE(group.ok()) << to_string(group.error());
  EXPECT_EQ(io::end_of_program(group->wait(20)), "status 3");
  EXPECT_TRUE(is_gone(number_in(scratch.path() / "child")));
}

// kill -9: nothing of ours is asked.
TEST(ProcessGroup, EndsWhenItsStarterIsKilled) {
  const ScratchFolder scratch;
  const pid_t starter = fork();
  if (starter == 0) {
    const auto group = io::ProcessGroup::start(stuck(scratch), ours);
    pause();
    _exit(group.ok() ? 0 : 1);
  }
  const pid_t child = number_in(scratch.path() / "child");
  ASSERT_TRUE(runs(child));
  kill(starter, SIGKILL);
  waitpid(starter, nullptr, 0);
  EXPECT_TRUE(is_gone(child));
}

TEST(ProcessGroup, OneThatLeavesItsGroupIsEndedAllTheSame) {
  auto group = io::ProcessGroup::start({"setsid", "sleep", "1000"}, ours);
  ASSERT_TRUE(group.ok()) << to_string(group.error());
  EXPECT_EQ(io::end_of_program(group->wait(0.3)), "signal 9");
}

// A session of its own, with the program as its parent and as nobody's child; and what has nothing
// to do with the group goes on.
TEST(ProcessGroup, ChildrenThatLeaveItsGroupEndWithIt) {
  const ScratchFolder scratch;
  const std::string child = (scratch.path() / "child").string(),
                    daemon = (scratch.path() / "daemon").string();
  const pid_t other = fork();
  if (other == 0) {
    setsid();
    while (true)
      pause();
  }
  auto group = io::ProcessGroup::start(
      shell("setsid sleep 1000 & echo $! > " + child + "; setsid -f sh -c 'echo $$ > " + daemon +
            "; exec sleep 1000'; while true; do true; done"),
      ours);
  ASSERT_TRUE(group.ok()) << to_string(group.error());
  const pid_t with_parent = number_in(child), without = number_in(daemon);
  ASSERT_TRUE(runs(with_parent) && runs(without));
  EXPECT_EQ(io::end_of_program(group->wait(0.3)), "signal 9");
  EXPECT_FALSE(runs(with_parent));
  EXPECT_FALSE(runs(without));
  EXPECT_TRUE(runs(other));
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
}

TEST(ProcessGroup, WhatCannotBeStartedIsSaid) {
  const auto group = io::ProcessGroup::start({"no-such-program-here"}, ours);
  ASSERT_FALSE(group.ok());
  EXPECT_EQ(group.error().code, "usage.unavailable");
}

TEST(Program, AChildThatOutlivesItsLimitIsEnded) {
  const ScratchFolder scratch;
  const auto slow = io::run_program(stuck(scratch), "", {.seconds = 0.5});
  EXPECT_EQ(slow.error().code, "program.failed");
  EXPECT_TRUE(is_gone(number_in(scratch.path() / "child")));
}

io::ProcessGroup started(const std::string& text) {
  auto group = io::ProcessGroup::start(shell(text), ours);
  if (!group.ok()) fatal(to_string(group.error()).c_str());
  return std::move(group).value();
}

// Within a minute, on however busy a machine.
bool comes_to_use(const io::ProcessGroup& group, double cpu_s) {
  for (int i = 0; i < 6000 && group.cpu_s() < cpu_s; ++i)
    usleep(10'000);
  return group.cpu_s() >= cpu_s;
}

TEST(ProcessGroup, ProcessorTimeIsWhatItComputesAndNotWhatItWaits) {
  const io::ProcessGroup waits = started("exec sleep 1000");
  io::ProcessGroup computes = started("while :; do :; done");
  EXPECT_TRUE(comes_to_use(computes, 0.3));
  EXPECT_LT(waits.cpu_s(), 0.1);
  computes.end();
  EXPECT_EQ(computes.cpu_s(), 0);
}

TEST(ProcessGroup, ProcessorTimeOfChildrenCountsOnceTheyWereWaitedFor) {
  const io::ProcessGroup waits =
      started("/bin/sh -c 'i=0; while [ $i -lt 2000000 ]; do i=$((i+1)); done'; exec sleep 1000");
  EXPECT_TRUE(comes_to_use(waits, 0.1));
}

}  // namespace
}  // namespace marketgen
