// Lamps built into fixtures: glowing boxes, the free faces of which become area lights.
#pragma once
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

// Adds a glowing box to `mesh`, each face a light of its own. The material's emission holds the
// colour, 0..1, until `switch_on` replaces it by radiance.
void add_lamp_box(const World& world,
                  TracedMesh& mesh,
                  const Placement& mesh_from_box,
                  Vec3f half_size,
                  std::uint16_t material);

// What a lamp sends out, lux per steradian, by its length and its free surface.
float lamp_radiance(float length_m, float area_m2);

// Once the meshes' BVHs stand: puts out faces that lie against something, gives the rest the
// radiance of an LED strip of that length, and lists the lights of all instances in World::lights.
void switch_on_lamps(World& world);

}  // namespace marketgen::render::raytrace
