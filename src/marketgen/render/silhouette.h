// What objects would cover of a picture with nothing before them.
//
// The same rays through pixel centres meet the same triangles as in the picture, one object at a
// time: a visible pixel is always a covered one, and the rest is what others hide.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/render.h"

namespace marketgen::render::raytrace {

struct World;

// See Renderer::silhouettes(). Cost: about as many rays as the objects' boxes have pixels, and a
// projection of each vertex.
std::vector<Silhouette> silhouettes_of(const World& world,
                                       const Camera& camera,
                                       const Frame& frame,
                                       std::span<const std::uint32_t> objects);

}  // namespace marketgen::render::raytrace
