// Units that shoppers want: how many on the mean, of what, and when.
#include "scene/sales.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <vector>

#include "scene_of.h"

namespace marketgen {
namespace {

constexpr int capacity = 24;

plan::StoreTime time_of(std::string_view text) {
  const auto time = plan::parse_store_time(text, "plan.bad_value", "/time");
  if (!time.ok()) fatal(to_string(time.error()).c_str());
  return *time;
}

scene::StoreSales sales_at(std::string_view time, const std::string& profile = "supermarket-eu") {
  plan::Plan plan;
  plan.profile = profile;
  return {plan, time_of(time), committed_catalog()};
}

// Mean number of units wanted of the category's products, `capacity` of each being there.
double mean_wanted(const scene::StoreSales& sales, std::string_view category) {
  double wanted = 0, products = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    if (product.category != category) continue;
    wanted += sales.wanted(product, capacity, Seed(1).child(product.sku).stream()).all();
    ++products;
  }
  return wanted / products;
}

TEST(SalesRates, EveryCategoryHasOneAndNoOther) {
  const auto& categories = committed_catalog().categories;
  ASSERT_EQ(scene::sales_rates().size(), categories.size());
  for (const catalog::CategoryRow& category : categories)
    EXPECT_EQ(std::ranges::count(scene::sales_rates(), category.id, &scene::SalesRate::category), 1)
        << category.id;
}

// The first fifth of all products has about 61 % of the sales; prices and chance move that.
TEST(StoreSales, AreThoseOfFewProductsForAGoodPart) {
  const scene::StoreSales sales = sales_at("Sat 17:30");
  std::map<std::string, std::vector<double>> by_category;
  for (const catalog::Product& product : committed_catalog().products)
    by_category[product.category].push_back(sales.weekly_units(product, capacity));
  for (auto& [category, units] : by_category) {
    std::ranges::sort(units, std::greater{});
    const auto fifth = units.begin() + static_cast<std::ptrdiff_t>(units.size() / 5);
    const double share = std::accumulate(units.begin(), fifth, 0.0) /
                         std::accumulate(units.begin(), units.end(), 0.0);
    EXPECT_GT(share, 0.5) << category;
    EXPECT_LT(share, 0.75) << category;
  }
}

TEST(StoreSales, CheapGoodsAndDiscountersSellFaster) {
  const catalog::Product& row = committed_catalog().products.front();
  catalog::Product cheap = row, dear = row;
  cheap.price = row.price / 2, dear.price = row.price * 2;
  const scene::StoreSales sales = sales_at("Sat 17:30");
  EXPECT_GT(sales.weekly_units(cheap, capacity), sales.weekly_units(row, capacity));
  EXPECT_GT(sales.weekly_units(row, capacity), sales.weekly_units(dear, capacity));
  EXPECT_NEAR(sales_at("Sat 17:30", "discounter").weekly_units(row, capacity),
              1.44 * sales.weekly_units(row, capacity),
              1e-9);
}

// A renewal process whose first gap begins anywhere has as many events as it should from the start.
TEST(StoreSales, ComeAsOftenAsTheyShouldOnTheMean) {
  const scene::StoreSales sales = sales_at("Mon 20:00");  // filled in the morning
  const double share =
      scene::sales_share(scene::ShopWeek::closed_on_sundays, time_of("Mon 5:00"), 15 * 60);
  const auto found = std::ranges::find(
      committed_catalog().products, std::string("beverages"), &catalog::Product::category);
  for (const int held : {1, 10, 100, 1000}) {
    constexpr int blocks = 4000;
    double wanted = 0;
    for (int i = 0; i < blocks; ++i)
      wanted +=
          sales.wanted(*found, held, Seed(5).child("block", static_cast<std::uint64_t>(i)).stream())
              .all();
    const double expected = sales.weekly_units(*found, held) * share;
    EXPECT_NEAR(wanted / blocks, expected, 0.05 * expected + 0.02) << held;
  }
}

// Hour by hour no fewer, until staff come; and nothing where nobody shopped since.
TEST(StoreSales, GrowUntilStaffFillTheShelves) {
  const catalog::Catalog& catalog = committed_catalog();
  for (std::size_t row = 0; row < catalog.products.size(); row += 7) {
    const catalog::Product& product = catalog.products[row];
    const Stream draw = Seed(9).child(product.sku).stream();
    int before = 0;
    for (int hour = 5; hour < 13; ++hour) {  // nothing is filled in these hours
      const scene::StoreSales sales = sales_at("Wed " + std::to_string(hour) + ":00");
      const scene::UnitsWanted wanted = sales.wanted(product, capacity, draw);
      EXPECT_GE(wanted.all(), before) << product.sku;
      EXPECT_EQ(wanted.before_facing_up, 0) << product.sku;
      EXPECT_TRUE(hour > 8 || wanted.all() == 0) << product.sku;  // the shop opens at 8
      before = wanted.all();
    }
  }
}

TEST(StoreSales, FreshGoodsAreFilledAfterNoonAndSlowOnesOnThreeDays) {
  EXPECT_GT(mean_wanted(sales_at("Sat 12:59"), "produce"), 1);
  EXPECT_LT(mean_wanted(sales_at("Sat 13:01"), "produce"), 0.1);
  EXPECT_LT(mean_wanted(sales_at("Mon 8:00"), "canned"), 1e-9);
  EXPECT_GT(mean_wanted(sales_at("Tue 8:00"), "canned"), 0.5);  // of Monday
  EXPECT_LT(mean_wanted(sales_at("Tue 8:00"), "beverages"), 1e-9);
  // Of a closed Sunday's evening nothing is gone that was not on Saturday's.
  EXPECT_EQ(mean_wanted(sales_at("Sun 18:00"), "snacks"),
            mean_wanted(sales_at("Sat 23:00"), "snacks"));
  EXPECT_GT(mean_wanted(sales_at("Sat 18:00"), "canned"),
            mean_wanted(sales_at("Thu 18:00"), "canned"));
}

TEST(StoreSales, AfterNoonHalfOfTheBlocksWerePulledForward) {
  const scene::StoreSales sales = sales_at("Mon 17:00");
  int forward = 0, sold = 0;
  for (const catalog::Product& product : committed_catalog().products) {
    if (product.category != "beverages") continue;
    const auto wanted = sales.wanted(product, 500, Seed(3).child(product.sku).stream());
    if (wanted.all() == 0) continue;
    ++sold;
    forward += wanted.before_facing_up > 0 ? 1 : 0;
  }
  ASSERT_GT(sold, 30);
  EXPECT_NEAR(static_cast<double>(forward) / sold, 0.5, 0.2);
}

}  // namespace
}  // namespace marketgen
