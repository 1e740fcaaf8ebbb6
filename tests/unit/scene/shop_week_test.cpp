// Sales over the week, against what the sources say.
#include "scene/shop_week.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

using plan::minutes_of_day;
using plan::minutes_of_week;
using scene::ShopWeek;

constexpr std::array weeks{ShopWeek::closed_on_sundays, ShopWeek::every_day};

plan::StoreTime at(int day, int hour) {
  return {day * minutes_of_day + hour * 60};
}
double on_day(ShopWeek week, int day) {
  return sales_share(week, at(day, 0), minutes_of_day);
}
double in_hours(ShopWeek week, int day, int from, int to) {
  return sales_share(week, at(day, from), (to - from) * 60);
}

// The hour at which the `hours` with the most sales of a day begin.
int busiest(ShopWeek week, int day, int hours) {
  int best = 0;
  for (int hour = 1; hour + hours <= 24; ++hour)
    if (in_hours(week, day, hour, hour + hours) > in_hours(week, day, best, best + hours))
      best = hour;
  return best;
}

TEST(ShopWeeks, AddUpToTheWeekFromWhereverTheyBegin) {
  for (const ShopWeek week : weeks) {
    for (int from = 0; from < minutes_of_week; from += 97) {
      EXPECT_NEAR(sales_share(week, {from}, minutes_of_week), 1, 1e-12);
      const double part = sales_share(week, {from}, 1000);
      EXPECT_GE(part, 0);
      EXPECT_NEAR(part + sales_share(week, {(from + 1000) % minutes_of_week}, 4000),
                  sales_share(week, {from}, 5000),
                  1e-12);
    }
  }
}

TEST(ShopWeeks, InGermanyAreAsTheTradeSays) {
  const ShopWeek week = ShopWeek::closed_on_sundays;
  EXPECT_NEAR(on_day(week, 4), 0.21, 0.005);
  EXPECT_NEAR(on_day(week, 5), 0.22, 0.005);
  EXPECT_EQ(on_day(week, 6), 0);
  EXPECT_FALSE(is_open_on(week, plan::Weekday::Sun));
  int open = 0;
  for (int hour = 0; hour < 7 * 24; ++hour)
    open += in_hours(week, hour / 24, hour % 24, hour % 24 + 1) > 0 ? 1 : 0;
  EXPECT_NEAR(open, 76, 1);
  for (int day = 0; day < 5; ++day)
    EXPECT_EQ(busiest(week, day, 2), 16);
  EXPECT_EQ(busiest(week, 5, 2), 10);
}

TEST(ShopWeeks, InTheUnitedStatesAreAsSurveysSay) {
  const ShopWeek week = ShopWeek::every_day;
  EXPECT_NEAR(on_day(week, 5) / on_day(week, 0), 41.0 / 29, 0.01);
  EXPECT_NEAR(on_day(week, 0), on_day(week, 1), 1e-12);
  EXPECT_NEAR(on_day(week, 5) * 7, 41.0 / 32, 0.01);
  for (const int day : {4, 6}) {  // Fridays and Sundays come next
    EXPECT_LT(on_day(week, day), on_day(week, 5));
    for (const int other : {0, 1, 2, 3})
      EXPECT_GT(on_day(week, day), on_day(week, other));
  }
  for (int day = 0; day < 7; ++day)
    EXPECT_EQ(busiest(week, day, 2), 11);
  EXPECT_GE(in_hours(week, 1, 15, 16), in_hours(week, 1, 11, 12) - 1e-12);
}

TEST(ShopWeeks, EveryKindOfShopHasOneAndNoOther) {
  const auto& rows = scene::shops_sales();
  const auto& profiles = committed_catalog().profiles;
  ASSERT_EQ(rows.size(), profiles.size());
  for (const catalog::ProfileRow& profile : profiles)
    EXPECT_EQ(std::ranges::count(rows, profile.id, &scene::ShopSales::profile), 1) << profile.id;
}

}  // namespace
}  // namespace marketgen
