// Where the price tags of shelf edges are stuck on in pictures.
#pragma once
#include "geometry/vector.h"
#include "scene/scene.h"

namespace marketgen::render {

// Middle of the tag in the frame of its shelf, metres: before the price rail where the shelf has
// one. The tag is upright there, as wide and high as its label says, and faces -Y.
Vec3f price_tag_place(const scene::Scene& scene, const scene::PriceLabel& label);

}  // namespace marketgen::render
