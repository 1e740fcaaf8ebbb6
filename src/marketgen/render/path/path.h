// Path tracing: rough and clear surfaces, metal, many lamps by multiple importance sampling,
// Russian roulette.
//
// A path goes from the eye through panes, bottles and what fills them to the first rough surface,
// whose look it notes for the filter, and on from there. It may end early in the stored irradiance:
// after the first bounce off something rough a blurred answer is enough, at half the cost; pictures
// come out up to a few per cent darker where shelves shade one another.
#pragma once
#include <cstdint>
#include <limits>

#include "render/cameras/view.h"
#include "render/light/irradiance.h"
#include "render/light/light_grid.h"
#include "render/tracing.h"

namespace marketgen::render::raytrace {

// What paths read.
struct PathScene {
  const World& world;
  const LightGrid& lights;
  const IrradianceField& field;
};

struct PathSettings {
  unsigned mask = mask_opaque;      // of what the eye sees; later rays meet everything
  bool end_in_stored_light = true;  // otherwise paths run until little light is left
  // Radiance above which a screen shows no more of a lamp.
  float brightest_shown = std::numeric_limits<float>::infinity();
};

// Light along one path, split for the filter: radiance = diffuse + gloss + glow.
struct PathLight {
  Vec3f albedo;   // diffuse colour of the first rough surface, as seen through what lies before it
  Vec3f paint;    // the same, but metals count with their colour
  Vec3f diffuse;  // light that it sent diffusely
  Vec3f gloss;    // mirrored light, by it or by what lies before it
  Vec3f glow;     // light of lamps and the sky that the eye sees without a mirror: free of noise
  Vec3f beyond;   // what of the glow is over PathSettings::brightest_shown
};

// Path `number` of pixel (x, y); the same numbers always give the same path. `first` is the first
// hit of `ray` on settings.mask and glass.
struct PathStart {
  int x = 0, y = 0;
  std::uint32_t number = 0;
};
// The ray through a random point of the pixel.
Ray eye_ray(const View& view, const PathStart& start);
PathLight trace_path(const PathScene& scene,
                     const View& view,
                     const PathSettings& settings,
                     const PathStart& start,
                     const Ray& ray,
                     const Hit& first);

}  // namespace marketgen::render::raytrace
