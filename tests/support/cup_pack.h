// A counter whose robot has another tool set, and a pack that begins right under its cup's lip.
#pragma once
#include <string>

#include "episodes/checkout/checkout_world.h"
#include "motion/grasp_candidates.h"
#include "support/drawn_checkout.h"

namespace marketgen {

template <class T>
T taken_from(Result<T> result) {
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

inline episodes::CheckoutWorld world_with(const std::string& tools) {
  return taken_from(episodes::CheckoutWorld::create(
      data_rows(), committed_catalog().frictions, episodes::checkout_station, tools));
}

inline const robots::GraspTool& counter_cup() {
  static const robots::GraspTool tool =
      taken_from(robots::load_grasp_tool(data_rows(), "panda-suction"));
  return tool;
}

inline catalog::Product box_pack() {
  catalog::Product pack;
  pack.sku = "box";
  pack.archetype = "box";
  pack.material = "cardboard";
  pack.size_mm = {150, 40, 200};
  pack.mass_kg = 0.3;
  return pack;
}

inline episodes::EpisodeSpec under_the_lip(const episodes::CheckoutWorld& world,
                                           const catalog::Product& pack) {
  const auto body = taken_from(assets::product_body(pack));
  motion::GraspQuery query;
  query.from_above = true;
  const auto grasps = taken_from(motion::grasp_candidates(pack, *body, counter_cup(), query));
  if (grasps.found.empty()) fatal(grasps.reason.c_str());
  constexpr double apart_m = 0.001;
  const Pose tip = robots::frame_pose(world.robot(),
                                      episodes::ready_state(world.station(), world.robot()),
                                      world.robot().tools.front().frame);
  const Pose item =
      tip * Pose{{0, 0, apart_m}, {}} * inverse(grasps.found.front().grasp.product_from_tool);
  episodes::EpisodeSpec spec;
  spec.id = "under-the-lip";
  spec.robot = world.station().robot;
  spec.tools = world.station().tools().id;
  spec.limit_s = 60;
  spec.items = {episodes::EpisodeItem::at(pack.sku, inverse(world.station().basket_pose()) * item)};
  spec.goals = {{pack.sku, 1}};
  return spec;
}

}  // namespace marketgen
