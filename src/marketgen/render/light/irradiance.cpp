#include "render/light/irradiance.h"

#include <algorithm>
#include <cmath>

#include "render/light/light_cache.h"
#include "render/shading_math.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float lookup_lift_m = 0.03F;  // probes are asked a little above the surface
constexpr float room_spacing_m = 0.6F, room_spacing_up_m = 0.4F;
constexpr float room_margin_m = 0.05F;
constexpr float max_room_probes = 30'000;
constexpr float along_spacing_m = 0.45F;
constexpr float min_behind = 0.04F;  // weight of room probes straight behind a surface

}  // namespace

Place place_of(Vec3f position, Vec3f face_normal, std::int32_t fixture, std::int32_t shelf) {
  return {position + face_normal * lookup_lift_m, fixture, shelf};
}
Place place_of(const Surface& surface) {
  return place_of(surface.position, surface.face_normal, surface.fixture, surface.shelf);
}

Vec3f AmbientCube::irradiance(Vec3f n) const {
  return faces[n.x < 0 ? 1 : 0] * (n.x * n.x) + faces[n.y < 0 ? 3 : 2] * (n.y * n.y) +
         faces[n.z < 0 ? 5 : 4] * (n.z * n.z);
}

IrradianceField::IrradianceField(const World& world,
                                 const LightGrid& lights,
                                 const scene::Scene& scene,
                                 bool keep) {
  place_room(world);
  place_shelves(scene);
  const std::string key = keep ? light_key(world, positions_) : std::string();
  if (std::optional<BakedLight> light = kept_light(key, positions_.size())) {
    light_ = *std::move(light);
    return;
  }
  bake(world, lights, room_of(scene.layout.shell).outline);
  if (keep) keep_light(key, light_);
}

void IrradianceField::place_room(const World& world) {
  const Bounds3 room = world.room.empty() ? Bounds3{{0, 0, 0}, {1, 1, 1}} : world.room;
  low_ = room.low + Vec3f{room_margin_m, room_margin_m, room_margin_m};
  const Vec3f extent = room.size() - Vec3f{1, 1, 1} * (2 * room_margin_m);
  const auto count = [](float length, float spacing) {
    return std::max(2, static_cast<int>(std::ceil(length / spacing)) + 1);
  };
  const float full =
      extent.x / room_spacing_m * extent.y / room_spacing_m * (extent.z / room_spacing_up_m);
  const float spacing = room_spacing_m * std::sqrt(std::max(1.0F, full / max_room_probes));
  size_ = {count(extent.x, spacing), count(extent.y, spacing), count(extent.z, room_spacing_up_m)};
  step_ = {extent.x / static_cast<float>(size_[0] - 1),
           extent.y / static_cast<float>(size_[1] - 1),
           extent.z / static_cast<float>(size_[2] - 1)};
  for (int z = 0; z < size_[2]; ++z) {
    for (int y = 0; y < size_[1]; ++y) {
      for (int x = 0; x < size_[0]; ++x) {
        positions_.push_back(low_ + step_ * Vec3f{static_cast<float>(x),
                                                  static_cast<float>(y),
                                                  static_cast<float>(z)});
      }
    }
  }
}

void IrradianceField::place_shelves(const scene::Scene& scene) {
  for (const scene::SceneFixture& fixture : scene.fixtures)
    shelves_of_fixture_.push_back({fixture.first_shelf, fixture.shelf_count});
  for (std::uint32_t i = 0; i < scene.shelves.size(); ++i) {
    const scene::SceneShelf& row = scene.shelves[i];
    Shelf shelf;
    shelf.world_from_shelf = placement_of(scene::world_from_shelf(scene, i));
    shelf.size = {row.width_m, row.depth_m, std::max(row.clearance_m, 0.05F)};
    shelf.first = static_cast<std::uint32_t>(positions_.size());
    shelf.columns = std::max(2, static_cast<int>(std::lround(row.width_m / along_spacing_m)) + 1);
    for (int c = 0; c < shelf.columns; ++c) {
      // Half a step inside the ends: side panels stand there.
      const float x =
          row.width_m * ((static_cast<float>(c) + 0.5F) / static_cast<float>(shelf.columns) - 0.5F);
      for (const float depth : depth_share) {
        for (const float height : height_share) {
          positions_.push_back(
              shelf.world_from_shelf({x, depth * shelf.size.y, height * shelf.size.z}));
        }
      }
    }
    shelves_.push_back(shelf);
  }
}

std::int32_t IrradianceField::shelf_at(Vec3f point) const {
  const auto found = std::find_if(shelves_.begin(), shelves_.end(), [&](const Shelf& shelf) {
    const Vec3f p = shelf.world_from_shelf.to_local(point);
    return std::fabs(p.x) < shelf.size.x / 2 && p.y > 0 && p.y < shelf.size.y && p.z > 0 &&
           p.z < shelf.size.z;
  });
  return found == shelves_.end() ? -1 : static_cast<std::int32_t>(found - shelves_.begin());
}

const IrradianceField::Shelf* IrradianceField::shelf_of(const Place& place, Vec3f facing) const {
  if (place.shelf >= 0) return &shelves_[static_cast<std::size_t>(place.shelf)];
  if (place.fixture < 0) return nullptr;
  const auto [first, count] = shelves_of_fixture_[static_cast<std::size_t>(place.fixture)];
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Shelf& shelf = shelves_[i];
    const Vec3f p = shelf.world_from_shelf.to_local(place.point);
    constexpr float reach = 0.06F, side_reach = 0.01F;  // what faces away from its side is outside
    // The outside of a back panel: its inside faces the goods.
    const bool is_behind = p.y > shelf.size.y && dot(shelf.world_from_shelf.y, facing) > 0.5F;
    if (std::fabs(p.x) < shelf.size.x / 2 + side_reach && p.y > -0.01F &&
        p.y < shelf.size.y + reach && p.z > -0.01F && p.z < shelf.size.z + reach && !is_behind) {
      return &shelf;
    }
  }
  return nullptr;
}

namespace {

// Where `at` lies among ascending places: the one before it and how far it is to the next.
struct Between {
  int before = 0;
  float share = 0;
};
template <std::size_t count>
Between between(const std::array<float, count>& places, float at) {
  const float inside = std::clamp(at, places.front(), places.back());
  std::size_t i = 0;
  while (i + 2 < count && inside > places[i + 1])
    ++i;
  return {static_cast<int>(i), (inside - places[i]) / (places[i + 1] - places[i])};
}
Between between(int count, float at) {
  const float inside = std::clamp(at, 0.0F, static_cast<float>(count - 1));
  const int before = std::min(static_cast<int>(inside), count - 2);
  return {before, inside - static_cast<float>(before)};
}

// The corners of a cell side by side: which way each lies, 0 or 1, and its trilinear weight.
struct EightCorners {
  Float8 dx{_mm256_setr_ps(0, 1, 0, 1, 0, 1, 0, 1)}, dy{_mm256_setr_ps(0, 0, 1, 1, 0, 0, 1, 1)},
      dz{_mm256_setr_ps(0, 0, 0, 0, 1, 1, 1, 1)}, near;

  EightCorners(const Between& x, const Between& y, const Between& z) {
    const auto share = [](const Between& at, Float8 far) {
      return select(far > Float8(0), Float8(at.share), Float8(1 - at.share));
    };
    near = share(x, dx) * share(y, dy) * share(z, dz);
  }
};

}  // namespace

IrradianceField::Corners IrradianceField::corners_in_shelf(const Shelf& shelf, Vec3f point) const {
  const Vec3f p = shelf.world_from_shelf.to_local(point);
  const Between along = between(
      shelf.columns, (p.x / shelf.size.x + 0.5F) * static_cast<float>(shelf.columns) - 0.5F);
  const Between inward = between(depth_share, p.y / shelf.size.y);
  const Between up = between(height_share, p.z / shelf.size.z);
  const EightCorners eight(along, inward, up);
  const int first = static_cast<int>(shelf.first) +
                    (along.before * depth_rows + inward.before) * height_rows + up.before;
  return {Int8(first) + to_int(eight.dx) * (depth_rows * height_rows) +
              to_int(eight.dy) * height_rows + to_int(eight.dz),
          eight.near};
}

// Probes behind the surface count for little: they may be on the other side of a wall (as in
// Majercik et al., "Dynamic diffuse global illumination with ray-traced irradiance fields", JCGT
// 2019).
IrradianceField::Corners IrradianceField::corners_in_room(Vec3f point, Float4 facing) const {
  const Vec3f at = point - low_;
  const Between x = between(size_[0], at.x / step_.x), y = between(size_[1], at.y / step_.y),
                z = between(size_[2], at.z / step_.z);
  const EightCorners eight(x, y, z);
  // Where each corner lies from the point, and how near.
  const Float8 off_x = (static_cast<float>(x.before) + eight.dx) * step_.x - at.x;
  const Float8 off_y = (static_cast<float>(y.before) + eight.dy) * step_.y - at.y;
  const Float8 off_z = (static_cast<float>(z.before) + eight.dz) * step_.z - at.z;
  const Float8 along = off_x * facing.x() + off_y * facing.y() + off_z * facing.z();
  const Float8 distance = square_root(off_x * off_x + off_y * off_y + off_z * off_z + 1e-6F);
  const Float8 before = 0.5F + 0.5F * along / distance;
  const int row = size_[0], layer = size_[0] * size_[1];
  const int first = z.before * layer + y.before * row + x.before;
  return {Int8(first) + to_int(eight.dx) + to_int(eight.dy) * row + to_int(eight.dz) * layer,
          (eight.near + 1e-4F) * (before * before + min_behind)};
}

// Two faces lie in one register, the one in front along an axis and the one behind; one of them
// counts.
Float4 IrradianceField::gathered(const std::vector<PackedCube>& probes,
                                 const Corners& corners,
                                 Float4 facing) const {
  const Float4 square = facing * facing;
  const float share[3] = {square.x(), square.y(), square.z()};
  const int negative = _mm_movemask_ps(facing.m);
  std::array<Float8, 3> shares;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const __m128 counts = _mm_set1_ps(share[axis]), none = _mm_setzero_ps();
    shares[axis] = Float8((negative >> axis & 1) != 0 ? _mm256_set_m128(counts, none)
                                                      : _mm256_set_m128(none, counts));
  }
  alignas(32) std::array<std::int32_t, lane_count> probe;
  alignas(32) std::array<float, lane_count> weight;
  corners.probe.store(probe.data());
  corners.weight.store(weight.data());
  std::array<Float8, 3> sum;
  for (std::size_t k = 0; k < lane_count; ++k) {
    const auto& faces = probes[static_cast<std::size_t>(probe[k])].faces;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto* pair = reinterpret_cast<const __m128i*>(faces[2 * axis].data());
      sum[axis] += Float8(_mm256_cvtph_ps(_mm_load_si128(pair))) * weight[k];
    }
  }
  const Float8 both = sum[0] * shares[0] + sum[1] * shares[1] + sum[2] * shares[2];
  const Float4 light(_mm_add_ps(_mm256_castps256_ps128(both.m), _mm256_extractf128_ps(both.m, 1)));
  // Light was stored times validity, so that what is in matter counts by itself for nothing.
  return light.w() > 1e-5F ? light * (1 / light.w()) : Float4(light_.mean);
}

IrradianceField::Corners IrradianceField::corners_at(const Place& place, Float4 facing) const {
  const Shelf* shelf = shelf_of(place, facing.xyz());
  return shelf != nullptr ? corners_in_shelf(*shelf, place.point)
                          : corners_in_room(place.point, facing);
}

Vec3f IrradianceField::at(const Place& place, Vec3f facing) const {
  const Float4 normal(facing);
  return gathered(light_.probes, corners_at(place, normal), normal).xyz();
}

IrradianceField::TwoSided IrradianceField::at(const Place& place,
                                              Float4 facing,
                                              Float4 mirror) const {
  const Corners corners = corners_at(place, facing);
  return {gathered(light_.probes, corners, facing),
          gathered(light_.without_panels, corners, mirror)};
}

float IrradianceField::goods_median() const {
  std::vector<float> light;
  for (std::size_t i = 0; i < shelves_.size(); ++i) {
    const Shelf& shelf = shelves_[i];
    const Vec3f outward = shelf.world_from_shelf.turn({0, -1, 0});
    for (int c = 0; c < shelf.columns; ++c) {
      const float along = (static_cast<float>(c) + 0.5F) / static_cast<float>(shelf.columns) - 0.5F;
      const Vec3f front = shelf.world_from_shelf({shelf.size.x * along, 0, shelf.size.z / 2});
      light.push_back(luminance(at({front, -1, static_cast<std::int32_t>(i)}, outward)));
    }
  }
  if (light.empty()) return 0;
  const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
  std::nth_element(light.begin(), middle, light.end());
  return *middle;
}

float IrradianceField::tilt(const Place& place, Vec3f facing, Vec3f tilted) const {
  const Corners corners = corners_at(place, Float4(facing));
  const float flat = luminance(gathered(light_.probes, corners, Float4(facing)).xyz());
  return flat > 0 ? luminance(gathered(light_.probes, corners, Float4(tilted)).xyz()) / flat : 1;
}

}  // namespace marketgen::render::raytrace
