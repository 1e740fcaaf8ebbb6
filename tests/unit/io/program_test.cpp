// Outside programs: their output comes back; what goes wrong with them is an error, in time.
#include "io/program.h"

#include <gtest/gtest.h>

#include <chrono>

namespace marketgen {
namespace {

TEST(Program, AnswersItsInput) {
  const std::string large(3'000'000, 'x');  // more than any pipe holds
  EXPECT_EQ(io::run_program({"cat"}, large).value(), large);
  EXPECT_EQ(io::run_program({"/bin/echo", "two words", "$HOME"}, "").value(), "two words $HOME\n");
}

TEST(Program, OneThatDoesNotListenIsNoFault) {
  EXPECT_EQ(io::run_program({"/bin/echo", "done"}, std::string(3'000'000, 'x')).value(), "done\n");
}

TEST(Program, FailureHasItsLastWord) {
  const auto failed = io::run_program({"sh", "-c", "echo first >&2; echo reason >&2; exit 3"}, "");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().code, "program.failed");
  EXPECT_NE(failed.error().message.find("status 3: reason"), std::string::npos)
      << failed.error().message;
  EXPECT_EQ(io::run_program({"no-such-program-here"}, "").error().code, "usage.unavailable");
}

TEST(Program, LimitsEndIt) {
  const auto start = std::chrono::steady_clock::now();
  const auto slow = io::run_program({"sleep", "60"}, "", {.seconds = 0.2});
  EXPECT_EQ(slow.error().code, "program.failed");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  const auto loud = io::run_program({"yes"}, "", {.seconds = 20, .output_bytes = 1000});
  EXPECT_NE(loud.error().message.find("more than was expected"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
