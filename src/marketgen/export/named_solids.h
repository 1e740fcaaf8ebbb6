// The solids of the room by name, for formats whose floor is a solid as all others.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "assets/contact_shape.h"
#include "scene/scene.h"

namespace marketgen::exporters {

struct NamedSolid {
  std::string name;
  assets::ContactShape shape;
};

constexpr std::string_view floor_solid = "floor";

// The floor, which is a slab below the room, and the walls, panes, doors and columns (shell_pieces)
// in the store frame.
std::vector<NamedSolid> room_solids(const plan::Shell& shell);

}  // namespace marketgen::exporters
