// What shoppers took off the shelves since staff last filled them.
//
// A block's mean sales in a week are what it holds, over the days that a full shelf of its category
// lasts (scene/sales_rates.inc), times the kind of shop's sales (scene/shop_sales.inc), times how
// much the product is asked for, times what its price does. They spread over the week as the shop's
// do (scene/shop_week.h), and come one by one at random moments.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "plan/plan.h"
#include "plan/store_time.h"
#include "scene/shop_week.h"

namespace marketgen::scene {

// Before opening; twice_a_day: after noon, too; three_days_a_week: on Mondays, Wednesdays and
// Fridays. Nobody comes on days on which the shop is closed.
enum class Refills { twice_a_day, every_day, three_days_a_week };

struct SalesRate {
  std::string_view category;
  double days_of_supply = 0;
  Refills refills = Refills::every_day;
};
const std::vector<SalesRate>& sales_rates();  // one for each category of data/categories.json
// The category's; one that has no row is sold as the slowest are.
const SalesRate& rate_of(std::string_view category);

// Units that shoppers want of a block. Those of before staff last pulled its goods forward are
// missing at the back, those since then in front.
struct UnitsWanted {
  int before_facing_up = 0, since = 0;
  int all() const { return before_facing_up + since; }
};

class StoreSales {
 public:
  // `time`: of the plan. `catalog` as the store has it, in its own money.
  StoreSales(const plan::Plan& plan, plan::StoreTime time, const catalog::Catalog& catalog);

  // On the mean, of a block that holds `capacity` when full.
  double weekly_units(const catalog::Product& product, int capacity) const;

  // Since its shelf was last filled. The same stream gives, for every later time before the next
  // filling, no fewer.
  UnitsWanted wanted(const catalog::Product& product, int capacity, Stream draw) const;

 private:
  // From the last of the moments at which staff come; minutes.
  int since_refill(Refills refills) const;
  int since_facing_up(bool in_the_afternoon_too) const;

  const ShopSales& shop_;
  plan::StoreTime time_;
  std::map<std::string, double, std::less<>> usual_price_;  // by category
};

}  // namespace marketgen::scene
