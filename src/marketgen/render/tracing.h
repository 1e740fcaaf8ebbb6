// Rays through the world's BVHs, alone and in packets of up to sixteen, and what a hit means for
// shading.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "render/matter.h"
#include "render/sensor/float8.h"
#include "render/stage/world.h"

namespace marketgen::render::raytrace {

constexpr float ray_infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t packet_size = 16;
// Points are lifted off the triangle by this: longer than float error at 100 m, shorter than any
// gap that shows.
constexpr float surface_lift_m = 3e-4F;

constexpr float min_slant = 0.15F;  // cosine below which footprints grow no more
// Shading normals are bent to face the viewer at least this much.
constexpr float min_facing = 0.03F;
constexpr float min_bare_metal = 0.5F;  // metallic; lacquered tin has 0.3

struct Ray {
  Vec3f origin, direction;  // direction is a unit vector
  float near = 0, far = ray_infinity;
};

struct Rays8 {
  Vec8 origin, direction;
};

struct Hit {
  float t = ray_infinity;
  std::uint32_t geometry = RTC_INVALID_GEOMETRY_ID, primitive = 0,
                instance = RTC_INVALID_GEOMETRY_ID;
  float u = 0, v = 0;
  bool any() const { return geometry != RTC_INVALID_GEOMETRY_ID; }
};

// Rays of one pixel block have almost one direction; others fly apart. Only a matter of speed.
enum class RayBundle { coherent, scattered };

// hits[i] is the first hit of rays[i]. At most packet_size rays.
void trace(const World& world,
           std::span<const Ray> rays,
           std::span<Hit> hits,
           unsigned mask,
           RayBundle bundle);
// The same in Embree's own arrangement: origin, direction, tnear and tfar of all sixteen rays are
// given, the first `used` are traced. Hits name rows of World::instances.
void trace(
    const World& world, RTCRayHit16& packet, std::size_t used, unsigned mask, RayBundle bundle);
void set_ray(RTCRay16& packet, std::size_t k, const Ray& ray);
// Rays half * 8 and on, without end.
void set_rays(RTCRay16& packet, std::size_t half, const Rays8& rays, float near);
Ray ray_in(const RTCRay16& packet, std::size_t k);
Hit hit_in(const RTCRayHit16& packet, std::size_t k);
// blocked[i]: something lies on rays[i] between near and far.
void find_blocked(const World& world,
                  std::span<const Ray> rays,
                  std::span<bool> blocked,
                  unsigned mask);
// The same of a packet, as bits; where they are set, its rays are used up.
unsigned find_blocked(const World& world, RTCRay16& packet, std::size_t used, unsigned mask);
// The same, asking for actors alone.
unsigned find_blocked_by_actors(const World& world, RTCRay16& packet, std::size_t used);
Hit trace_one(const World& world, const Ray& ray, unsigned mask);
// Of one row of World::instances alone, whether it is hidden or not.
Hit trace_instance(const World& world, std::uint32_t instance, const Ray& ray);
// The ray as Embree takes it alone.
RTCRay embree_ray(const Ray& ray, unsigned mask);
// Whether what was met stands elsewhere now: rays pass through its place in the store.
bool is_hidden(const World& world, const Hit& hit);
// The row in World::instances of an Embree instance of the store's tree, or of the actors'; an
// invalid number stays one.
std::uint32_t store_row(unsigned instance);
std::uint32_t actor_row(const World& world, unsigned instance);

// A point seen, ready to be lit.
struct Surface {
  Vec3f position;             // lifted by surface_lift_m off the triangle, towards the viewer
  Vec3f face_normal, normal;  // towards the viewer
  Vec3f relief_normal;        // the same with the material's relief
  Vec3f albedo;               // diffuse colour, or the metal's colour
  Vec3f emission;
  float roughness = 0.5F, metallic = 0;
  float distance = 0;    // along the ray
  std::uint32_t id = 0;  // Frame::instance
  std::uint16_t material = 0;
  bool glass = false, back_face = false;
  std::int32_t light = -1;  // the area light that it shows, -1 = none
  std::int32_t fixture = -1, shelf = -1;

  Vec3f diffuse() const { return albedo * (1 - metallic); }
  Vec3f reflectance() const;  // at normal incidence
};

// Of a surface that is no pane.
Matter matter_of(const World& world, const Surface& surface);
const TriangleRecord& record_of(const World& world, const Hit& hit);
// `footprint` is the width that one sample stands for at the hit, metres: it picks the mip level.
void see_surface(const World& world,
                 const Ray& ray,
                 const Hit& hit,
                 float footprint,
                 TextureDetail detail,
                 Surface& surface);
inline Surface surface_at(const World& world,
                          const Ray& ray,
                          const Hit& hit,
                          float footprint,
                          TextureDetail detail = TextureDetail::full) {
  Surface surface;
  see_surface(world, ray, hit, footprint, detail, surface);
  return surface;
}
// A shading normal tilted by a relief that shows; it keeps facing the viewer.
bool is_tilted(const Relief& relief);
Vec3f tilted(Vec3f normal, const Relief& relief, const TextureAxes& axes, Vec3f direction);
// Brings what see_surface() will read of these hits nearer. Only a matter of speed.
void fetch_surfaces(const World& world, std::span<const Hit> hits);

}  // namespace marketgen::render::raytrace
