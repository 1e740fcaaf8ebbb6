// A cooler with two glass doors that stands alone in a room, cans on one of its boards behind the
// second door, as a store of In-Aisle Item Collection with goals behind doors.
#pragma once
#include <cmath>
#include <filesystem>
#include <memory>

#include "episodes/aisle/aisle_world.h"
#include "scene/fixture_stage.h"
#include "scene/placements.h"
#include "support/committed_catalog.h"
#include "support/hand_made_scene.h"

namespace marketgen {

constexpr std::uint32_t can_cooler_door = 1;  // in Scene::joints

inline scene::Scene can_cooler_scene() {
  constexpr double board_m = 0.9, before_m = 0.06, apart_m = 0.106;
  scene::Scene scene = scene::stage_fixture(*committed_catalog().fixture_kind("glass_door_cooler"),
                                            committed_catalog())
                           .value();
  scene.catalog = {hand_made_product("can-cola", "can", {66, 66, 115}, 0.35)};
  std::uint32_t board = 0;  // that is nearest to a height
  const auto off = [&](std::uint32_t row) {
    return std::abs(scene::world_from_shelf(scene, row).position.z - board_m);
  };
  for (std::uint32_t row = 0; row < scene.shelves.size(); ++row)
    if (off(row) < off(board)) board = row;
  for (int i = 0; i < 4; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    scene::Facing facing;
    facing.shelf = board;
    facing.first_product = number, facing.product_count = 1;
    scene.facings.push_back(facing);
    scene.products.push_back({0, number, {}, {}, scene::product_front_row});
    scene::place(
        scene.products.back(),
        scene::world_from_shelf(scene, board) * Pose{{0.18 + apart_m * i, before_m, 0}, {}});
  }
  return scene;
}

inline std::shared_ptr<const episodes::AisleStore> can_cooler(episodes::Doors doors) {
  auto store = episodes::open_aisle_store(
      std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", can_cooler_scene(), {}, doors);
  if (!store.ok()) fatal(to_string(store.error()).c_str());
  return std::move(store).value();
}

// Cans are to be fetched; the robot stands 2.5 m before the cooler and looks at it.
inline episodes::EpisodeSpec can_cooler_episode(const episodes::AisleStore& store, int cans) {
  const layout::Fixture& cooler = store.scene.layout.fixtures.front();
  episodes::EpisodeSpec spec;
  spec.id = "aisle/cooler";
  spec.track = episodes::Track::aisle;
  spec.store = "cooler";
  spec.robot = store.station.robot;
  spec.doors = episodes::Doors::hinged;
  spec.goals = {{"can-cola", cans}};
  spec.start = {cooler.x_mm * 1e-3, cooler.y_mm * 1e-3 - 2.5, 90};
  spec.limit_s = 400;
  return spec;
}

}  // namespace marketgen
