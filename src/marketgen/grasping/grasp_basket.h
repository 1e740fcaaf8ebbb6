// The setting `basket` of the grasp study: a product that lies among its likes in the checkout
// basket.
#pragma once
#include <string>

#include "grasping/grasp_study.h"

namespace marketgen::grasping {

// So many of a product are poured, and at least one: they fill at most this share of the basket.
constexpr int max_likes_in_basket = 6;
constexpr double max_basket_fill = 0.5;
int likes_in_basket(const catalog::Product& product);

struct BasketCase {
  BasketOfLikes basket;  // the target first: of those that stayed inside, the last that was poured
  GraspExclusion excluded = GraspExclusion::none;
  std::string reason;  // of the exclusion, a sentence
};

// Errors: as settle_bulk.
// `goods`: of GoodsUse::bulk.
Result<BasketCase> basket_case(const physics::SharedGoodsBody& goods, Seed seed);

// Candidates for the target: from above, clear of the walls.
motion::GraspQuery basket_query(const BasketOfLikes& basket, double friction);

}  // namespace marketgen::grasping
