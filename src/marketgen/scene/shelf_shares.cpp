#include "scene/shelf_shares.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scene/demand.h"

namespace marketgen::scene {
namespace {

constexpr double usual_share = 10;  // of a kind without a row
constexpr double small_shop_m2 = 150;

using KindName = std::pair<std::string_view, std::string_view>;

const std::map<KindName, const ShelfShare*>& share_of_kind() {
  static const std::map<KindName, const ShelfShare*> rows = [] {
    std::map<KindName, const ShelfShare*> made;
    for (const ShelfShare& row : shelf_shares())
      made[{row.category, row.subcategory}] = &row;
    return made;
  }();
  return rows;
}

const std::map<KindName, double>& weight_of_name() {
  static const std::map<KindName, double> rows = [] {
    std::map<KindName, double> made;
    for (const GoodsShare& row : goods_shares())
      made[{row.category, row.name}] = row.weight;
    return made;
  }();
  return rows;
}

}  // namespace

const std::vector<ShelfShare>& shelf_shares() {
#define SHELF_SHARE(category, subcategory, usual, small_shop) \
  {category, subcategory, usual, small_shop},
  static const std::vector<ShelfShare> rows{
#include "scene/shelf_shares.inc"
  };
#undef SHELF_SHARE
  return rows;
}

const std::vector<GoodsShare>& goods_shares() {
#define GOODS_SHARE(category, name, weight) {category, name, weight},
  static const std::vector<GoodsShare> rows{
#include "scene/goods_shares.inc"
  };
#undef GOODS_SHARE
  return rows;
}

double shelf_share_of(const catalog::Product& product, bool small_shop) {
  const auto found = share_of_kind().find({product.category, product.subcategory});
  if (found == share_of_kind().end()) return usual_share;
  return small_shop ? found->second->small_shop : found->second->usual;
}

bool is_small_shop(std::string_view profile, double floor_m2) {
  return floor_m2 < small_shop_m2 || profile.starts_with("convenience") || profile == "kiosk" ||
         profile == "forecourt";
}

double asked_for(const catalog::Product& product) {
  const double demand = demand_of(product);
  const bool weighed = std::ranges::find(goods_shares(), product.category, &GoodsShare::category) !=
                       goods_shares().end();
  if (!weighed) return demand;
  const auto found = weight_of_name().find({product.category, product.name});
  return std::sqrt(std::sqrt(demand)) * (found == weight_of_name().end() ? 1 : found->second);
}

}  // namespace marketgen::scene
