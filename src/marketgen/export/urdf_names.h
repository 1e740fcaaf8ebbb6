// How the links and joints of a URDF export are called. A fixture's own link has its id, an item's
// link the item's; a joint that moves is "<fixture id>/<joint>". Names of
// collisions are unique in the file (MuJoCo's geoms): of items their ids, of parts those of
// ExportContents::parts.
#pragma once
#include <string_view>

namespace marketgen::exporters {

constexpr std::string_view urdf_room = "room";     // the root link
constexpr std::string_view urdf_link = "/link";    // after a joint's name: the link that it moves
constexpr std::string_view urdf_mount = "/mount";  // after a link's name: the joint that fixes it
// Below the folder beside: a ball of radius 1 m, scaled to the half axes of what is an ellipsoid.
constexpr const char* urdf_ball_file = "ball.obj";

}  // namespace marketgen::exporters
