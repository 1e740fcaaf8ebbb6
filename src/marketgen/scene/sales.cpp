#include "scene/sales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/demand.h"

namespace marketgen::scene {
namespace {

using plan::minutes_of_day;
using plan::minutes_of_hour;
using plan::minutes_of_week;

constexpr double days_of_week = 7;

// Hours at which staff fill shelves, before opening and after noon, and at which they face them up.
// No source; what is usual.
constexpr int first_hour = 5, second_refill_hour = 13, second_facing_hour = 14;
constexpr double faced_in_the_afternoon = 0.5;  // of blocks

// What is cheap for its category sells faster: by the root of how much cheaper, twice at most.
double price_factor(double price, double usual) {
  return price > 0 && usual > 0 ? std::clamp(std::sqrt(usual / price), 0.5, 2.0) : 1;
}

bool comes_on(Refills refills, int day) {
  return refills != Refills::three_days_a_week || (day < 5 && day % 2 == 0);
}

// Minutes since the last hour of `hours` on a day on which the shop is open and `comes` is true.
template <std::size_t size, class Comes>
int since_last(plan::StoreTime now,
               ShopWeek week,
               const std::array<int, size>& hours,
               Comes comes) {
  int least = minutes_of_week;
  for (int day = 0; day < static_cast<int>(days_of_week); ++day) {
    if (!is_open_on(week, static_cast<plan::Weekday>(day)) || !comes(day)) continue;
    for (const int hour : hours) {
      const int moment = day * minutes_of_day + hour * minutes_of_hour;
      least = std::min(least, (now.minute - moment + minutes_of_week) % minutes_of_week);
    }
  }
  return least;
}

// Sales that come at random moments, on the mean one in a unit of expectation. The gaps between
// them are even between 0 and 2 units (no logarithm: the same bits everywhere), and the first of
// them begins anywhere within one, so that on the mean n units of expectation are n sales.
class Sales {
 public:
  explicit Sales(Stream draw) : draw_(draw), next_(2 * (1 - std::sqrt(1 - draw_.uniform()))) {}

  // How many came from the last call on, up to this expectation.
  int until(double expected) {
    int count = 0;
    for (; next_ <= expected; next_ += 2 * draw_.uniform())
      ++count;
    return count;
  }

 private:
  Stream draw_;
  double next_;
};

}  // namespace

const std::vector<SalesRate>& sales_rates() {
#define SALES_RATE(category, days, refills) {#category, days, Refills::refills},
  static const std::vector<SalesRate> rows{
#include "scene/sales_rates.inc"
  };
#undef SALES_RATE
  return rows;
}

const SalesRate& rate_of(std::string_view category) {
  const auto found = std::ranges::find(sales_rates(), category, &SalesRate::category);
  return found == sales_rates().end() ? sales_rates().back() : *found;
}

StoreSales::StoreSales(const plan::Plan& plan,
                       plan::StoreTime time,
                       const catalog::Catalog& catalog)
    : shop_(sales_of_shop(plan.profile)), time_(time) {
  std::map<std::string_view, std::vector<double>> prices;
  for (const catalog::Product& product : catalog.products)
    prices[product.category].push_back(product.price);
  for (auto& [category, all] : prices) {
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::ranges::nth_element(all, middle);
    usual_price_[std::string(category)] = *middle;
  }
}

double StoreSales::weekly_units(const catalog::Product& product, int capacity) const {
  const auto usual = usual_price_.find(product.category);
  const double by_price =
      usual == usual_price_.end() ? 1 : price_factor(product.price, usual->second);
  return capacity * days_of_week / rate_of(product.category).days_of_supply *
         shop_.over_supermarket * demand_of(product) * by_price;
}

int StoreSales::since_refill(Refills refills) const {
  const auto comes = [&](int day) { return comes_on(refills, day); };
  if (refills == Refills::twice_a_day)
    return since_last(time_, shop_.week, std::array{first_hour, second_refill_hour}, comes);
  return since_last(time_, shop_.week, std::array{first_hour}, comes);
}

int StoreSales::since_facing_up(bool in_the_afternoon_too) const {
  const auto comes = [](int) { return true; };
  if (in_the_afternoon_too)
    return since_last(time_, shop_.week, std::array{first_hour, second_facing_hour}, comes);
  return since_last(time_, shop_.week, std::array{first_hour}, comes);
}

UnitsWanted StoreSales::wanted(const catalog::Product& product, int capacity, Stream draw) const {
  const bool in_the_afternoon_too = draw.chance(faced_in_the_afternoon);
  const int refill = since_refill(rate_of(product.category).refills);
  const int faced = std::min(refill, since_facing_up(in_the_afternoon_too));
  const plan::StoreTime from{(time_.minute - refill + minutes_of_week) % minutes_of_week};
  const double weekly = weekly_units(product, capacity);
  Sales sales(draw);
  UnitsWanted wanted;
  wanted.before_facing_up = sales.until(weekly * sales_share(shop_.week, from, refill - faced));
  wanted.since = sales.until(weekly * sales_share(shop_.week, from, refill));
  return wanted;
}

}  // namespace marketgen::scene
