// Interrupts: in children of this test, which a signal may end.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/progress.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

struct Ended {
  int status = -1;  // 128 + number when a signal ended it
  double after_s = 0;
};

// What becomes of a process that does `work` and is sent `number` twice at most, `signals` times.
template <class Work>
Ended ended_by(int number, int signals, const Work& work) {
  int ready[2];
  if (pipe(ready) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    watch_for_interrupts();
    [[maybe_unused]] const ssize_t told = write(ready[1], "!", 1);
    _exit(work());
  }
  char byte = 0;
  [[maybe_unused]] const ssize_t heard = read(ready[0], &byte, 1);
  close(ready[0]);
  close(ready[1]);
  const double start_s = monotonic_seconds();
  for (int i = 0; i < signals; ++i) {
    kill(child, number);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // two at once are one
  }
  int state = 0;
  waitpid(child, &state, 0);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state),
          monotonic_seconds() - start_s};
}

constexpr double generous_s = 10;  // for a second of grace, on a busy machine

int wait_for_ever() {
  while (true)
    pause();
}

TEST(Interrupts, EverySignalIsAskedForByWork) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const Ended ended = ended_by(number, 1, [] {
      while (check_interrupt().ok())
        usleep(1000);
      return 7;  // clean: before the end by force
    });
    EXPECT_EQ(ended.status, 7) << number;
  }
}

TEST(Interrupts, WorkThatDoesNotAskIsEndedByForce) {
  const Ended ended = ended_by(SIGTERM, 1, wait_for_ever);
  EXPECT_EQ(ended.status, 130);
  EXPECT_LT(ended.after_s, generous_s);
}

TEST(Interrupts, TheSecondSignalWaitsForNothing) {
  const Ended ended = ended_by(SIGINT, 2, wait_for_ever);
  EXPECT_EQ(ended.status, 130);
}

TEST(Interrupts, LeftoversGoWithTheForcedEnd) {
  const fs::path folder =
      fs::temp_directory_path() / ("marketgen-interrupt-" + std::to_string(getpid()));
  fs::create_directories(folder / "draft/deep");
  std::ofstream(folder / "draft/deep/file") << "half";
  std::ofstream(folder / "kept") << "whole";
  const Ended ended = ended_by(SIGHUP, 1, [&] {
    add_leftover(folder / "draft");
    add_leftover(folder / "kept");
    drop_leftover(folder / "kept");
    return wait_for_ever();
  });
  EXPECT_EQ(ended.status, 130);
  EXPECT_FALSE(fs::exists(folder / "draft"));
  EXPECT_TRUE(fs::exists(folder / "kept"));
  fs::remove_all(folder);
}

TEST(Interrupts, WhatIsPutInPlaceTogetherIsNotCutInTwo) {
  const Ended ended = ended_by(SIGINT, 1, [] {
    const NoForcedEnd together;
    std::this_thread::sleep_for(interrupt_grace + std::chrono::milliseconds(200));
    _exit(7);
    return 0;
  });
  EXPECT_EQ(ended.status, 7);
}

// A loop of a million years ends; its error comes out where the work began.
TEST(Interrupts, ParallelLoopsStopBetweenTwoIndices) {
  const Ended ended = ended_by(SIGINT, 1, [] {
    const Result<void> done = until_interrupted([]() -> Result<void> {
      parallel_for(std::size_t{1} << 40, [](std::size_t) { usleep(1000); });
      return {};
    });
    return !done.ok() && done.error().code == "internal.interrupted" ? 7 : 8;
  });
  EXPECT_EQ(ended.status, 7);
}

TEST(Interrupts, AHostIsToldAndTheFlagPutDown) {
  static int told = 0;
  told = 0;
  const auto before = std::signal(SIGINT, [](int) { ++told; });
  {
    const InterruptWatch watch;
    std::raise(SIGINT);
    EXPECT_EQ(check_interrupt().error().code, "internal.interrupted");
    EXPECT_THROW(interrupt_point(), Interrupted);
    EXPECT_EQ(told, 0);
  }
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(check_interrupt().ok());
  std::signal(SIGINT, before);
}

// `| head` closes the pipe: an error of write(), which leaves time to tidy up.
TEST(Interrupts, AClosedPipeIsAnErrorNotAnEnd) {
  const Ended ended = ended_by(0, 0, [] {
    int ends[2];
    if (pipe(ends) != 0) return 8;
    close(ends[0]);
    return write(ends[1], "!", 1) < 0 && errno == EPIPE ? 7 : 9;
  });
  EXPECT_EQ(ended.status, 7);
}

}  // namespace
}  // namespace marketgen
