#include "render/irradiance.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/light_cache.h"
#include "render/room.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float lookup_lift_m = 0.03F;  // probes are asked a little above the surface
constexpr float room_spacing_m = 0.6F, room_spacing_up_m = 0.4F;
constexpr float room_margin_m = 0.05F;
constexpr float most_room_probes = 30'000;
constexpr int depth_rows = 4, height_rows = 3;
constexpr float along_spacing_m = 0.45F;
// Depths of the probe rows behind a shelf's front edge: one row before the edge, where goods catch
// the most light.
constexpr std::array<float, depth_rows> depth_share{-0.1F, 0.12F, 0.4F, 0.85F};
constexpr std::array<float, height_rows> height_share{0.12F, 0.5F, 0.88F};
constexpr int rays_per_probe = 48;  // a multiple of packet_size
constexpr float near_light = 1.5F;  // lights nearer than this times their size get four samples
constexpr int bounces = 4;
constexpr float least_behind = 0.04F;  // weight of room probes straight behind a surface
constexpr float most_back_faces =
    0.25F;  // share of rays that hit the inside of something: the probe is in matter
constexpr float probe_footprint_m = 0.2F;
// A room probe with so many things so near stands in a hollow of a fixture: it knows nothing of the
// faces outside.
constexpr float hollow_m = 0.22F, most_near = 0.55F;

const std::array<Vec3f, 6> axes{
    Vec3f{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// What one probe ray met: a surface that bounces light, unless `color` is black.
struct Meeting {
  Place place;
  Vec3f normal, color;
};

struct ProbeRays {
  std::array<Meeting, rays_per_probe> meetings;
  AmbientCube direct;  // lamps, daylight and glowing things
  AmbientCube panels;  // the ceiling panels' part of that
  bool valid = true;
};

void add_from(AmbientCube& cube, Vec3f direction, Vec3f radiance_times_angle) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const float facing = dot(axes[a], direction);
    if (facing > 0) cube.faces[a] += radiance_times_angle * facing;
  }
}

// Light from points of the lamps on the way to a probe.
class LampRays {
 public:
  LampRays(const World& world, Vec3f position, ProbeRays& probe)
      : world_(world), position_(position), probe_(probe) {}
  ~LampRays() { finish(); }
  LampRays(const LampRays&) = delete;
  LampRays& operator=(const LampRays&) = delete;

  void add(std::uint32_t number) {
    const AreaLight& light = world_.lights[number];
    const Vec3f middle = light.corner + (light.edge_u + light.edge_v) * 0.5F;
    const float size = std::max(length(light.edge_u), length(light.edge_v));
    if (length(middle - position_) > near_light * size) return add_point(number, 0.5F, 0.5F, 1);
    constexpr float quarters[2] = {0.25F, 0.75F};
    for (const float u : quarters) {
      for (const float v : quarters)
        add_point(number, u, v, 0.25F);
    }
  }

 private:
  void add_point(std::uint32_t number, float u, float v, float share) {
    const AreaLight& light = world_.lights[number];
    const Vec3f way = light.corner + light.edge_u * u + light.edge_v * v - position_;
    const float distance = std::max(length(way), 1e-3F);
    const Vec3f direction = way / distance;
    const float facing = -dot(direction, light.normal);
    if (facing <= 0) return;
    // As from a disc of that area: a probe beside a lamp gets no more than the lamp gives.
    const float solid_angle =
        light.area * share * facing / (distance * distance + light.area * share * inverse_pi);
    rays_[used_] = {position_, direction, 0, distance - 0.01F};
    numbers_[used_] = number;
    light_[used_++] = light.radiance * solid_angle;
    if (used_ == packet_size) finish();
  }

  void finish() {
    if (used_ == 0) return;
    std::array<bool, packet_size> blocked{};
    find_blocked(
        world_, std::span(rays_).first(used_), std::span(blocked).first(used_), mask_opaque);
    for (std::size_t k = 0; k < used_; ++k) {
      if (blocked[k]) continue;
      add_from(probe_.direct, rays_[k].direction, light_[k]);
      if (numbers_[k] < world_.panel_count) add_from(probe_.panels, rays_[k].direction, light_[k]);
    }
    used_ = 0;
  }

  const World& world_;
  Vec3f position_;
  ProbeRays& probe_;
  std::size_t used_ = 0;
  std::array<Ray, packet_size> rays_;
  std::array<std::uint32_t, packet_size> numbers_;
  std::array<Vec3f, packet_size> light_;
};

// Light straight from the lamps that matter there, each from one point or four.
void add_lamps(const World& world, const LightGrid& lights, Vec3f position, ProbeRays& probe) {
  LampRays rays(world, position, probe);
  for (const LightChoice& choice : lights.choices(position))
    rays.add(choice.light);
}

// Light times validity, in half precision.
std::vector<PackedCube> packed(const std::vector<AmbientCube>& probes) {
  constexpr float most = 6e4F;  // of a half, nearly
  std::vector<PackedCube> result(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (std::size_t a = 0; a < axes.size(); ++a) {
      const Vec3f light = probes[i].faces[a];
      const Float4 lanes = Float4(light.x, light.y, light.z, 1) * probes[i].validity;
      const __m128 kept = _mm_min_ps(_mm_max_ps(lanes.m, _mm_setzero_ps()), _mm_set1_ps(most));
      _mm_storel_epi64(reinterpret_cast<__m128i*>(result[i].faces[a].data()),
                       _mm_cvtps_ph(kept, _MM_FROUND_TO_NEAREST_INT));
    }
  }
  return result;
}

// Metals send on most of what they get, though not diffusely.
Vec3f bounce_color(const Surface& surface) {
  return surface.albedo * (1 - 0.3F * surface.metallic);
}

enum class Hollows { lit, left_out };

void shoot(const World& world, Vec3f position, Hollows hollows, ProbeRays& result) {
  constexpr float solid_angle = 4 * pi / rays_per_probe;
  int back_faces = 0, near = 0;
  for (int start = 0; start < rays_per_probe; start += static_cast<int>(packet_size)) {
    std::array<Ray, packet_size> rays;
    std::array<Hit, packet_size> hits;
    for (std::size_t k = 0; k < packet_size; ++k) {
      rays[k] = {position, sphere_direction(start + static_cast<int>(k), rays_per_probe)};
    }
    trace(world, rays, hits, mask_opaque, RayBundle::scattered);
    for (std::size_t k = 0; k < packet_size; ++k) {
      Meeting& meeting = result.meetings[static_cast<std::size_t>(start) + k];
      if (!hits[k].any()) {
        add_from(result.direct,
                 rays[k].direction,
                 world.surroundings.radiance(rays[k].direction) * solid_angle);
        continue;
      }
      const Surface surface = surface_at(world, rays[k], hits[k], probe_footprint_m);
      near += hits[k].t < hollow_m ? 1 : 0;
      if (surface.back_face)
        ++back_faces;
      else
        meeting = {place_of(surface), surface.normal, bounce_color(surface)};
      if (surface.light < 0)
        add_from(result.direct, rays[k].direction, surface.emission * solid_angle);
    }
  }
  result.valid =
      static_cast<float>(back_faces) <= most_back_faces * rays_per_probe &&
      (hollows == Hollows::lit || static_cast<float>(near) <= most_near * rays_per_probe);
}

bool is_outside(const PolygonMm& outline, Vec3f point) {
  return !contains(outline,
                   {static_cast<int>(std::lround(point.x * 1000)),
                    static_cast<int>(std::lround(point.y * 1000))});
}

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
                                 const Scene& scene,
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
  const float spacing = room_spacing_m * std::sqrt(std::max(1.0F, full / most_room_probes));
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

void IrradianceField::place_shelves(const Scene& scene) {
  for (const SceneFixture& fixture : scene.fixtures)
    shelves_of_fixture_.push_back({fixture.first_shelf, fixture.shelf_count});
  for (std::uint32_t i = 0; i < scene.shelves.size(); ++i) {
    const SceneShelf& row = scene.shelves[i];
    Shelf shelf;
    shelf.world_from_shelf = placement_of(world_from_shelf(scene, i));
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

void IrradianceField::bake(const World& world, const LightGrid& lights, const PolygonMm& outline) {
  probes_.resize(positions_.size());
  std::vector<ProbeRays> rays(positions_.size());
  const auto room_count = static_cast<std::size_t>(size_[0] * size_[1] * size_[2]);
  parallel_for(
      positions_.size(),
      [&](std::size_t i) {
        if (i < room_count && (is_outside(outline, positions_[i]) || shelf_at(positions_[i]) >= 0))
          rays[i].valid = false;
        const Hollows hollows = i < room_count ? Hollows::left_out : Hollows::lit;
        if (rays[i].valid) shoot(world, positions_[i], hollows, rays[i]);
        if (!rays[i].valid) return;
        add_lamps(world, lights, positions_[i], rays[i]);
        rays[i].direct.validity = 1;
        probes_[i] = rays[i].direct;
      },
      32);
  constexpr float solid_angle = 4 * pi / rays_per_probe;
  for (int bounce = 0; bounce < bounces; ++bounce) {
    light_.mean = mean_of_room();
    fill_invalid(probes_);
    fill_room(probes_);
    light_.probes = packed(probes_);
    parallel_for(
        probes_.size(),
        [&](std::size_t i) {
          probes_[i] = {};
          if (!rays[i].valid) return;
          probes_[i] = rays[i].direct;
          for (int k = 0; k < rays_per_probe; ++k) {
            const Meeting& meeting = rays[i].meetings[static_cast<std::size_t>(k)];
            if (largest(meeting.color) <= 0) continue;
            const Vec3f radiance = meeting.color * at(meeting.place, meeting.normal) * inverse_pi;
            add_from(probes_[i], sphere_direction(k, rays_per_probe), radiance * solid_angle);
          }
        },
        32);
  }
  light_.mean = mean_of_room();
  light_.floor_mean = mean_of_floor();
  std::vector<AmbientCube> rest = probes_;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (std::size_t a = 0; a < axes.size(); ++a)
      rest[i].faces[a] = rest[i].faces[a] - rays[i].panels.faces[a];
  }
  for (std::vector<AmbientCube>* cubes : {&probes_, &rest}) {
    fill_invalid(*cubes);
    fill_room(*cubes);
  }
  light_.probes = packed(probes_);
  light_.without_panels = packed(rest);
  probes_ = {};
}

Vec3f IrradianceField::mean_of_room() const {
  const auto room_count = static_cast<std::size_t>(size_[0] * size_[1] * size_[2]);
  Vec3f sum;
  float count = 0;
  for (std::size_t i = 0; i < room_count; ++i) {
    for (const Vec3f& face : probes_[i].faces)
      sum += face * (probes_[i].validity / 6);
    count += probes_[i].validity;
  }
  return count > 0 ? sum / count : Vec3f{};
}

// Within a shelf, a point in a pack takes the mean of the shelf's free points at the same depth,
// else of all of them.
void IrradianceField::fill_invalid(std::vector<AmbientCube>& probes) const {
  for (const Shelf& shelf : shelves_) {
    constexpr std::size_t per_column = depth_rows * height_rows;
    const std::size_t total = static_cast<std::size_t>(shelf.columns) * per_column;
    for (const bool same_depth : {true, false}) {
      std::vector<AmbientCube> filled(
          probes.begin() + shelf.first,
          probes.begin() + shelf.first + static_cast<std::ptrdiff_t>(total));
      for (std::size_t i = 0; i < total; ++i) {
        if (filled[i].validity > 0) continue;
        AmbientCube mean;
        for (std::size_t j = 0; j < total; ++j) {
          const AmbientCube& other = probes[shelf.first + j];
          if (other.validity < 1 ||
              (same_depth && i % per_column / height_rows != j % per_column / height_rows))
            continue;
          for (std::size_t a = 0; a < 6; ++a)
            mean.faces[a] += other.faces[a];
          mean.validity += 1;
        }
        if (mean.validity == 0) continue;
        for (Vec3f& face : mean.faces)
          face = face / mean.validity;
        mean.validity = 0.5F;  // counts less than a measured one, and is not spread further
        filled[i] = mean;
      }
      std::copy(filled.begin(), filled.end(), probes.begin() + shelf.first);
    }
  }
}

// A room point in matter or in a hollow takes the mean of the known ones beside it, those that were
// filled before included, so that gaps without a point of their own get their surroundings' light.
void IrradianceField::fill_room(std::vector<AmbientCube>& probes) const {
  constexpr int passes = 4;               // points this far from a measured one stay unknown
  constexpr float filled_weight = 0.01F;  // beside a measured one it counts for next to nothing
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<AmbientCube> before(probes.begin(), probes.begin() + room_count());
    for (int i = 0; i < room_count(); ++i) {
      AmbientCube& probe = probes[static_cast<std::size_t>(i)];
      if (probe.validity > 0) continue;
      probe = mean_around(before, i);
      probe.validity = std::min(probe.validity, 1.0F) * filled_weight;
    }
  }
}

AmbientCube IrradianceField::mean_around(const std::vector<AmbientCube>& room, int index) const {
  const std::array<int, 3> at{
      index % size_[0], index / size_[0] % size_[1], index / (size_[0] * size_[1])};
  const std::array<int, 3> stride{1, size_[0], size_[0] * size_[1]};
  AmbientCube mean;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      if (at[axis] + side < 0 || at[axis] + side >= size_[axis]) continue;
      const AmbientCube& other = room[static_cast<std::size_t>(index + side * stride[axis])];
      if (other.validity <= 0) continue;
      for (std::size_t a = 0; a < axes.size(); ++a)
        mean.faces[a] += other.faces[a];
      mean.validity += 1;
    }
  }
  for (Vec3f& face : mean.faces)
    face = face / std::max(mean.validity, 1.0F);
  return mean;
}

std::int32_t IrradianceField::shelf_at(Vec3f point) const {
  const auto found = std::find_if(shelves_.begin(), shelves_.end(), [&](const Shelf& shelf) {
    const Vec3f p = shelf.world_from_shelf.to_local(point);
    return std::fabs(p.x) < shelf.size.x / 2 && p.y > 0 && p.y < shelf.size.y && p.z > 0 &&
           p.z < shelf.size.z;
  });
  return found == shelves_.end() ? -1 : static_cast<std::int32_t>(found - shelves_.begin());
}

const IrradianceField::Shelf* IrradianceField::shelf_of(const Place& place) const {
  if (place.shelf >= 0) return &shelves_[static_cast<std::size_t>(place.shelf)];
  if (place.fixture < 0) return nullptr;
  const auto [first, count] = shelves_of_fixture_[static_cast<std::size_t>(place.fixture)];
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Shelf& shelf = shelves_[i];
    const Vec3f p = shelf.world_from_shelf.to_local(place.point);
    constexpr float reach = 0.06F, side_reach = 0.01F;  // what faces away from its side is outside
    if (std::fabs(p.x) < shelf.size.x / 2 + side_reach && p.y > -0.01F &&
        p.y < shelf.size.y + reach && p.z > -0.01F && p.z < shelf.size.z + reach) {
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
          (eight.near + 1e-4F) * (before * before + least_behind)};
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
  const Shelf* shelf = shelf_of(place);
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

float IrradianceField::tilt(const Place& place, Vec3f facing, Vec3f tilted) const {
  const Corners corners = corners_at(place, Float4(facing));
  const float flat = luminance(gathered(light_.probes, corners, Float4(facing)).xyz());
  return flat > 0 ? luminance(gathered(light_.probes, corners, Float4(tilted)).xyz()) / flat : 1;
}

float IrradianceField::mean_of_floor() const {
  const auto layer = static_cast<std::size_t>(size_[0] * size_[1]);
  float sum = 0, count = 0;
  for (std::size_t i = 0; i < layer; ++i) {
    sum += luminance(probes_[i].irradiance({0, 0, 1})) * probes_[i].validity;
    count += probes_[i].validity;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace marketgen::raytrace
