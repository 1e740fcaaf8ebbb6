// How much light reaches a point along a straight line: nothing past solid things, the rest tinted
// by the panes and clear packs between. Light through clear packs is not bent here: a lamp seen
// through a bottle lights as if the bottle were a coloured sheet. Path tracing only.
#pragma once
#include "render/tracing.h"

namespace marketgen::render::raytrace {

// Share of each colour that passes between near and far of `ray`. A ray that starts inside a clear
// pack is dimmed by what it crosses there. Thread-safe.
Vec3f light_through(const World& world, const Ray& ray);

}  // namespace marketgen::render::raytrace
