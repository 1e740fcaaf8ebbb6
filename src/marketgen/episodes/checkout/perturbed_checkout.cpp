// A basket that stands, and goods that lie, a little other than the episode says.
#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "episodes/checkout/checkout_goals.h"
#include "episodes/checkout/checkout_world.h"

namespace marketgen::episodes {
namespace {

// So deep, as they are drawn, baskets' goods may lie in one another (sample_checkout.cpp).
constexpr double max_pressed_m = 0.002;
constexpr double min_share = 0.125;  // of a shift; rather none than less
constexpr double max_settling_s = 1.5, at_rest_s = 0.2;
constexpr std::array displaced_shares{1.0, 0.75, 0.5, 0.25, 0.0};
constexpr std::string_view basket_thing = "basket";  // by its name its displacement is drawn

}  // namespace

// The basket goes where the realism has it, with what lies in it; what lies elsewhere stays.
EpisodeSpec CheckoutWorld::displaced(EpisodeSpec spec) {
  const BasketDials& dials = realism_.basket;
  if (dials.place_m <= 0 && dials.turn_deg <= 0) return spec;
  const Perturbation shift({dials.place_m, dials.turn_deg, 0, 0}, noise_);
  const Pose nominal = basket_start_;
  for (const double share : displaced_shares) {
    basket_start_ = shift.moved(nominal, basket_thing, share);
    if (station_.has_room_for_basket(basket_start_)) break;
  }
  for (std::size_t i = 0; i < spec.items.size(); ++i) {
    EpisodeItem& item = spec.items[i];
    const Vec3 middle = to_double(item_goods_[i]->body.center_of_mass);
    if (in_basket({station_.container(), nominal})(nominal * item.pose() * middle)) continue;
    item = EpisodeItem::at(item.sku, inverse(basket_start_) * nominal * item.pose());
  }
  return spec;
}

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
    shares[i] = shares[i] > min_share ? shares[i] / 2 : 0;
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
  const agent::Action wait = still_action(as_it_is());
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
  basket_start_ = perturbation_->moved(basket_start_, basket_thing);
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
