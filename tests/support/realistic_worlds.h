// Worlds of both tracks at a realism of choice.
#pragma once
#include <memory>
#include <string>
#include <utility>

#include "episodes/checkout/checkout_world.h"
#include "support/can_aisle.h"
#include "support/drawn_checkout.h"

namespace marketgen {

template <class T>
T or_die(Result<T> result) {
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

inline episodes::Realism realism_row(const std::string& name) {
  return or_die(episodes::load_realism(data_rows(), name));
}

inline std::unique_ptr<episodes::CheckoutWorld> counter_at(
    const episodes::Realism& realism, const episodes::EpisodeSpec& spec = drawn(7, 0)) {
  auto world = std::make_unique<episodes::CheckoutWorld>(
      or_die(episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions)));
  const auto reset = world->reset(spec, checkout_goods_rows(), nullptr, {}, realism);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

inline std::unique_ptr<episodes::AisleWorld> can_world_at(const episodes::Realism& realism) {
  static const std::shared_ptr<const episodes::AisleStore> store = can_aisle();
  auto world = std::make_unique<episodes::AisleWorld>(store, committed_catalog().frictions);
  const auto reset = world->reset(can_episode(*store), {}, realism);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

}  // namespace marketgen
