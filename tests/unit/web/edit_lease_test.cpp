// One page at a time may change a store.
#include "web/edit_lease.h"

#include <gtest/gtest.h>

#include <chrono>

namespace marketgen {
namespace {

using namespace std::chrono_literals;
using Clock = web::EditLease::Clock;

TEST(EditLease, IsOnePagesAtATime) {
  web::EditLease lease;
  const Clock::time_point now = Clock::now();
  EXPECT_FALSE(lease.is_taken(now));
  const auto first = lease.take("", now);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->size(), 32U);
  EXPECT_FALSE(lease.take("", now + 29s));
  EXPECT_FALSE(lease.take("guessed", now + 29s));
  EXPECT_EQ(lease.take(*first, now + 29s), first) << "a page that was loaded anew goes on";
  EXPECT_TRUE(lease.holds(*first, now + 50s)) << "nobody else has asked";
  EXPECT_FALSE(lease.take("", now + 79s)) << "he was heard of at 50 s";
  const auto second = lease.take("", now + 81s);
  ASSERT_TRUE(second);
  EXPECT_NE(*second, *first);
  EXPECT_FALSE(lease.holds(*first, now + 82s));
  lease.give_back(*first);
  EXPECT_TRUE(lease.is_taken(now + 82s)) << "it is not his to give";
  lease.give_back(*second);
  EXPECT_FALSE(lease.is_taken(now + 82s));
  EXPECT_FALSE(lease.holds("", now + 82s));
}

}  // namespace
}  // namespace marketgen
