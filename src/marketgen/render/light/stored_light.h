// Light that needs no rays: what lighting reads, and what surfaces send back of stored light.
#pragma once
#include "render/light/irradiance.h"
#include "render/light/light_grid.h"
#include "render/light/panel_reflection.h"

namespace marketgen::render::raytrace {

// What lighting reads.
struct Lighting {
  const World& world;
  const LightGrid& lights;
  const IrradianceField& field;
  const PanelReflection& panels;
};

// Radiance that a surface sends back along the ray that found it, from stored light.
enum class Lamps { left_out, seen };
Vec3f stored_radiance(const Lighting& lighting,
                      const Surface& surface,
                      Vec3f direction,
                      Lamps lamps);

}  // namespace marketgen::render::raytrace
