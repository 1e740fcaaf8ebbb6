// How the parts of an SDF export are called. Models: the room, a fixture by its id, what stands in
// it, a free item by its id. Inside of a fixture's model: its joints by their names, collisions by
// part_name(). Inside of goods: collisions by the items' ids.
#pragma once
#include <string_view>

namespace marketgen::exporters {

constexpr std::string_view sdf_world = "store";   // names Gazebo's topics, which take no blanks
constexpr std::string_view sdf_room = "room";     // a model, and its link
constexpr std::string_view sdf_body = "body";     // the link of what of a fixture does not move
constexpr std::string_view sdf_goods = "goods";   // the link of standing goods
constexpr std::string_view sdf_item = "item";     // the link of a free item
constexpr std::string_view sdf_link = "/link";    // after a joint's name: the link that it moves
constexpr std::string_view sdf_mount = "/mount";  // after a link's: the joint that fixes it
constexpr std::string_view sdf_hook = "hook";     // the joint on which a free item hangs
// After a collision's name: its visual, as no two of a link may be called the same.
constexpr std::string_view sdf_look = "/look";
// Elements of our own; libsdformat leaves alone what has a prefix.
constexpr const char* sdf_sku = "marketgen:sku";      // in the world: its name and mass_kg
constexpr const char* sdf_joint = "marketgen:joint";  // in a joint: joint_extras()

}  // namespace marketgen::exporters
