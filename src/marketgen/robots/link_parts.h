// What a robot's links look like, as meshes: the solids of Link::look, one part per finish.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "robots/robot.h"

namespace marketgen::robots {

struct LinkPart {
  Mesh mesh;          // link frame, metres; surface 0
  std::string color;  // "#rrggbb", sRGB
  double roughness = 0.45, metallic = 0;
};

// One solid, closed: a box with rounded edges, a tube with rounded rims, a ball. Empty for a solid
// without extent and for kind mesh.
Mesh mesh_of(const BodyShape& shape);

// In the order in which the finishes appear. A link without look shows its capsules in grey. Files
// that a URDF names are read where they are GLB or OBJ, their own colours left aside. Errors: those
// of read_model_file; robot.bad_file for a file of another kind.
Result<std::vector<LinkPart>> link_parts(const Link& link);

// As link_parts() of every link, moved to where the links are in the base frame; one element per
// link. `base_from_link` as forward_kinematics() writes it.
Result<std::vector<std::vector<LinkPart>>> robot_parts(const Robot& robot,
                                                       std::span<const Pose> base_from_link);

}  // namespace marketgen::robots
