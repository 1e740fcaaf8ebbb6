// A basket whose goods lie a little other than its episode says.
#include <algorithm>

#include <fmt/format.h>

#include "episodes/checkout/checkout_goals.h"
#include "episodes/checkout/checkout_world.h"

namespace marketgen::episodes {
namespace {

// So deep, as they are drawn, baskets' goods may lie in one another (sample_checkout.cpp).
constexpr double max_pressed_m = 0.002;
constexpr double least_share = 0.125;  // of a shift; rather none than less
constexpr double max_settling_s = 1.5, at_rest_s = 0.2;

}  // namespace

// Of those that are pressed into something else than as they were; false when none moves less now.
bool CheckoutWorld::halve_pressed(std::vector<double>& shares) const {
  std::vector<bool> pressed(shares.size());
  for (const physics::WorldContact& contact : world_->contacts()) {
    if (contact.depth_m <= max_pressed_m) continue;
    for (const physics::ContactSide& side : {contact.a, contact.b})
      if (side.kind == physics::BodyKind::product && side.row >= first_item_)
        pressed[side.row - first_item_] = true;
  }
  bool any = false;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!pressed[i] || shares[i] == 0) continue;
    shares[i] = shares[i] > least_share ? shares[i] / 2 : 0;
    any = true;
  }
  return any;
}

// Every item moved by what is drawn for it, at most by that share, as far as it meets no other one
// nor the basket.
Result<std::vector<EpisodeItem>> CheckoutWorld::apart(const EpisodeSpec& spec, double most) {
  const physics::WorldSnapshot start = world_->snapshot();
  std::vector<double> shares(spec.items.size(), most);
  while (true) {
    std::vector<EpisodeItem> items;
    for (std::size_t i = 0; i < shares.size(); ++i)
      items.push_back(EpisodeItem::at(
          spec.items[i].sku,
          perturbation_->moved(spec.items[i].pose(), fmt::format("item-{}", i), shares[i])));
    MARKETGEN_CHECK(world_->restore(start));
    MARKETGEN_CHECK(place_items(items));
    MARKETGEN_CHECK(world_->step());
    if (!halve_pressed(shares)) return items;
  }
}

// Left alone until all items are at rest; empty when one has left the basket.
Result<std::optional<EpisodeSpec>> CheckoutWorld::settled(EpisodeSpec spec) {
  const auto inside = [&](std::size_t item, const Pose& pose, const Pose& basket) {
    return in_basket({station_.container(), basket})(
        pose * to_double(item_goods_[item]->body.center_of_mass));
  };
  const auto at_rest = [](const auto& item) { return item.second.rested_s >= at_rest_s; };
  const agent::Action wait = still_action(observe());
  while (time_s() < max_settling_s && !std::ranges::all_of(watch_.items(), at_rest))
    MARKETGEN_CHECK(move(wait));
  for (std::size_t i = 0; i < spec.items.size(); ++i) {
    EpisodeItem& item = spec.items[i];
    const Pose before = basket_start_ * item.pose(), now = item_pose(i);
    if (inside(i, before, basket_start_) && !inside(i, now, basket_pose()))
      return std::optional<EpisodeSpec>{};
    item = EpisodeItem::at(item.sku, inverse(basket_pose()) * now);
  }
  return std::optional(std::move(spec));
}

Result<void> CheckoutWorld::begin_perturbed(const EpisodeSpec& spec) {
  basket_start_ = perturbation_->moved(basket_start_, "basket");
  for (const double most : {1.0, 0.5, 0.25}) {
    MARKETGEN_CHECK(begin(spec));
    EpisodeSpec shifted = spec;
    MARKETGEN_TRY(shifted.items, apart(spec, most));
    MARKETGEN_CHECK(begin(shifted));
    MARKETGEN_TRY(std::optional<EpisodeSpec> lies, settled(std::move(shifted)));
    if (lies) return begin(*lies);
  }
  return begin(spec);
}

}  // namespace marketgen::episodes
