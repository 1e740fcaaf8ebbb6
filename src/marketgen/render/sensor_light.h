// Light on the first hits, the quick way: a few stratified shadow rays, one bounce lit from the
// stored irradiance, one mirror ray where a surface is glossy. The filter takes out what noise is
// left.
#pragma once
#include "render/film.h"
#include "render/first_hits.h"
#include "render/irradiance.h"
#include "render/light_grid.h"
#include "render/panel_reflection.h"

namespace marketgen::raytrace {

// What lighting reads.
struct Lighting {
  const World& world;
  const LightGrid& lights;
  const IrradianceField& field;
  const PanelReflection& panels;
};

// Radiance that a surface sends back along the ray that found it, from stored light. Lamps count
// when `with_lamps`.
enum class Lamps { left_out, seen };
Vec3f stored_radiance(const Lighting& lighting,
                      const Surface& surface,
                      Vec3f direction,
                      Lamps lamps);

// How much more or less diffuse light the surface's relief catches than its flat face: from stored
// light, so without noise.
float relief_shade(const Lighting& lighting, const Surface& surface);

// Whether a mirror ray is worth its cost; rougher surfaces take the stored light of their mirror
// side.
bool is_glossy(const Surface& surface);

// Fills irradiance, gloss and overlay of the tile's pixels with the mean of `samples` samples.
void light_tile(
    const Lighting& lighting, const View& view, const Tile& tile, int samples, Film& film);

}  // namespace marketgen::raytrace
