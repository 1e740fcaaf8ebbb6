#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>

#include "base/call_interrupt.h"
#include "base/hash.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "base/result.h"
#include "base/seed.h"
#include "base/text.h"

namespace marketgen {
namespace {

TEST(Hash, MatchesThePublishedXxh3Vectors) {
  // XXH3_64bits of the empty input with seed 0, from xxHash's own sanity checks.
  EXPECT_EQ(hash64(""), 0x2D06800538D394C2ULL);
}

TEST(Hasher, LengthsKeepNeighboursApart) {
  EXPECT_NE(Hasher().add("ab").add("c").hex(), Hasher().add("a").add("bc").hex());
}

TEST(Hasher, RoundingHidesNoiseBelowTheStep) {
  EXPECT_EQ(Hasher().add_rounded(1.0, 1e-5).hex(), Hasher().add_rounded(1.0 + 1e-9, 1e-5).hex());
  EXPECT_NE(Hasher().add_rounded(1.0, 1e-5).hex(), Hasher().add_rounded(1.0 + 2e-5, 1e-5).hex());
}

TEST(Seed, ChildrenDoNotDependOnOtherDraws) {
  const Seed seed(7);
  Stream a = seed.child("shelf_fill", "dairy/run-1").stream();
  Stream noise = seed.child("other").stream();
  noise.bits();
  Stream b = seed.child("shelf_fill", "dairy/run-1").stream();
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(a.bits(), b.bits());
  EXPECT_NE(seed.child("x").value(), seed.child("y").value());
  EXPECT_NE(seed.child("x", 0).value(), seed.child("x", 1).value());
}

TEST(Stream, UniformHasTheRightMomentsAndRange) {
  Stream draw = Seed(1).stream();
  double sum = 0, squares = 0;
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const double u = draw.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 0.005);  // 5 sigma
  EXPECT_NEAR(squares / n - 0.25, 1.0 / 12.0, 0.005);
}

TEST(Stream, IntegerReachesBothEndsAndNothingElse) {
  Stream draw = Seed(2).stream();
  std::set<int> seen;
  for (int i = 0; i < 1000; ++i)
    seen.insert(draw.integer(-2, 3));
  EXPECT_EQ(seen, (std::set<int>{-2, -1, 0, 1, 2, 3}));
}

TEST(Stream, WeightedIgnoresZeroWeights) {
  Stream draw = Seed(3).stream();
  const double weights[] = {0, 2, 0, 1};
  int ones = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t k = draw.weighted(weights);
    ASSERT_TRUE(k == 1 || k == 3);
    ones += k == 1;
  }
  EXPECT_NEAR(ones, 2000, 150);
}

TEST(Parallel, EverySlotIsWrittenOnceForAnyThreadCount) {
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    const auto squares = parallel_map(
        1000, [](std::size_t i) { return i * i; }, 7);
    for (std::size_t i = 0; i < squares.size(); ++i)
      ASSERT_EQ(squares[i], i * i);
  }
}

// Threads that take part in a loop long enough for each to wake up.
std::size_t threads_at_work() {
  std::mutex adding;
  std::set<std::thread::id> seen;
  parallel_for(64, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::scoped_lock lock(adding);
    seen.insert(std::this_thread::get_id());
  });
  return seen.size();
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const int before = thread_count();
  {
    const ThreadLimit limit(1);
    EXPECT_EQ(thread_count(), 1);
    EXPECT_EQ(threads_at_work(), 1U);
  }
  EXPECT_EQ(thread_count(), before);
  EXPECT_GE(before == 1 ? 2U : threads_at_work(), 2U);
  const ThreadLimit none(0);
  EXPECT_EQ(thread_count(), before);
}

TEST(CallInterrupt, StopsOneCallAndTheLoopsInIt) {
  std::atomic<bool> stop = true;
  // How many rounds of a loop were not done.
  const auto stopped = [] {
    std::atomic<int> done = 0;
    const Result<void> all = until_interrupted([&]() -> Result<void> {
      parallel_for(64, [&](std::size_t) { ++done; });
      return {};
    });
    EXPECT_EQ(all.ok(), done == 64);
    return 64 - done;
  };
  int elsewhere = -1;
  {
    const CallInterrupt call(&stop);
    EXPECT_EQ(stopped(), 64);
    std::thread([&] { elsewhere = stopped(); }).join();
    const CallInterrupt inner(nullptr);
    EXPECT_TRUE(check_interrupt().ok());
  }
  EXPECT_EQ(elsewhere, 0);
  EXPECT_EQ(stopped(), 0);
}

TEST(Parallel, EveryParticipantFlushesDenormals) {
  const auto flushed = parallel_map(256, [](std::size_t) {
    volatile double tiny = 1e-310;  // denormal
    return tiny * 1.0 == 0.0;
  });
  for (const bool f : flushed)
    EXPECT_TRUE(f);
}

TEST(Text, EditDistanceKnowsTranspositions) {
  EXPECT_EQ(edit_distance("tiers", "levels"), 4);
  EXPECT_EQ(edit_distance("diary", "dairy"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Text, NearestNameNeedsToBeNear) {
  const std::string_view names[] = {"levels", "facings", "fill"};
  EXPECT_EQ(nearest_name("level", names), "levels");
  EXPECT_EQ(nearest_name("Facing", names), "facings");
  EXPECT_EQ(nearest_name("temperature", names), std::nullopt);
}

TEST(Text, Utf8RejectsWhatUnicodeForbids) {
  EXPECT_TRUE(is_utf8("Käse 牛奶 🧀"));
  EXPECT_FALSE(is_utf8("\xff\xfe"));
  EXPECT_FALSE(is_utf8("\xc0\xaf"));          // overlong
  EXPECT_FALSE(is_utf8("\xed\xa0\x80"));      // surrogate
  EXPECT_FALSE(is_utf8("\xf4\x90\x80\x80"));  // beyond U+10FFFF
  EXPECT_FALSE(is_utf8("abc\xe2\x82"));       // cut short
}

TEST(Text, ThousandsAreSeparated) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1204112), "1,204,112");
  EXPECT_EQ(with_thousands(-1000), "-1,000");
}

Result<int> half(int n) {
  if (n % 2 != 0) return Error{"test.odd", "n", "is odd"};
  return n / 2;
}
Result<int> quarter(int n) {
  MARKETGEN_TRY(const int h, half(n));
  return half(h);
}

TEST(Result, TryPassesTheErrorOn) {
  EXPECT_EQ(quarter(8).value(), 2);
  EXPECT_EQ(quarter(6).error().code, "test.odd");
  EXPECT_EQ(to_string(quarter(7).error()), "error[test.odd] n: is odd");
}

}  // namespace
}  // namespace marketgen
