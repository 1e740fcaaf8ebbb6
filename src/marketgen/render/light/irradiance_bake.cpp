// How IrradianceField fills its probes: rays from each, lamps, bounces, and neighbours' light for
// those in matter.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/light/irradiance.h"
#include "render/shading_math.h"
#include "render/stage/room.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int rays_per_probe = 48;  // a multiple of packet_size
constexpr float near_light = 1.5F;  // lights nearer than this times their size get four samples
constexpr int bounces = 4;
constexpr float max_back_faces =
    0.25F;  // share of rays that hit the inside of something: the probe is in matter
constexpr float probe_footprint_m = 0.2F;
// A room probe with so many things so near stands in a hollow of a fixture: it knows nothing of the
// faces outside.
constexpr float hollow_m = 0.22F, max_near = 0.55F;

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
    const Vec3f middle = light.middle();
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
  result.valid = static_cast<float>(back_faces) <= max_back_faces * rays_per_probe &&
                 (hollows == Hollows::lit || static_cast<float>(near) <= max_near * rays_per_probe);
}

// Of the first `count` probes: `sign` times what comes straight from lamps is added.
void add_direct(std::vector<AmbientCube>& probes,
                const std::vector<ProbeRays>& rays,
                std::size_t count,
                float sign) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t a = 0; a < axes.size(); ++a)
      probes[i].faces[a] += rays[i].direct.faces[a] * (sign * probes[i].validity);
  }
}

// What things send back is known from few rays, in the same directions at every point: it stains
// ceilings. But it varies slowly, and the points around know it as well; what comes straight from
// lamps stays as it is. Of the room's `count` probes.
template <class MeanAround>
void smooth_sent_back(std::vector<AmbientCube>& probes,
                      const std::vector<ProbeRays>& rays,
                      std::size_t count,
                      const MeanAround& mean_around) {
  constexpr int passes = 2;
  add_direct(probes, rays, count, -1);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<AmbientCube> before(probes.begin(),
                                          probes.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      const AmbientCube mean = mean_around(before, i);
      if (probes[i].validity <= 0 || mean.validity <= 0) continue;
      for (std::size_t a = 0; a < axes.size(); ++a)
        probes[i].faces[a] = (probes[i].faces[a] + mean.faces[a]) * 0.5F;
    }
  }
  add_direct(probes, rays, count, 1);
}

bool is_outside(const PolygonMm& outline, Vec3f point) {
  return !contains(outline, floor_mm(point));
}

}  // namespace

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
  smooth_sent_back(probes_, rays, room_count, [&](const auto& room, std::size_t i) {
    return mean_around(room, static_cast<int>(i));
  });
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

float IrradianceField::mean_of_floor() const {
  const auto layer = static_cast<std::size_t>(size_[0] * size_[1]);
  float sum = 0, count = 0;
  for (std::size_t i = 0; i < layer; ++i) {
    sum += luminance(probes_[i].irradiance({0, 0, 1})) * probes_[i].validity;
    count += probes_[i].validity;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace marketgen::render::raytrace
