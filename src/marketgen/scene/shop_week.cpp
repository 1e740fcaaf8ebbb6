#include "scene/shop_week.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace marketgen::scene {
namespace {

using plan::minutes_of_day;
using plan::minutes_of_hour;
using plan::minutes_of_week;
using Hours = std::array<double, 24>;

// Shares of the week's sales by day, and of a day's by hour: of each alone in any unit.
struct Curve {
  std::array<double, 7> days;
  Hours weekday, weekend;
};

constexpr Curve closed_on_sundays{
    {14.25, 14.25, 14.25, 14.25, 21, 22, 0},
    {0, 0, 0, 0, 0, 0, 0, 0, 4, 6, 8, 8, 7, 6, 7, 8, 12, 12, 10, 8, 4, 0, 0, 0},
    {0, 0, 0, 0, 0, 0, 0, 0, 5, 9, 13, 13, 11, 9, 8, 8, 8, 7, 6, 3, 0, 0, 0, 0}};

constexpr Curve every_day{
    {29, 29, 30, 30, 33, 41, 32},
    {0, 0, 0, 0, 0, 0, 1, 2, 4, 6, 8, 9, 9, 7, 8, 9, 8, 8, 7, 5, 4, 2, 1, 0},
    {0, 0, 0, 0, 0, 0, 1, 2, 4, 7, 9, 11, 11, 9, 9, 9, 8, 7, 5, 4, 2, 1, 1, 0}};

const Curve& curve_of(ShopWeek week) {
  return week == ShopWeek::every_day ? every_day : closed_on_sundays;
}

template <std::size_t size>
double sum(const std::array<double, size>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

// Share of the week's sales from Monday 0:00 to this minute of the week.
double share_until(const Curve& curve, int minute) {
  double days = 0;
  const auto day = static_cast<std::size_t>(minute / minutes_of_day);
  for (std::size_t i = 0; i < std::min(day, curve.days.size()); ++i)
    days += curve.days[i];
  if (day < curve.days.size()) {
    const Hours& hours = day < 5 ? curve.weekday : curve.weekend;
    const int in_day = minute % minutes_of_day;
    const auto hour = static_cast<std::size_t>(in_day / minutes_of_hour);
    double sold = hours[hour] * (in_day % minutes_of_hour) / minutes_of_hour;
    for (std::size_t i = 0; i < hour; ++i)
      sold += hours[i];
    days += curve.days[day] * sold / sum(hours);
  }
  return days / sum(curve.days);
}

}  // namespace

const std::vector<ShopSales>& shops_sales() {
#define SHOP_SALES(profile, week, over_supermarket) {profile, ShopWeek::week, over_supermarket},
  static const std::vector<ShopSales> rows{
#include "scene/shop_sales.inc"
  };
#undef SHOP_SALES
  return rows;
}

const ShopSales& sales_of_shop(std::string_view profile) {
  const auto found = std::ranges::find(shops_sales(), profile, &ShopSales::profile);
  static const ShopSales supermarket;
  return found == shops_sales().end() ? supermarket : *found;
}

double sales_share(ShopWeek week, plan::StoreTime from, int minutes) {
  const Curve& curve = curve_of(week);
  const int end = from.minute + minutes;
  const double sold = share_until(curve, end % minutes_of_week) - share_until(curve, from.minute);
  return sold + end / minutes_of_week;
}

bool is_open_on(ShopWeek week, plan::Weekday day) {
  return curve_of(week).days[static_cast<std::size_t>(day)] > 0;
}

}  // namespace marketgen::scene
