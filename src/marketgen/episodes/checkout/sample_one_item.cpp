#include "episodes/checkout/sample_one_item.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "assets/product_model.h"
#include "episodes/goal_words.h"

namespace marketgen::episodes {
namespace {

// Sizes in mm. The hand opens 80 mm; what is twice as high as it is deep tips when it is pushed.
constexpr int narrowest_mm = 35, widest_between_fingers_mm = 62, longest_side_mm = 130;
constexpr int lowest_mm = 40, highest_mm = 130;
constexpr double slender = 1.6, heaviest_box_kg = 0.6;
constexpr double turned_rad = 10 * std::numbers::pi / 180;

// A product's quarter turns that bring its narrower side between the fingers, which close along Y.
int quarter_turns_of(const catalog::Product& product) {
  return product.size_mm[1] <= product.size_mm[0] ? 0 : 1;
}

EpisodeItem standing_item(const CheckoutStation& station,
                          const catalog::Product& product,
                          Stream& draw) {
  const auto within = [&](std::size_t axis) {
    return draw.uniform(station.set_aside.low_m[axis], station.set_aside.high_m[axis]);
  };
  const double x = within(0), y = within(1);
  const double yaw =
      quarter_turns_of(product) * std::numbers::pi / 2 + draw.uniform(-turned_rad, turned_rad);
  const Pose station_from_item{{x, y, 0}, rotation_about({0, 0, 1}, yaw)};
  const Pose p = inverse(station.basket_pose()) * station_from_item;
  return {product.sku,
          {p.position.x, p.position.y, p.position.z},
          {p.rotation.w, p.rotation.x, p.rotation.y, p.rotation.z}};
}

}  // namespace

bool is_one_item(const catalog::Product& product) {
  if (!is_checkout_item(product) || product.mass_kg > heaviest_box_kg ||
      product.rigidity == catalog::Rigidity::soft)
    return false;
  const auto [least, most] = std::minmax(product.size_mm[0], product.size_mm[1]);
  const int height = product.size_mm[2];
  if (least < narrowest_mm || least > widest_between_fingers_mm || most > longest_side_mm ||
      height < lowest_mm || height > highest_mm || height > slender * least)
    return false;
  const auto shape = assets::collision_of(product);
  return shape.ok() && shape->shape == assets::CollisionShape::box;
}

Result<EpisodeSpec> sample_one_item(const std::filesystem::path& data,
                                    const std::vector<catalog::Product>& stock,
                                    const EpisodeOrigin& origin,
                                    Seed seed,
                                    int index) {
  MARKETGEN_TRY(const CheckoutStation station, load_checkout_station(data, one_item_station));
  std::vector<const catalog::Product*> boxes;
  for (const catalog::Product& product : stock)
    if (is_one_item(product)) boxes.push_back(&product);
  if (boxes.empty())
    return Error{
        "episode.impossible",
        origin.store,
        fmt::format("none of its {} kinds of goods is a light box that stands steadily and "
                    "fits between the fingers",
                    stock.size())};
  const Seed own = seed.child("one_item", static_cast<std::uint64_t>(index));
  Stream draw = own.stream();
  const auto chosen = static_cast<std::size_t>(draw.integer(0, static_cast<int>(boxes.size()) - 1));
  const catalog::Product& product = *boxes[chosen];
  EpisodeSpec spec = begun_spec("one-item", origin, seed, index, own);
  spec.robot = station.robot;
  spec.station = one_item_station;
  spec.items = {standing_item(station, product, draw)};
  spec.goals = {{product.sku, 1}};
  spec.instructions = Instructions::words;
  if (!tell_goals(Offer({product}), InstructionVerb::unload, own.child("words"), spec))
    return Error{"episode.impossible", spec.id, "nothing can be said of " + product.sku};
  spec.cameras = {"scene", "wrist"};
  spec.limit_s = station.limit_s;
  return spec;
}

}  // namespace marketgen::episodes
