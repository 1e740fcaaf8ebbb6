// What many share is made once, by its type and key; what could not be made is tried again.
#include "base/shared_objects.h"

#include <gtest/gtest.h>

#include <atomic>

#include "base/parallel.h"

namespace marketgen {
namespace {

TEST(SharedObjects, AreMadeOnceHoweverManyAskAtATime) {
  SharedObjects shared;
  std::atomic<int> made = 0;
  const auto make = [&]() -> Result<std::shared_ptr<int>> {
    ++made;
    return std::make_shared<int>(7);
  };
  const auto got =
      parallel_map(16, [&](std::size_t) { return shared.get<int>("seven", make).value(); });
  EXPECT_EQ(made, 1);
  for (const auto& one : got)
    EXPECT_EQ(one, got.front());
  EXPECT_NE(shared.get<int>("another", make).value(), got.front());
  const auto constant = shared.get<const int>("seven", [&]() -> Result<std::shared_ptr<const int>> {
    return std::make_shared<const int>(8);
  });
  EXPECT_EQ(**constant, 8) << "of another type";
}

TEST(SharedObjects, AnErrorIsNotKept) {
  SharedObjects shared;
  const auto failed = shared.get<int>("seven", []() -> Result<std::shared_ptr<int>> {
    return Error{"io.cannot_read", "disk", "is asleep"};
  });
  EXPECT_EQ(failed.error().code, "io.cannot_read");
  const auto again = shared.get<int>(
      "seven", []() -> Result<std::shared_ptr<int>> { return std::make_shared<int>(7); });
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(**again, 7);
}

}  // namespace
}  // namespace marketgen
