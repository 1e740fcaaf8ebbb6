#include "render/path/light_through.h"

#include <algorithm>
#include <cmath>

#include "render/path/scattering.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float sheet_index = 1.5F;

// What the filter finds in place of Embree's own context. Embree keeps the pointer as it is.
struct CrossingContext {
  RTCIntersectContext embree;  // first: Embree's pointer is this struct's
  const World* world;
  bool in_store;  // else among the actors
  Vec3f direction;
  Vec3f passed{1, 1, 1}, optical_depth{};
};

// Crossings come in any order: each multiplies or adds by itself. Light enters a body at its front
// and leaves at its back, so depth is the sum of leaving distances less entering ones.
void cross(CrossingContext& context, const Hit& hit) {
  const TriangleRecord& record = record_of(*context.world, hit);
  const Material& material = context.world->materials[record.material];
  Vec3f normal = unpacked_normal(record.face_normal);
  if (hit.instance != RTC_INVALID_GEOMETRY_ID)
    normal = context.world->instances[hit.instance].world_from_mesh.turn(normal);
  const float facing = dot(normal, context.direction);
  const float cosine = std::fabs(facing);
  if (material.glass) {
    context.passed *= material.color * (1 - interface_reflectance(cosine, sheet_index));
  } else if (material.refraction > 1) {
    context.passed = context.passed * (1 - interface_reflectance(cosine, material.refraction));
    context.optical_depth += material.absorption_per_m * std::copysign(hit.t, facing);
  } else {
    context.passed = context.passed * (1 - sheet_reflectance(cosine, sheet_index));
  }
}

// Lets rays pass what is clear. Called by Embree for each hit of a shadow ray, one ray at a time.
void pass_clear(const RTCFilterFunctionNArguments* args) {
  auto& context = *reinterpret_cast<CrossingContext*>(args->context);
  Hit hit;
  hit.t = RTCRayN_tfar(args->ray, args->N, 0);
  hit.geometry = RTCHitN_geomID(args->hit, args->N, 0);
  hit.primitive = RTCHitN_primID(args->hit, args->N, 0);
  const unsigned instance = RTCHitN_instID(args->hit, args->N, 0, 0);
  hit.instance = context.in_store ? store_row(instance) : actor_row(*context.world, instance);
  if (context.in_store && is_hidden(*context.world, hit)) {
    args->valid[0] = 0;
    return;
  }
  const Material& material = context.world->materials[record_of(*context.world, hit).material];
  if (!material.clear && !material.glass) return;
  cross(context, hit);
  args->valid[0] = 0;
}

}  // namespace

Vec3f light_through(const World& world, const Ray& ray) {
  CrossingContext context{};
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = pass_clear;
  context.world = &world;
  context.direction = ray.direction;
  context.passed = {1, 1, 1};
  RTCRay query = embree_ray(ray, mask_opaque | mask_glass);
  for (const Bvh* bvh : {&world.bvh, &world.actors.bvh}) {
    if (!*bvh) continue;
    context.in_store = bvh == &world.bvh;
    rtcOccluded1(bvh->get(), &context.embree, &query);
    if (query.tfar < 0) return {};
  }
  const auto left = [](float passed, float depth) {
    return depth > 0 ? passed * std::exp(-depth) : passed;
  };
  return {left(context.passed.x, context.optical_depth.x),
          left(context.passed.y, context.optical_depth.y),
          left(context.passed.z, context.optical_depth.z)};
}

}  // namespace marketgen::render::raytrace
