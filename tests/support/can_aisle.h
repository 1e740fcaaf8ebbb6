// A hand-made shop with cans on its upper board, as a store of In-Aisle Item Collection.
#pragma once
#include <filesystem>
#include <memory>

#include "episodes/aisle/aisle_world.h"
#include "support/committed_catalog.h"
#include "support/hand_made_scene.h"

namespace marketgen {

// So many facings of so many, one behind the other.
inline std::shared_ptr<const episodes::AisleStore> can_aisle(int facings = 4, int deep = 1) {
  HandMadeScene shop;
  constexpr std::uint32_t can = 1;
  for (int i = 0; i < facings * deep; ++i) {
    const std::uint32_t row =
        shop.add(can,
                 {2.8F + 0.106F * static_cast<float>(i / deep),
                  HandMadeScene::shelf_y_m - 0.12F + 0.08F * static_cast<float>(i % deep),
                  HandMadeScene::upper_board_m});
    shop.scene.products[row].flags |= scene::product_front_row;  // each may be asked for
  }
  auto store =
      episodes::open_aisle_store(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", shop.scene);
  if (!store.ok()) fatal(to_string(store.error()).c_str());
  return std::move(store).value();
}

// One can is to be fetched; the robot stands in the middle of the room and looks east.
inline episodes::EpisodeSpec can_episode(const episodes::AisleStore& store) {
  episodes::EpisodeSpec spec;
  spec.id = "aisle/can";
  spec.track = episodes::Track::aisle;
  spec.store = "corner";
  spec.robot = store.station.robot;
  spec.goals = {{"can-cola", 1}};
  spec.start = {2.0, 1.6, 0};
  spec.limit_s = 120;
  return spec;
}

inline std::unique_ptr<episodes::AisleWorld> can_world(
    const episodes::EpisodeSpec& spec, const std::shared_ptr<const episodes::AisleStore>& store) {
  auto world = std::make_unique<episodes::AisleWorld>(store, committed_catalog().frictions);
  const auto reset = world->reset(spec);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}
inline std::unique_ptr<episodes::AisleWorld> can_world(const episodes::EpisodeSpec& spec) {
  static const std::shared_ptr<const episodes::AisleStore> store = can_aisle();
  return can_world(spec, store);
}

}  // namespace marketgen
