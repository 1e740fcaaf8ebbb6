// How much room shops give a kind of goods, and which goods of a kind are asked for most.
#pragma once
#include <string_view>
#include <vector>

#include "catalog/catalog.h"

namespace marketgen::scene {

// Beside other kinds of the same zone.
struct ShelfShare {
  std::string_view category, subcategory;
  double usual = 1, small_shop = 1;
};
const std::vector<ShelfShare>& shelf_shares();  // scene/shelf_shares.inc

struct GoodsShare {
  std::string_view category, name;
  double weight = 1;
};
const std::vector<GoodsShare>& goods_shares();  // scene/goods_shares.inc

// Of the product's category and subcategory; 10, which is about the mean, for one that has no row.
double shelf_share_of(const catalog::Product& product, bool small_shop);

// Convenience stores, kiosks and forecourts, whatever their size, and any shop of less than 150 m2.
bool is_small_shop(std::string_view profile, double floor_m2);

// How much the product is asked for among its kind: scene/demand.h; of categories whose names have
// weights, the weight of its name by the fourth root of that.
double asked_for(const catalog::Product& product);

}  // namespace marketgen::scene
