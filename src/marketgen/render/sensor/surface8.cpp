#include "render/sensor/surface8.h"

#include <bit>
#include <cstddef>

#include "render/sensor/texture8.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

// Numbers of four bytes of one row for each lane, in the order in which the row has them.
struct Numbers {
  Rows8 low, high;

  explicit Numbers(const std::array<const void*, lane_count>& rows) : low(side_by_side(rows)) {
    std::array<const void*, lane_count> later;
    for (std::size_t k = 0; k < lane_count; ++k)
      later[k] = static_cast<const std::byte*>(rows[k]) + 32;
    high = side_by_side(later);
  }
  Int8 whole(std::size_t at) const { return at < 32 ? low[at / 4] : high[at / 4 - 8]; }
  Float8 real(std::size_t at) const { return float_of_bits(whole(at)); }
  Vec8 vector(std::size_t at) const { return {real(at), real(at + 4), real(at + 8)}; }
  // A 16-bit number in 1/32767.
  Float8 unit(std::size_t at) const {
    const __m256i pair = whole(at / 4 * 4).m;
    const __m256i top = at % 4 == 0 ? _mm256_slli_epi32(pair, 16) : pair;
    return to_float(Int8(_mm256_srai_epi32(top, 16))) * (1.0F / 32767);
  }
  Vec8 unit_vector(std::size_t at) const { return {unit(at), unit(at + 2), unit(at + 4)}; }
};

// Rows of what the lanes show; lanes without a hit have the row of one with.
struct SurfaceRows {
  std::array<const TriangleRecord*, lane_count> records;
  std::array<const void*, lane_count> instances;
};

const Instance room_itself;  // what stands in the store frame as it is

SurfaceRows rows_of(const World& world, const Hits8& hits) {
  SurfaceRows rows;
  std::array<std::uint32_t, lane_count> geometry, primitive, instance;
  hits.geometry.store(geometry.data());
  hits.primitive.store(primitive.data());
  hits.instance.store(instance.data());
  const unsigned met = hits.any.bits();
  const auto first = static_cast<std::size_t>(std::countr_zero(met));
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const std::size_t k = (met >> lane & 1U) != 0 ? lane : first;
    Hit hit;
    hit.geometry = geometry[k];
    hit.primitive = primitive[k];
    hit.instance = instance[k];
    rows.records[lane] = &record_of(world, hit);
    rows.instances[lane] =
        hit.instance == RTC_INVALID_GEOMETRY_ID ? &room_itself : &world.instances[hit.instance];
  }
  return rows;
}

Vec8 turned(const Numbers& instance, const Vec8& v) {
  constexpr std::size_t x = offsetof(Instance, world_from_mesh), y = x + 12, z = y + 12;
  static_assert(z + 12 == 64);
  return instance.vector(x) * v.x + instance.vector(y) * v.y + instance.vector(z) * v.z;
}

// As face_viewer() of tracing.cpp.
Mask8 face_viewer(Surface8& s, Vec8 face_normal, Vec8 normal, const Vec8& direction) {
  const Mask8 back = dot(face_normal, direction) > Float8(0);
  face_normal = select(back, -face_normal, face_normal);
  normal = normalized(select(dot(normal, face_normal) < Float8(0), -normal, normal));
  const Float8 facing = dot(normal, direction);
  const Mask8 averted = facing > Float8(-min_facing);
  if (averted.any())
    normal = select(averted, normalized(normal - direction * (facing + min_facing)), normal);
  s.face_normal = face_normal;
  s.normal = s.relief_normal = normal;
  return back;
}

class TextureLanes {
 public:
  TextureLanes(const World& world, const Hits8& hits, const SurfaceRows& rows, Surface8& surfaces)
      : world_(world), hits_(hits), rows_(rows), s_(surfaces) {}

  // `textures` and `reliefs` are rows of the world, -1 = none.
  void add(const Numbers& record,
           Int8 textures,
           Int8 reliefs,
           Float8 relief_roughness,
           Mask8 back_face,
           const Vec8& direction,
           Float8 footprint,
           TextureDetail detail) {
    const Mask8 textured = drawn(textures);
    if (!textured.any()) return;
    place(record, direction, footprint);
    color(textures, textured, detail);
    const Mask8 relieved = textured & (reliefs > Int8(-1));
    if (!relieved.any()) return;
    if (detail == TextureDetail::full)
      return relieve(reliefs, relieved, relief_roughness, back_face, direction);
    for (std::size_t k = 0; k < lane_count; ++k) {
      if (!relieved[k]) continue;
      const Relief& mean = relief(reliefs, k).mean();
      s_.roughness.set(k, std::min(1.0F, mean.roughness * relief_roughness[k]));
      s_.metallic.set(k, mean.metallic);
    }
  }

 private:
  // Lanes with a texture that holds something.
  Mask8 drawn(Int8 textures) const {
    std::array<std::int32_t, lane_count> is_drawn{};
    for (std::size_t k = 0; k < lane_count; ++k)
      is_drawn[k] =
          textures[k] >= 0 && !world_.textures[static_cast<std::size_t>(textures[k])].empty() ? -1
                                                                                              : 0;
    return Mask8(float_of_bits(Int8::load(is_drawn.data())).m);
  }

  void place(const Numbers& record, const Vec8& direction, Float8 footprint) {
    constexpr std::size_t uvs = offsetof(TriangleRecord, uvs);
    const Float8 w = 1 - hits_.u - hits_.v;
    u_ = record.real(uvs) * w + record.real(uvs + 8) * hits_.u + record.real(uvs + 16) * hits_.v;
    v_ = record.real(uvs + 4) * w + record.real(uvs + 12) * hits_.u +
         record.real(uvs + 20) * hits_.v;
    const Float8 slant = max(-dot(s_.face_normal, direction), Float8(min_slant));
    lod_ = record.real(offsetof(TriangleRecord, texel_density)) +
           rough_log2(max(footprint / square_root(slant), Float8(1e-6F)));
  }

  void color(Int8 textures, Mask8 textured, TextureDetail detail) {
    TexturePoints points{{}, u_, v_, lod_};
    const auto first = static_cast<std::size_t>(std::countr_zero(textured.bits()));
    for (std::size_t k = 0; k < lane_count; ++k)
      points.textures[k] =
          &world_.textures[static_cast<std::size_t>(textures[textured[k] ? k : first])];
    const Vec8 seen = filtered(points, detail);
    s_.albedo *= select(textured, seen, Vec8{1, 1, 1});
  }

  const ReliefTexture& relief(Int8 reliefs, std::size_t k) const {
    return world_.reliefs[static_cast<std::size_t>(reliefs[k])];
  }

  void relieve(Int8 reliefs,
               Mask8 relieved,
               Float8 relief_roughness,
               Mask8 back_face,
               const Vec8& direction) {
    TexelPoints points{{}, u_, v_, lod_};
    const auto first = static_cast<std::size_t>(std::countr_zero(relieved.bits()));
    for (std::size_t k = 0; k < lane_count; ++k)
      points.chains[k] = &relief(reliefs, relieved[k] ? k : first).mips();
    const std::array<Float8, 4> bytes = filtered(points);
    for (std::size_t k = 0; k < lane_count; ++k) {
      if (!relieved[k]) continue;
      const Relief here =
          ReliefTexture::decoded({bytes[0][k], bytes[1][k], bytes[2][k], bytes[3][k]});
      s_.roughness.set(k, std::min(1.0F, here.roughness * relief_roughness[k]));
      s_.metallic.set(k, here.metallic);
      if (is_tilted(here) && lod_[k] < relief(reliefs, k).flat_lod() && !back_face[k])
        set_lane(s_.relief_normal, k, tilted_normal(k, here, lane(direction, k)));
    }
  }

  Vec3f tilted_normal(std::size_t k, const Relief& here, Vec3f direction) const {
    const TriangleRecord& record = *rows_.records[k];
    TextureAxes axes = texture_axes(record.tangent, unpacked_normal(record.face_normal));
    const Placement& place = static_cast<const Instance*>(rows_.instances[k])->world_from_mesh;
    axes = {place.turn(axes.along), place.turn(axes.up)};
    return tilted(lane(s_.normal, k), here, axes, direction);
  }

  const World& world_;
  const Hits8& hits_;
  const SurfaceRows& rows_;
  Surface8& s_;
  Float8 u_, v_, lod_;
};

}  // namespace

Hits8 hits_of(const RTCRayHit16& packet, std::size_t half) {
  const std::size_t from = half * lane_count;
  Hits8 hits;
  hits.geometry = Int8::load(packet.hit.geomID + from);
  hits.primitive = Int8::load(packet.hit.primID + from);
  hits.instance = Int8::load(packet.hit.instID[0] + from);
  hits.any = ~(hits.geometry == Int8(static_cast<std::int32_t>(RTC_INVALID_GEOMETRY_ID)));
  hits.t = select(hits.any, Float8::load(packet.ray.tfar + from), Float8());
  hits.u = select(hits.any, Float8::load(packet.hit.u + from), Float8());
  hits.v = select(hits.any, Float8::load(packet.hit.v + from), Float8());
  return hits;
}

Surface surface_in(const Surface8& s, std::size_t k) {
  Surface surface;
  surface.position = lane(s.position, k);
  surface.face_normal = lane(s.face_normal, k);
  surface.normal = lane(s.normal, k);
  surface.relief_normal = lane(s.relief_normal, k);
  surface.albedo = lane(s.albedo, k);
  surface.emission = lane(s.emission, k);
  surface.roughness = s.roughness[k];
  surface.metallic = s.metallic[k];
  surface.distance = s.distance[k];
  surface.id = static_cast<std::uint32_t>(s.id[k]);
  surface.material = static_cast<std::uint16_t>(s.material[k]);
  surface.fixture = s.fixture[k];
  surface.shelf = s.shelf[k];
  surface.glass = s.glass[k];
  return surface;
}

void set_surface(Surface8& s, std::size_t k, const Surface& surface, bool clear) {
  const auto set_mask = [k](Mask8& mask, bool value) {
    Int8 lanes = bits_of(Float8(mask.m));
    lanes.set(k, value ? -1 : 0);
    mask = Mask8(float_of_bits(lanes).m);
  };
  set_lane(s.position, k, surface.position);
  set_lane(s.face_normal, k, surface.face_normal);
  set_lane(s.normal, k, surface.normal);
  set_lane(s.relief_normal, k, surface.relief_normal);
  set_lane(s.albedo, k, surface.albedo);
  set_lane(s.emission, k, surface.emission);
  s.roughness.set(k, surface.roughness);
  s.metallic.set(k, surface.metallic);
  s.distance.set(k, surface.distance);
  s.id.set(k, static_cast<std::int32_t>(surface.id));
  s.material.set(k, surface.material);
  s.fixture.set(k, surface.fixture);
  s.shelf.set(k, surface.shelf);
  set_mask(s.glass, surface.glass);
  set_mask(s.clear, clear);
}

void see_surfaces(const World& world,
                  const Rays8& rays,
                  const Hits8& hits,
                  Float8 footprint,
                  TextureDetail detail,
                  Surface8& s) {
  if (!hits.any.any()) {
    s = {};
    return;
  }
  const SurfaceRows rows = rows_of(world, hits);
  std::array<const void*, lane_count> record_rows, material_rows;
  for (std::size_t k = 0; k < lane_count; ++k) {
    record_rows[k] = rows.records[k];
    material_rows[k] = &world.materials[rows.records[k]->material];
  }
  const Numbers record(record_rows), instance(rows.instances), material(material_rows);
  constexpr std::size_t normals = offsetof(TriangleRecord, normals);
  const Vec8 normal = record.unit_vector(normals) * (1 - hits.u - hits.v) +
                      record.unit_vector(normals + 6) * hits.u +
                      record.unit_vector(normals + 12) * hits.v;
  const Vec8 face_normal = record.unit_vector(offsetof(TriangleRecord, face_normal));
  const Mask8 back_face =
      face_viewer(s, turned(instance, face_normal), turned(instance, normal), rays.direction);
  s.position = rays.origin + rays.direction * hits.t + s.face_normal * Float8(surface_lift_m);
  s.distance = hits.t;
  const Mask8 in_room = hits.instance == Int8(static_cast<std::int32_t>(RTC_INVALID_GEOMETRY_ID));
  s.id = select(in_room,
                record.whole(offsetof(TriangleRecord, owner)),
                instance.whole(offsetof(Instance, id)));
  s.fixture = instance.whole(offsetof(Instance, fixture));
  s.shelf = instance.whole(offsetof(Instance, shelf));
  s.material = record.whole(offsetof(TriangleRecord, material)) & 0xFFFF;
  constexpr std::size_t look = offsetof(Instance, look);
  s.albedo =
      material.vector(offsetof(Material, color)) * instance.vector(look + offsetof(ItemLook, tint));
  s.emission = material.vector(offsetof(Material, emission));
  s.roughness = material.real(offsetof(Material, roughness));
  s.metallic = material.real(offsetof(Material, metallic));
  const Int8 kind = material.whole(offsetof(Material, glass));
  s.glass = (kind & 0xFF) > Int8(0);
  s.clear = (kind & 0xFF00) > Int8(0);
  if (detail == TextureDetail::none) return;
  TextureLanes(world, hits, rows, s)
      .add(record,
           material.whole(offsetof(Material, texture)),
           material.whole(offsetof(Material, relief)),
           material.real(offsetof(Material, roughness_scale)),
           back_face,
           rays.direction,
           footprint,
           detail);
  const Float8 wear = instance.real(look + offsetof(ItemLook, wear));
  if (!(wear > Float8()).any()) return;
  const Float8 flatness = dot(face_normal, record.unit_vector(normals));
  wear_off<Float8>(
      {wear, flatness, knock_of(s.id, hits.primitive), s.normal.z}, s.albedo, s.roughness);
}

void fetch_surfaces(const World& world, const RTCRayHit16& packet) {
  for (std::size_t k = 0; k < packet_size; ++k) {
    const std::uint32_t instance = packet.hit.instID[0][k];
    if (instance == RTC_INVALID_GEOMETRY_ID) continue;
    const auto* row = reinterpret_cast<const char*>(&world.instances[instance]);
    _mm_prefetch(row, _MM_HINT_T0);
    _mm_prefetch(row + sizeof(Instance) - 1, _MM_HINT_T0);
  }
  for (std::size_t k = 0; k < packet_size; ++k) {
    if (packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
    Hit hit;
    hit.geometry = packet.hit.geomID[k];
    hit.primitive = packet.hit.primID[k];
    hit.instance = packet.hit.instID[0][k];
    _mm_prefetch(reinterpret_cast<const char*>(&record_of(world, hit)), _MM_HINT_T0);
  }
}

}  // namespace marketgen::render::raytrace
