#include "render/tracing.h"

#include <algorithm>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float past_hidden_m = 1e-4F;

void describe_rays(RTCRay16& packet, unsigned mask) {
  for (std::size_t k = 0; k < packet_size; ++k) {
    packet.mask[k] = mask;
    packet.time[k] = 0;
    packet.flags[k] = 0;
    packet.id[k] = static_cast<unsigned>(k);
  }
}

void set_rays(RTCRay16& packet, std::span<const Ray> rays) {
  for (std::size_t k = 0; k < packet_size; ++k)
    set_ray(packet, k, rays[std::min(k, rays.size() - 1)]);
}

// The lanes in use; the rest point at a ray that exists, so that no lane holds garbage.
alignas(64) constexpr std::array<std::array<int, packet_size>, packet_size + 1> lane_masks = [] {
  std::array<std::array<int, packet_size>, packet_size + 1> masks{};
  for (std::size_t n = 0; n <= packet_size; ++n) {
    for (std::size_t k = 0; k < n; ++k)
      masks[n][k] = -1;
  }
  return masks;
}();

// A vector kept as 16-bit numbers, in 1/32767; reads eight bytes.
Float4 unpacked4(const std::int16_t* v) {
  const __m128i packed = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(v));
  return Float4(_mm_mul_ps(_mm_cvtepi32_ps(_mm_cvtepi16_epi32(packed)), _mm_set1_ps(1.0F / 32767)));
}

Float4 turned(const Placement& place, Float4 v) {
  return Float4(place.x) * Float4(_mm_shuffle_ps(v.m, v.m, 0x00)) +
         Float4(place.y) * Float4(_mm_shuffle_ps(v.m, v.m, 0x55)) +
         Float4(place.z) * Float4(_mm_shuffle_ps(v.m, v.m, 0xAA));
}

// Turns both normals towards the viewer; the shading normal keeps facing him where the mesh is
// coarse.
void face_viewer(Surface& s, Float4 face_normal, Float4 normal, Float4 direction) {
  s.back_face = dot(face_normal, direction) > 0;
  if (s.back_face) face_normal = -face_normal;
  if (dot(normal, face_normal) < 0) normal = -normal;
  normal = normalized(normal);
  const float facing = dot(normal, direction);
  if (facing > -min_facing) normal = normalized(normal - direction * (facing + min_facing));
  s.face_normal = face_normal.xyz();
  s.normal = s.relief_normal = normal.xyz();
}

// The texture's rows and columns at a hit, in the store frame.
TextureAxes axes_at(const World& world, const TriangleRecord& record, const Hit& hit) {
  const TextureAxes axes = texture_axes(record.tangent, unpacked_normal(record.face_normal));
  if (hit.instance == RTC_INVALID_GEOMETRY_ID) return axes;
  const Placement& place = world.instances[hit.instance].world_from_mesh;
  return {place.turn(axes.along), place.turn(axes.up)};
}

// Colour, gloss and tilt from the material's textures.
void add_textures(Surface& s,
                  const World& world,
                  const TriangleRecord& record,
                  const Hit& hit,
                  Vec3f direction,
                  float footprint,
                  TextureDetail detail) {
  const Material& material = world.materials[record.material];
  const float w = 1 - hit.u - hit.v;
  const Vec2f uv = record.uvs[0] * w + record.uvs[1] * hit.u + record.uvs[2] * hit.v;
  const float lod = record.texel_density + rough_log2(std::max(footprint, 1e-6F));
  const Texture& texture = world.textures[static_cast<std::size_t>(material.texture)];
  const bool full = detail == TextureDetail::full;
  s.albedo *=
      (full ? texture.filtered(uv.x, uv.y, lod) : texture.filtered_in_level(uv.x, uv.y, lod)).xyz();
  if (material.relief < 0) return;
  const ReliefTexture& reliefs = world.reliefs[static_cast<std::size_t>(material.relief)];
  const Relief relief = full ? reliefs.sample(uv.x, uv.y, lod) : reliefs.mean();
  s.roughness = std::min(1.0F, relief.roughness * material.roughness_scale);
  s.metallic = relief.metallic;
  if (full && is_tilted(relief) && lod < reliefs.flat_lod() && !s.back_face)
    s.relief_normal = tilted(s.normal, relief, axes_at(world, record, hit), direction);
}

// Of an item that shows wear.
WornPlace<float> worn_place(const TriangleRecord& record,
                            const Hit& hit,
                            const Surface& s,
                            float wear) {
  const float flatness =
      dot(unpacked4(record.face_normal.data()), unpacked4(record.normals[0].data()));
  return {wear, flatness, knock_of(s.id, hit.primitive), s.normal.z};
}

// Bit k: something lies on ray k.
unsigned blocked_lanes(const RTCRay16& packet, std::size_t used) {
  unsigned blocked = 0;
  for (std::size_t k = 0; k < used; ++k)
    blocked |= (packet.tfar[k] < 0 ? 1U : 0U) << k;
  return blocked;
}

// Whether rays of this mask can meet actors and what stands elsewhere.
bool meets_actors(const World& world, unsigned mask) {
  return world.actors.bvh && (mask & (mask_solid | mask_glass)) != 0;
}

// The row in World::instances of an Embree instance, or none.
std::uint32_t instance_row(unsigned instance, std::size_t first_row, unsigned first_geometry) {
  if (instance == RTC_INVALID_GEOMETRY_ID) return instance;
  return static_cast<std::uint32_t>(first_row) + (instance - first_geometry);
}
void set_hit(RTCHit16& packet, std::size_t k, const Hit& hit) {
  packet.geomID[k] = hit.geometry;
  packet.primID[k] = hit.primitive;
  packet.instID[0][k] = hit.instance;
  packet.u[k] = hit.u;
  packet.v[k] = hit.v;
}

Hit hit_of(const RTCRayHit& query, std::uint32_t instance) {
  return {query.ray.tfar, query.hit.geomID, query.hit.primID, instance, query.hit.u, query.hit.v};
}

void forget_hits(RTCHit16& hits) {
  for (std::size_t k = 0; k < packet_size; ++k) {
    hits.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    hits.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
}

// Rays end by now at what they met in the store: what they meet here lies before it.
void trace_actors(const World& world,
                  RTCRayHit16& packet,
                  std::size_t used,
                  RTCIntersectContext& context) {
  const RTCHit16 in_store = packet.hit;
  forget_hits(packet.hit);
  rtcIntersect16(lane_masks[used].data(), world.actors.bvh.get(), &context, &packet);
  for (std::size_t k = 0; k < used; ++k) {
    if (packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID) {
      packet.hit.instID[0][k] = actor_row(world, packet.hit.instID[0][k]);
      continue;
    }
    packet.hit.geomID[k] = in_store.geomID[k];
    packet.hit.primID[k] = in_store.primID[k];
    packet.hit.instID[0][k] = in_store.instID[0][k];
    packet.hit.u[k] = in_store.u[k];
    packet.hit.v[k] = in_store.v[k];
  }
}

RTCRayHit query_of(const Ray& ray, unsigned mask) {
  RTCRayHit query{};
  query.ray = embree_ray(ray, mask);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

Hit trace_in_store(const World& world, const Ray& ray, unsigned mask) {
  RTCRayHit query = query_of(ray, mask);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(world.bvh.get(), &context, &query);
  return hit_of(query, store_row(query.hit.instID[0]));
}

// The first hit in the store on a ray that passes through what is hidden.
Hit past_hidden(const World& world, Ray ray, Hit hit, unsigned mask) {
  while (is_hidden(world, hit)) {
    ray.near = hit.t + past_hidden_m;
    hit = trace_in_store(world, ray, mask);
  }
  return hit;
}

// `sent`: the rays before they met something.
void pass_hidden(const World& world,
                 const RTCRay16& sent,
                 RTCRayHit16& packet,
                 std::size_t used,
                 unsigned mask) {
  for (std::size_t k = 0; k < used; ++k) {
    const Hit met = hit_in(packet, k);
    if (!is_hidden(world, met)) continue;
    const Hit hit = past_hidden(world, ray_in(sent, k), met, mask);
    set_hit(packet.hit, k, hit);
    packet.ray.tfar[k] = hit.t;
  }
}

// Whether a ray comes near a hidden place at all.
bool may_meet_hidden(const World& world, const Ray& ray) {
  const Float4 low(world.hidden.bounds.low), high(world.hidden.bounds.high);
  const Float4 inverse(_mm_div_ps(_mm_set1_ps(1), Float4(ray.direction).m));
  const Float4 a = (low - Float4(ray.origin)) * inverse, b = (high - Float4(ray.origin)) * inverse;
  const Float4 enter = min(a, b), leave = max(a, b);
  const float from = std::max({enter.x(), enter.y(), enter.z(), ray.near});
  const float to = std::min({leave.x(), leave.y(), leave.z(), ray.far});
  return from <= to;
}

}  // namespace

RTCRay embree_ray(const Ray& ray, unsigned mask) {
  RTCRay r{};
  r.org_x = ray.origin.x;
  r.org_y = ray.origin.y;
  r.org_z = ray.origin.z;
  r.dir_x = ray.direction.x;
  r.dir_y = ray.direction.y;
  r.dir_z = ray.direction.z;
  r.tnear = ray.near;
  r.tfar = ray.far;
  r.mask = mask;
  return r;
}

std::uint32_t store_row(unsigned instance) {
  return instance_row(instance, 0, first_instance_geometry);
}
std::uint32_t actor_row(const World& world, unsigned instance) {
  return instance_row(instance, world.actors.first_instance, 0);
}

bool is_hidden(const World& world, const Hit& hit) {
  return world.hidden.has(hit.instance);
}

void trace(
    const World& world, RTCRayHit16& packet, std::size_t used, unsigned mask, RayBundle bundle) {
  describe_rays(packet.ray, mask);
  forget_hits(packet.hit);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (bundle == RayBundle::coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const bool any_hidden = world.hidden.in_bvh;
  RTCRay16 sent;
  if (any_hidden) sent = packet.ray;
  rtcIntersect16(lane_masks[used].data(), world.bvh.get(), &context, &packet);
  for (std::size_t k = 0; k < packet_size; ++k)
    packet.hit.instID[0][k] = store_row(packet.hit.instID[0][k]);
  if (any_hidden) pass_hidden(world, sent, packet, used, mask);
  if (meets_actors(world, mask)) trace_actors(world, packet, used, context);
  // Embree may leave numbers in lanes that are off; whoever reads eight lanes at a time is to see
  // no hit there.
  for (std::size_t k = used; k < packet_size; ++k)
    packet.hit.geomID[k] = packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
}

void trace(const World& world,
           std::span<const Ray> rays,
           std::span<Hit> hits,
           unsigned mask,
           RayBundle bundle) {
  RTCRayHit16 packet;
  set_rays(packet.ray, rays);
  trace(world, packet, rays.size(), mask, bundle);
  for (std::size_t k = 0; k < rays.size(); ++k)
    hits[k] = hit_in(packet, k);
}

unsigned find_blocked(const World& world, RTCRay16& packet, std::size_t used, unsigned mask) {
  describe_rays(packet, mask);
  const bool any_hidden = world.hidden.in_bvh;
  RTCRay16 sent;
  if (any_hidden) sent = packet;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(lane_masks[used].data(), world.bvh.get(), &context, &packet);
  if (meets_actors(world, mask))  // blocked lanes have tfar < tnear by now: they are passed over
    rtcOccluded16(lane_masks[used].data(), world.actors.bvh.get(), &context, &packet);
  unsigned blocked = blocked_lanes(packet, used);
  for (std::size_t k = 0; any_hidden && k < used; ++k) {
    if ((blocked >> k & 1U) == 0) continue;
    const Ray ray = ray_in(sent, k);
    if (may_meet_hidden(world, ray) && !trace_one(world, ray, mask).any()) blocked ^= 1U << k;
  }
  return blocked;
}

void find_blocked(const World& world,
                  std::span<const Ray> rays,
                  std::span<bool> blocked,
                  unsigned mask) {
  RTCRay16 packet;
  set_rays(packet, rays);
  const unsigned lanes = find_blocked(world, packet, rays.size(), mask);
  for (std::size_t k = 0; k < rays.size(); ++k)
    blocked[k] = (lanes >> k & 1U) != 0;
}

unsigned find_blocked_by_actors(const World& world, RTCRay16& packet, std::size_t used) {
  describe_rays(packet, mask_solid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded16(lane_masks[used].data(), world.actors.bvh.get(), &context, &packet);
  return blocked_lanes(packet, used);
}

void set_ray(RTCRay16& packet, std::size_t k, const Ray& ray) {
  packet.org_x[k] = ray.origin.x;
  packet.org_y[k] = ray.origin.y;
  packet.org_z[k] = ray.origin.z;
  packet.dir_x[k] = ray.direction.x;
  packet.dir_y[k] = ray.direction.y;
  packet.dir_z[k] = ray.direction.z;
  packet.tnear[k] = ray.near;
  packet.tfar[k] = ray.far;
}

void set_rays(RTCRay16& packet, std::size_t half, const Rays8& rays, float near) {
  const std::size_t from = half * lane_count;
  rays.origin.x.store(packet.org_x + from);
  rays.origin.y.store(packet.org_y + from);
  rays.origin.z.store(packet.org_z + from);
  rays.direction.x.store(packet.dir_x + from);
  rays.direction.y.store(packet.dir_y + from);
  rays.direction.z.store(packet.dir_z + from);
  Float8(near).store(packet.tnear + from);
  Float8(ray_infinity).store(packet.tfar + from);
}

Ray ray_in(const RTCRay16& packet, std::size_t k) {
  return {{packet.org_x[k], packet.org_y[k], packet.org_z[k]},
          {packet.dir_x[k], packet.dir_y[k], packet.dir_z[k]},
          packet.tnear[k],
          packet.tfar[k]};
}

Hit hit_in(const RTCRayHit16& packet, std::size_t k) {
  return {packet.ray.tfar[k],
          packet.hit.geomID[k],
          packet.hit.primID[k],
          packet.hit.instID[0][k],
          packet.hit.u[k],
          packet.hit.v[k]};
}

Hit trace_one(const World& world, const Ray& ray, unsigned mask) {
  const Hit in_store = past_hidden(world, ray, trace_in_store(world, ray, mask), mask);
  if (!meets_actors(world, mask)) return in_store;
  RTCRayHit query = query_of(ray, mask);
  if (in_store.any()) query.ray.tfar = in_store.t;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(world.actors.bvh.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return in_store;
  return hit_of(query, actor_row(world, query.hit.instID[0]));
}

Hit trace_instance(const World& world, std::uint32_t instance, const Ray& ray) {
  const Instance& row = world.instances[instance];
  const Ray local{row.world_from_mesh.to_local(ray.origin),
                  row.world_from_mesh.turn_back(ray.direction),
                  ray.near,
                  ray.far};
  RTCRayHit query = query_of(local, mask_solid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(world.meshes[row.mesh].bvh.get(), &context, &query);
  const bool met = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  return hit_of(query, met ? instance : RTC_INVALID_GEOMETRY_ID);
}

const TriangleRecord& record_of(const World& world, const Hit& hit) {
  if (hit.instance != RTC_INVALID_GEOMETRY_ID)
    return world.instances[hit.instance].records[hit.geometry][hit.primitive];
  if (hit.geometry == shell_glass_geometry) return world.shell_glass.records[hit.primitive];
  return (hit.geometry == ceiling_geometry ? world.ceiling : world.shell).records[hit.primitive];
}

Matter matter_of(const World& world, const Surface& surface) {
  if (world.materials[surface.material].clear) return Matter::clear;
  return surface.metallic > min_bare_metal ? Matter::metal : Matter::solid;
}

bool is_tilted(const Relief& relief) {
  constexpr float least = 0.012F;  // 0.7 degrees: relief below shows nowhere
  return std::max(std::fabs(relief.tilt_x), std::fabs(relief.tilt_y)) > least;
}

Vec3f tilted(Vec3f normal, const Relief& relief, const TextureAxes& axes, Vec3f direction) {
  const float squared = relief.tilt_x * relief.tilt_x + relief.tilt_y * relief.tilt_y;
  const Vec3f bent = normal * std::sqrt(std::max(0.0F, 1 - squared)) + axes.along * relief.tilt_x +
                     axes.up * relief.tilt_y;
  const float facing = dot(bent, direction);
  return normalized(facing > -min_facing ? bent - direction * (facing + min_facing) : bent);
}

Vec3f Surface::reflectance() const {
  const Vec3f dielectric{dielectric_reflectance, dielectric_reflectance, dielectric_reflectance};
  return mix(dielectric, albedo, metallic);
}

void fetch_surfaces(const World& world, std::span<const Hit> hits) {
  for (const Hit& hit : hits) {
    if (hit.any() && hit.instance != RTC_INVALID_GEOMETRY_ID)
      _mm_prefetch(reinterpret_cast<const char*>(&world.instances[hit.instance]), _MM_HINT_T0);
  }
  for (const Hit& hit : hits) {
    if (hit.any()) _mm_prefetch(reinterpret_cast<const char*>(&record_of(world, hit)), _MM_HINT_T0);
  }
}

void see_surface(const World& world,
                 const Ray& ray,
                 const Hit& hit,
                 float footprint,
                 TextureDetail detail,
                 Surface& s) {
  const TriangleRecord& record = record_of(world, hit);
  const Material& material = world.materials[record.material];
  Float4 face_normal = unpacked4(record.face_normal.data());
  Float4 normal = unpacked4(record.normals[0].data()) * (1 - hit.u - hit.v) +
                  unpacked4(record.normals[1].data()) * hit.u +
                  unpacked4(record.normals[2].data()) * hit.v;
  s.id = record.owner;
  s.light = record.light;
  s.fixture = -1;
  s.shelf = -1;
  s.albedo = material.color;
  float wear = 0;
  if (hit.instance != RTC_INVALID_GEOMETRY_ID) {
    const Instance& instance = world.instances[hit.instance];
    face_normal = turned(instance.world_from_mesh, face_normal);
    normal = turned(instance.world_from_mesh, normal);
    s.id = instance.id;
    s.fixture = instance.fixture;
    s.shelf = instance.shelf;
    if (s.light >= 0) s.light += instance.first_light;
    s.albedo *= instance.look.tint;
    wear = instance.look.wear;
  }
  const Float4 direction(ray.direction);
  face_viewer(s, face_normal, normal, direction);
  s.roughness = material.roughness;
  s.metallic = material.metallic;
  if (material.texture >= 0 && detail != TextureDetail::none) {
    const float slant = std::max(min_slant, -dot(s.face_normal, ray.direction));
    add_textures(s, world, record, hit, ray.direction, footprint / std::sqrt(slant), detail);
  }
  if (wear > 0) wear_off(worn_place(record, hit, s, wear), s.albedo, s.roughness);
  s.position = ray.origin + ray.direction * hit.t + s.face_normal * surface_lift_m;
  s.emission = material.emission;
  s.distance = hit.t;
  s.material = record.material;
  s.glass = material.glass;
}

}  // namespace marketgen::render::raytrace
