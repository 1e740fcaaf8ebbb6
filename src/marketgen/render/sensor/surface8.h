// What eight hits mean for shading, side by side: see_surface() of tracing.h in eight lanes.
#pragma once
#include "render/sensor/float8.h"
#include "render/tracing.h"

namespace marketgen::render::raytrace {

// Lanes that met nothing have t = u = v = 0.
struct Hits8 {
  Float8 t, u, v;
  Int8 geometry, primitive, instance;
  Mask8 any;
};
// Rays half * 8 and on of a packet that was traced.
Hits8 hits_of(const RTCRayHit16& packet, std::size_t half);

inline Hits8 four_each(const Hits8& a, const Hits8& b, Side side) {
  return {four_each(a.t, b.t, side),
          four_each(a.u, b.u, side),
          four_each(a.v, b.v, side),
          four_each(a.geometry, b.geometry, side),
          four_each(a.primitive, b.primitive, side),
          four_each(a.instance, b.instance, side),
          Mask8(four_each(Float8(a.any.m), Float8(b.any.m), side).m)};
}

// The same as Surface, as far as sensor pictures need it.
struct Surface8 {
  Vec8 position, face_normal, normal, relief_normal, albedo, emission;
  Float8 roughness, metallic, distance;
  Int8 id, material, fixture, shelf;
  Mask8 glass, clear;
};
Surface surface_in(const Surface8& surfaces, std::size_t k);
void set_surface(Surface8& surfaces, std::size_t k, const Surface& surface, bool clear);

// Lanes that met nothing hold numbers that are finite and mean nothing.
void see_surfaces(const World& world,
                  const Rays8& rays,
                  const Hits8& hits,
                  Float8 footprint,
                  TextureDetail detail,
                  Surface8& surfaces);
// Brings what see_surfaces() will read nearer. Only a matter of speed.
void fetch_surfaces(const World& world, const RTCRayHit16& packet);

}  // namespace marketgen::render::raytrace
