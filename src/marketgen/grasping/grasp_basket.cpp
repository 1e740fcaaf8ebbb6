#include "grasping/grasp_basket.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/settle/bulk_settle.h"

namespace marketgen::grasping {

int likes_in_basket(const catalog::Product& product) {
  const physics::OpenContainer& c = physics::checkout_basket;
  const double basket = (c.top_x_m - c.taper_m) * (c.top_y_m - c.taper_m) * c.height_m;
  const double pack = product.width_m() * product.depth_m() * product.height_m();
  return static_cast<int>(
      std::clamp(max_basket_fill * basket / pack, 1.0, 1.0 * max_likes_in_basket));
}

Result<BasketCase> basket_case(const physics::SharedGoodsBody& goods, Seed seed) {
  const catalog::Product& product = goods->product;
  BasketCase made{{physics::checkout_basket, {}}, GraspExclusion::none, {}};
  const auto without = [&](GraspExclusion why, std::string reason) {
    made.excluded = why;
    made.reason = std::move(reason);
    return made;
  };
  if (!physics::fits_in(physics::checkout_basket, product))
    return without(GraspExclusion::does_not_fit,
                   fmt::format("{} x {} x {} mm do not lie in the basket",
                               product.size_mm[0],
                               product.size_mm[1],
                               product.size_mm[2]));
  const std::vector<physics::SharedGoodsBody> items(
      static_cast<std::size_t>(likes_in_basket(product)), goods);
  MARKETGEN_TRY(const physics::SettledBulk bulk,
                physics::settle_bulk(physics::checkout_basket, items, seed));
  if (!bulk.rests)
    return without(GraspExclusion::unstable, "poured into the basket it does not come to rest");
  for (const physics::SettledItem& item : bulk.items)
    if (item.inside) made.basket.container_from_product.push_back(item.container_from_product);
  std::ranges::reverse(made.basket.container_from_product);
  if (made.basket.container_from_product.empty())
    return without(GraspExclusion::does_not_fit, "it does not stay in the basket");
  return made;
}

motion::GraspQuery basket_query(const BasketOfLikes& basket, double friction) {
  motion::GraspQuery query;
  query.friction = friction;
  query.from_above = true;
  query.world_from_product = basket.container_from_product.front();
  query.likes.assign(basket.container_from_product.begin() + 1,
                     basket.container_from_product.end());
  for (const physics::ContainerBox& box : physics::boxes_of(basket.container))
    query.walls.push_back({box.container_from_box, box.half_size});
  return query;
}

}  // namespace marketgen::grasping
