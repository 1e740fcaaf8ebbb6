#include "episodes/aisle/aisle_stage.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "collect/collect_plan.h"
#include "episodes/aisle/studied_grasps.h"

namespace marketgen::episodes {
namespace {

constexpr double shortest_way_m = 1, longest_way_m = 4;  // of Stage::drive
constexpr FloorPlaceRow off_at_pick{0.02, 0.02, 2};      // of Stage::pick, along each axis
constexpr int max_stage_starts = 2000;                   // places drawn
constexpr int max_plans = 3;                             // each from other random postures

PointMm axle_mm(const AisleStore& store, const FloorPlaceRow& row) {
  return floor_mm(axle_of(store.robot, base_pose_of(row)));
}

EpisodeSpec of_one_goal(const EpisodeSpec& whole, std::size_t pick) {
  EpisodeSpec spec = whole;
  spec.certificate.witness = {whole.certificate.witness[pick]};
  const std::string& sku = spec.certificate.witness.front().sku;
  std::erase_if(spec.goals, [&](const EpisodeGoal& goal) { return goal.sku != sku; });
  std::erase_if(spec.categories, [&](const CategoryPlace& place) { return place.sku != sku; });
  for (EpisodeGoal& goal : spec.goals)
    goal.count = 1;
  spec.limit_s = stage_limit_s;
  return spec;
}

std::optional<FloorPlaceRow> anywhere_near(const AisleStore& store,
                                           const FloorPlaceRow& stand,
                                           Stream& draw) {
  const auto offset = [&] { return draw.uniform(-longest_way_m, longest_way_m); };
  for (int i = 0; i < max_stage_starts; ++i) {
    const FloorPlaceRow place{stand.x_m + offset(), stand.y_m + offset(), draw.uniform(-180, 180)};
    if (!store.ways.space().free(axle_mm(store, place))) continue;
    const auto way = store.ways.shortest_path(axle_mm(store, place), axle_mm(store, stand));
    if (way.ok() && way->length_m >= shortest_way_m && way->length_m <= longest_way_m) return place;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FloorPlaceRow> a_little_off(const AisleStore& store,
                                          const FloorPlaceRow& stand,
                                          Stream& draw,
                                          const FloorPlaceRow& most) {
  const auto off = [&](double at_most) { return draw.uniform(-at_most, at_most); };
  for (int i = 0; i < max_stage_starts; ++i) {
    const double x = stand.x_m + off(most.x_m), y = stand.y_m + off(most.y_m);
    const FloorPlaceRow place{x, y, stand.heading_deg + off(most.heading_deg)};
    if (store.ways.space().free(axle_mm(store, place))) return place;
  }
  return std::nullopt;
}

Result<WitnessPick> witness_of(const EpisodeSpec& spec) {
  if (!spec.certificate.witness.empty()) return spec.certificate.witness.front();
  return Error{"episode.impossible",
               spec.id,
               "its certificate has no witness, so that nobody knows where its product is taken "
               "from; draw episodes with the split \"planned\""};
}

Result<EpisodeSpec> aisle_stage(const AisleStore& store,
                                const EpisodeSpec& whole,
                                Stage stage,
                                Seed seed) {
  MARKETGEN_CHECK(witness_of(whole));
  if (stage == Stage::pick && doors_of(whole) != Doors::none)
    return Error{"episode.impossible", whole.id, "its products stand behind shut doors"};
  Stream draw = seed.child("aisle_stage").stream();
  const int last = static_cast<int>(whole.certificate.witness.size()) - 1;
  EpisodeSpec spec = of_one_goal(whole, static_cast<std::size_t>(draw.integer(0, last)));
  const FloorPlaceRow stand = spec.certificate.witness.front().base;
  const auto start = stage == Stage::drive ? anywhere_near(store, stand, draw)
                                           : a_little_off(store, stand, draw, off_at_pick);
  if (!start)
    return Error{"episode.impossible", whole.id, "nothing is free where the robot could begin"};
  spec.start = {start->x_m, start->y_m, std::remainder(start->heading_deg, 360)};
  const std::string name = spec.goals.front().text.value_or(spec.goals.front().sku);
  spec.instruction = stage == Stage::drive ? fmt::format("Drive to {}.", name)
                                           : fmt::format("Take {} off its shelf.", name);
  spec.id = fmt::format("{}/{}/{:016x}", whole.id, name_of(stage), seed.value());
  spec.seed = seed.value();
  return spec;
}

Result<std::uint32_t> witnessed_product(const AisleStore& store, const EpisodeSpec& spec) {
  MARKETGEN_TRY(const WitnessPick pick, witness_of(spec));
  for (const std::uint32_t row : store.front_items(pick.sku))
    if (scene::product_id(store.scene, row) == pick.product) return row;
  return Error{
      "episode.impossible",
      spec.id,
      fmt::format("its witness takes \"{}\", which is not in the front row of a shelf here",
                  pick.product)};
}

Result<std::vector<double>> hand_before_product(
    const AisleStore& store,
    const EpisodeSpec& spec,
    const robots::GraspTool& tool,
    const std::vector<catalog::FrictionRow>& frictions) {
  MARKETGEN_TRY(const std::uint32_t row, witnessed_product(store, spec));
  const WitnessPick& pick = spec.certificate.witness.front();
  const catalog::Product& goods = store.scene.catalog[store.scene.products[row].sku];
  collect::CollectOptions options;
  options.posture = store.station.posture;
  options.carried = store.basket.walls;
  options.world_from_base = base_pose_of(pick.base);
  MARKETGEN_TRY(options.grasps, studied_grasps(goods, tool, frictions, pick.grasps));
  Result<collect::CollectPlan> plan = Error{"collect.no_place", spec.id, ""};
  for (int i = 0; i < max_plans && !plan.ok(); ++i)
    plan = collect::plan_collect(store.scene,
                                 row,
                                 store.robot,
                                 tool,
                                 Seed(0).child(pick.product, static_cast<std::uint64_t>(i)),
                                 options);
  if (!plan.ok()) return plan.error();
  std::vector<double> state = plan->state;
  const motion::Configuration before = plan->reach.way.back();
  const robots::JointGroup& arm = *store.robot.find_group(plan->group);
  for (std::size_t j = 0; j < arm.dofs.size(); ++j)
    state[static_cast<std::size_t>(arm.dofs[j])] = before[j];
  return state;
}

}  // namespace marketgen::episodes
