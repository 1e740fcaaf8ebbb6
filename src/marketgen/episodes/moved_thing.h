// What an episode can move, beside its robot.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/pose.h"

namespace marketgen::episodes {

enum class ThingKind {
  item,     // of the episode: EpisodeSpec::items
  product,  // of the world's scene
  basket    // at a counter; a robot in the aisles carries its own
};
constexpr std::array<std::string_view, 3> names_of(ThingKind) {
  return {"item", "product", "basket"};
}

struct MovedThing {
  ThingKind kind = ThingKind::item;
  std::uint32_t number = 0;  // of the item, or row of the product
  std::string sku = {};      // none of a basket
  Pose store_from_thing = {};
};

}  // namespace marketgen::episodes
