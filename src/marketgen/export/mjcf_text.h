// Poses and sizes as the attributes of an MJCF file take them.
#pragma once
#include <string>

#include "export/xml_text.h"
#include "geometry/pose.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::exporters {

// Groups 0 to 2 are shown by MuJoCo's viewer at once; 0, 1 and 2 on its keyboard hide them, 3 shows
// what things touch with where that is not what they look like.
enum GeomGroup { group_shell, group_fixture, group_product, group_solid };

constexpr double mjcf_glass_alpha = 0.3;

// ` pos="..." quat="..."`; the identity rotation is left out.
std::string mjcf_pose(const Pose& pose);
// As many numbers as the shape's geom type takes.
std::string mjcf_size(const assets::ContactShape& shape);

}  // namespace marketgen::exporters
