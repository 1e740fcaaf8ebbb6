// Products and joints that are not where the scene has them, as rows of the ray tracer's world.
#pragma once
#include <span>
#include <vector>

#include "render/render.h"
#include "render/stage/actor_stage.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// Error: render.bad_move, see Renderer::move_things.
Result<void> check_moves(const scene::Scene& scene,
                         std::span<const MovedProduct> products,
                         std::span<const MovedJoint> joints);

// Adds the instances that these joints carry away from their places.
void add_moved_joints(const World& world,
                      const scene::Scene& scene,
                      std::span<const MovedJoint> joints,
                      std::vector<Displaced>& rows);

}  // namespace marketgen::render::raytrace
