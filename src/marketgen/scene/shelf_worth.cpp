#include "scene/shelf_worth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/seed.h"
#include "scene/demand.h"
#include "scene/sales.h"

namespace marketgen::scene {
namespace {

constexpr double min_brand_factor = 0.85, max_brand_factor = 1.15, own_brand_factor = 1.3;
constexpr double safety = 2;  // of what is sold between two fillings

// Days on which a shelf that is filled so has to last at most.
double days_between(Refills refills) {
  switch (refills) {
    case Refills::twice_a_day:
      return 0.5;
    case Refills::every_day:
      return 1;
    case Refills::three_days_a_week:
      break;
  }
  return 3;  // Friday to Monday
}

double category_margin(std::string_view category) {
  const auto found = std::ranges::find(margins(), category, &Margin::category);
  return found == margins().end() ? margins().back().share : found->share;
}

}  // namespace

const std::vector<Margin>& margins() {
#define MARGIN(category, share) {#category, share},
  static const std::vector<Margin> rows{
#include "scene/margins.inc"
  };
#undef MARGIN
  return rows;
}

std::string_view own_brand_of(const catalog::Catalog& catalog) {
  std::map<std::string_view, std::set<std::string_view>> categories;
  for (const catalog::Product& product : catalog.products)
    if (!product.brand.empty()) categories[product.brand].insert(product.category);
  std::pair<std::size_t, std::string_view> best{1, ""};
  for (const auto& [brand, of] : categories)
    if (of.size() > best.first) best = {of.size(), brand};
  return best.second;
}

double margin_of(const catalog::Product& product, std::string_view own_brand) {
  const bool own = !own_brand.empty() && product.brand == own_brand;
  const double factor = own ? own_brand_factor
                            : Seed(0)
                                  .child("margin", product.brand)
                                  .stream()
                                  .uniform(min_brand_factor, max_brand_factor);
  return category_margin(product.category) * factor;
}

double earnings_of(const catalog::Product& product, std::string_view own_brand) {
  return demand_of(product) * product.price * margin_of(product, own_brand);
}

int case_packs(const catalog::Product& product) {
  constexpr double max_kg = 13, max_m3 = 0.04;
  const double pack_m3 = product.width_m() * product.depth_m() * product.height_m();
  for (const int packs : {24, 12, 10, 8, 6, 4, 2})
    if (packs * product.mass_kg <= max_kg && packs * pack_m3 <= max_m3) return packs;
  return 1;
}

int min_packs(const catalog::Product& product, double usual_packs) {
  const SalesRate& rate = rate_of(product.category);
  const double sold_a_day = usual_packs / rate.days_of_supply * demand_of(product);
  const double between = safety * days_between(rate.refills) * sold_a_day;
  return std::max(case_packs(product), static_cast<int>(std::ceil(between)));
}

}  // namespace marketgen::scene
