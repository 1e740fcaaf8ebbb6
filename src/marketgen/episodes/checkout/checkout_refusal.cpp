#include "episodes/checkout/checkout_refusal.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numbers>

#include "assets/product_model.h"
#include "base/parallel.h"
#include "catalog/firm_pack.h"
#include "episodes/checkout/checkout_station.h"
#include "grasping/grasp_study.h"
#include "motion/grasp_candidates.h"
#include "physics/settle/bulk_settle.h"

namespace marketgen::episodes {
namespace {

// ---- What the gripper can be expected to hold ----
// Flat goods: a finger of 16 mm and its room fit between a pack and the wall only over the ledge,
// so that the pads' lower ends, 21 mm under the pack's upper side, must stand 16 mm over the floor.
// Wide goods: pads that stand 80 mm apart have 2.5 mm to spare on either side.
constexpr int widest_mm = 74, flattest_mm = 37, longest_mm = 255;
// What has grown or was baked is narrower beside its middle: round goods are taken there, or along
// their shortest way, muffins by their cup.
constexpr int widest_round_mm = 82, widest_baked_mm = 76;
constexpr int min_round_mm = 35;  // of smaller ones (chilies) 3 of 5 reached their place
constexpr double heaviest_kg = 1.0;

bool is_round(const catalog::Product& product) {
  return product.orientation == catalog::Orientation::any;
}

bool is_too_wide(const catalog::Product& product, int shortest_mm, int middle_mm) {
  const int beside_mm = is_round(product) ? widest_round_mm : widest_baked_mm;
  return shortest_mm > widest_mm ||
         middle_mm > (product.material == "skin" ? beside_mm : widest_mm);
}

// The pack on its broadest side, or with that up.
Pose lying(const catalog::Product& product, bool other_way_up) {
  const auto& size = product.size_mm;
  const auto thin = std::ranges::min_element(size) - size.begin();
  constexpr double quarter = std::numbers::pi / 2;
  Pose pose;
  if (thin == 0) pose.rotation = rotation_about({0, 1, 0}, other_way_up ? -quarter : quarter);
  if (thin == 1) pose.rotation = rotation_about({1, 0, 0}, other_way_up ? -quarter : quarter);
  if (thin == 2 && other_way_up) pose.rotation = rotation_about({1, 0, 0}, 2 * quarter);
  const Vec3 middle = rotate(pose.rotation, {0, 0, product.height_m() / 2});
  pose.position = Vec3{0, 0, *std::ranges::min_element(size) * 1e-3 / 2} - middle;
  return pose;
}

CheckoutRefusal refusal_of(motion::GraspRefusal why) {
  switch (why) {
    case motion::GraspRefusal::none:
      return CheckoutRefusal::none;
    case motion::GraspRefusal::too_heavy:
      return CheckoutRefusal::too_heavy;
    case motion::GraspRefusal::no_room:
      return CheckoutRefusal::no_room;
    default:
      return CheckoutRefusal::no_seal;
  }
}

using Refusals = std::map<std::string, CheckoutRefusal>;  // by SKU

Result<std::shared_ptr<const Refusals>> cup_refusals(
    const std::vector<catalog::Product>& products,
    const robots::GraspTool& cup,
    const std::vector<catalog::FrictionRow>& frictions) {
  const auto found = parallel_map(products.size(), [&](std::size_t i) {
    return std::make_shared<Result<CheckoutRefusal>>(
        cup_refusal(products[i], cup, grasping::rubber_friction(frictions, products[i])));
  });
  auto refusals = std::make_shared<Refusals>();
  for (std::size_t i = 0; i < products.size(); ++i) {
    if (!found[i]->ok()) return found[i]->error();
    refusals->emplace(products[i].sku, found[i]->value());
  }
  return std::shared_ptr<const Refusals>(std::move(refusals));
}

}  // namespace

CheckoutRefusal checkout_refusal(const catalog::Product& product) {
  std::array<int, 3> size = product.size_mm;
  std::ranges::sort(size);
  if (catalog::gives_way(product)) return CheckoutRefusal::soft;
  if (product.mass_kg > heaviest_kg) return CheckoutRefusal::too_heavy;
  if (is_too_wide(product, size[0], size[1])) return CheckoutRefusal::too_wide;
  if (is_round(product) && size[0] < min_round_mm) return CheckoutRefusal::small_round;
  if (!is_round(product) && size[0] < flattest_mm) return CheckoutRefusal::too_flat;
  if (size[2] > longest_mm) return CheckoutRefusal::too_long;
  return physics::fits_in(physics::checkout_basket, product) ? CheckoutRefusal::none
                                                             : CheckoutRefusal::too_large;
}

Result<CheckoutRefusal> cup_refusal(const catalog::Product& product,
                                    const robots::GraspTool& cup,
                                    double lip_friction) {
  if (catalog::gives_way(product)) return CheckoutRefusal::soft;
  if (!physics::fits_in(physics::checkout_basket, product)) return CheckoutRefusal::too_large;
  MARKETGEN_TRY(const auto body, assets::product_body(product));
  for (const bool other_way_up : {false, true}) {
    motion::GraspQuery query;
    query.friction = lip_friction;
    query.from_above = true;
    query.world_from_product = lying(product, other_way_up);
    MARKETGEN_TRY(const motion::GraspCandidates grasps,
                  motion::grasp_candidates(product, *body, cup, query));
    if (grasps.found.empty()) return refusal_of(grasps.refusal);
  }
  return CheckoutRefusal::none;
}

Result<CheckoutHand> checkout_hand(const std::filesystem::path& data,
                                   const std::vector<catalog::FrictionRow>& frictions,
                                   const std::vector<catalog::Product>& products,
                                   const std::string& tools,
                                   const std::string& station_id) {
  MARKETGEN_TRY(const CheckoutStation station,
                load_checkout_station(data, station_or_own(station_id), tools));
  CheckoutHand hand;
  if (station.carries > 0) hand.tools = station.tools().id;
  MARKETGEN_TRY(const robots::GraspTool tool,
                robots::load_grasp_tool(data, station.tools().picks_with));
  if (tool.kind == robots::ToolKind::gripper) return hand;
  MARKETGEN_TRY(const auto refusals, cup_refusals(products, tool, frictions));
  hand.refusal = [refusals](const catalog::Product& product) { return refusals->at(product.sku); };
  return hand;
}

}  // namespace marketgen::episodes
