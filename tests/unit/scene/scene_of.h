// The stocked scene of a shop laid out by hand.
#pragma once
#include <cstdint>
#include <utility>

#include "scene/scene.h"
#include "support/hand_laid_shop.h"

namespace marketgen {

inline scene::Scene scene_of(const HandLaidShop& shop, std::uint64_t seed = 1) {
  auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(seed));
  if (!built.ok()) fatal(to_string(built.error()).c_str());
  return std::move(built).value();
}

}  // namespace marketgen
