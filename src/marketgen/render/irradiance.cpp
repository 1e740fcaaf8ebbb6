#include "render/irradiance.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float lookup_lift_m = 0.03F;  // probes are asked a little above the surface
constexpr float room_spacing_m = 1.0F, room_spacing_up_m = 0.6F;
constexpr float room_margin_m = 0.05F;
constexpr float most_room_probes = 12'000;
constexpr int depth_rows = 3, height_rows = 2;
constexpr float along_spacing_m = 0.7F;
// Depths of the probe rows behind a shelf's front edge: one row before the edge, where goods catch
// the most light.
constexpr std::array<float, depth_rows> depth_share{-0.1F, 0.3F, 0.85F};
constexpr std::array<float, height_rows> height_share{0.15F, 0.85F};
constexpr int rays_per_probe = 48;  // a multiple of packet_size
constexpr int lights_per_probe = 16;
constexpr int bounces = 2;
constexpr float most_back_faces =
    0.25F;  // share of rays that hit the inside of something: the probe is in matter
constexpr float probe_footprint_m = 0.2F;

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
  bool valid = true;
};

void add_from(AmbientCube& cube, Vec3f direction, Vec3f radiance_times_angle) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const float facing = dot(axes[a], direction);
    if (facing > 0) cube.faces[a] += radiance_times_angle * facing;
  }
}

// Light straight from the lamps, one stratified sample at a time.
void add_lamps(const World& world, const LightGrid& lights, Vec3f position, AmbientCube& cube) {
  std::array<Ray, packet_size> rays;
  std::array<LightSample, packet_size> samples;
  std::array<bool, packet_size> blocked{};
  std::size_t used = 0;
  for (int i = 0; i < lights_per_probe; ++i) {
    const float pick = (static_cast<float>(i) + 0.5F) / lights_per_probe;
    const float u = std::fmod(0.5F + static_cast<float>(i) * 0.7548777F, 1.0F);  // R2 sequence
    const float v = std::fmod(0.5F + static_cast<float>(i) * 0.5698403F, 1.0F);
    const LightSample sample = lights.sample(position, pick, u, v);
    if (sample.pdf <= 0) continue;
    rays[used] = {position, sample.direction, 0, sample.distance - 0.01F};
    samples[used++] = sample;
  }
  if (used == 0) return;
  find_blocked(world, std::span(rays).first(used), std::span(blocked).first(used), mask_opaque);
  for (std::size_t k = 0; k < used; ++k) {
    if (!blocked[k])
      add_from(cube, samples[k].direction, samples[k].irradiance_scale * (1.0F / lights_per_probe));
  }
}

// Metals send on most of what they get, though not diffusely.
Vec3f bounce_color(const Surface& surface) {
  return surface.albedo * (1 - 0.3F * surface.metallic);
}

void shoot(const World& world, Vec3f position, ProbeRays& result) {
  constexpr float solid_angle = 4 * pi / rays_per_probe;
  int back_faces = 0;
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
      if (surface.back_face)
        ++back_faces;
      else
        meeting = {place_of(surface), surface.normal, bounce_color(surface)};
      if (surface.light < 0)
        add_from(result.direct, rays[k].direction, surface.emission * solid_angle);
    }
  }
  result.valid = static_cast<float>(back_faces) <= most_back_faces * rays_per_probe;
}

}  // namespace

Place place_of(const Surface& surface) {
  return {surface.position + surface.face_normal * lookup_lift_m, surface.fixture, surface.shelf};
}

Vec3f AmbientCube::irradiance(Vec3f n) const {
  return faces[n.x < 0 ? 1 : 0] * (n.x * n.x) + faces[n.y < 0 ? 3 : 2] * (n.y * n.y) +
         faces[n.z < 0 ? 5 : 4] * (n.z * n.z);
}

IrradianceField::IrradianceField(const World& world, const LightGrid& lights, const Scene& scene) {
  place_room(world);
  place_shelves(scene);
  bake(world, lights);
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

void IrradianceField::bake(const World& world, const LightGrid& lights) {
  probes_.resize(positions_.size());
  std::vector<ProbeRays> rays(positions_.size());
  parallel_for(
      positions_.size(),
      [&](std::size_t i) {
        shoot(world, positions_[i], rays[i]);
        if (!rays[i].valid) return;
        add_lamps(world, lights, positions_[i], rays[i].direct);
        rays[i].direct.validity = 1;
        probes_[i] = rays[i].direct;
      },
      32);
  fill_invalid();
  constexpr float solid_angle = 4 * pi / rays_per_probe;
  for (int bounce = 0; bounce < bounces; ++bounce) {
    std::vector<AmbientCube> next(probes_.size());
    parallel_for(
        probes_.size(),
        [&](std::size_t i) {
          if (!rays[i].valid) return;
          next[i] = rays[i].direct;
          for (int k = 0; k < rays_per_probe; ++k) {
            const Meeting& meeting = rays[i].meetings[static_cast<std::size_t>(k)];
            if (largest(meeting.color) <= 0) continue;
            const Vec3f radiance = meeting.color * at(meeting.place, meeting.normal) * inverse_pi;
            add_from(next[i], sphere_direction(k, rays_per_probe), radiance * solid_angle);
          }
        },
        32);
    probes_ = std::move(next);
    fill_invalid();
  }
}

void IrradianceField::fill_invalid() {
  const auto room_count = static_cast<std::size_t>(size_[0] * size_[1] * size_[2]);
  Vec3f sum;
  float count = 0;
  for (std::size_t i = 0; i < room_count; ++i) {
    for (const Vec3f& face : probes_[i].faces)
      sum += face * (probes_[i].validity / 6);
    count += probes_[i].validity;
  }
  if (count > 0) mean_ = sum / count;
  // Within a shelf, a point in a pack takes the mean of the shelf's free points at the same depth,
  // else of all of them.
  for (const Shelf& shelf : shelves_) {
    constexpr std::size_t per_column = depth_rows * height_rows;
    const std::size_t total = static_cast<std::size_t>(shelf.columns) * per_column;
    for (const bool same_depth : {true, false}) {
      std::vector<AmbientCube> filled(
          probes_.begin() + shelf.first,
          probes_.begin() + shelf.first + static_cast<std::ptrdiff_t>(total));
      for (std::size_t i = 0; i < total; ++i) {
        if (filled[i].validity > 0) continue;
        AmbientCube mean;
        for (std::size_t j = 0; j < total; ++j) {
          const AmbientCube& other = probes_[shelf.first + j];
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
      std::copy(filled.begin(), filled.end(), probes_.begin() + shelf.first);
    }
  }
}

const IrradianceField::Shelf* IrradianceField::shelf_of(const Place& place) const {
  if (place.shelf >= 0) return &shelves_[static_cast<std::size_t>(place.shelf)];
  if (place.fixture < 0) return nullptr;
  const auto [first, count] = shelves_of_fixture_[static_cast<std::size_t>(place.fixture)];
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Shelf& shelf = shelves_[i];
    const Vec3f p = shelf.world_from_shelf.to_local(place.point);
    constexpr float reach = 0.06F;
    if (std::fabs(p.x) < shelf.size.x / 2 + reach && p.y > -0.01F && p.y < shelf.size.y + reach &&
        p.z > -0.01F && p.z < shelf.size.z + reach) {
      return &shelf;
    }
  }
  return nullptr;
}

IrradianceField::Corners IrradianceField::corners_in_shelf(const Shelf& shelf, Vec3f point) const {
  const Vec3f p = shelf.world_from_shelf.to_local(point);
  const float last = static_cast<float>(shelf.columns - 1);
  const float along = std::clamp(
      (p.x / shelf.size.x + 0.5F) * static_cast<float>(shelf.columns) - 0.5F, 0.0F, last);
  const int column = std::min(static_cast<int>(along), shelf.columns - 2);
  const float share = std::clamp(p.y / shelf.size.y, depth_share[0], depth_share[2]);
  const int row = share < depth_share[1] ? 0 : 1;
  const auto at_row = [](int r) { return depth_share[static_cast<std::size_t>(r)]; };
  const float inward = (share - at_row(row)) / (at_row(row + 1) - at_row(row));
  const float up = std::clamp(
      (p.z / shelf.size.z - height_share[0]) / (height_share[1] - height_share[0]), 0.0F, 1.0F);
  const float ahead = along - static_cast<float>(column);
  Corners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const bool c = (k & 1U) != 0, d = (k & 2U) != 0, h = (k & 4U) != 0;
    corners.weight[k] = (c ? ahead : 1 - ahead) * (d ? inward : 1 - inward) * (h ? up : 1 - up);
    corners.probe[k] =
        shelf.first +
        static_cast<std::uint32_t>(
            ((column + (c ? 1 : 0)) * depth_rows + row + (d ? 1 : 0)) * height_rows + (h ? 1 : 0));
  }
  return corners;
}

IrradianceField::Corners IrradianceField::corners_in_room(Vec3f point) const {
  const Vec3f at = point - low_;
  const auto split = [](float x, int count) {
    const float clamped = std::clamp(x, 0.0F, static_cast<float>(count - 1));
    const int cell = std::min(static_cast<int>(clamped), count - 2);
    return std::pair(cell, clamped - static_cast<float>(cell));
  };
  const auto [x, fx] = split(at.x / step_.x, size_[0]);
  const auto [y, fy] = split(at.y / step_.y, size_[1]);
  const auto [z, fz] = split(at.z / step_.z, size_[2]);
  Corners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const int dx = static_cast<int>(k & 1U), dy = static_cast<int>(k >> 1 & 1U),
              dz = static_cast<int>(k >> 2 & 1U);
    corners.weight[k] =
        (dx != 0 ? fx : 1 - fx) * (dy != 0 ? fy : 1 - fy) * (dz != 0 ? fz : 1 - fz) + 1e-4F;
    corners.probe[k] =
        static_cast<std::uint32_t>(((z + dz) * size_[1] + y + dy) * size_[0] + x + dx);
  }
  return corners;
}

Vec3f IrradianceField::gathered(const Corners& corners, Vec3f facing) const {
  Vec3f sum;
  float weight = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const AmbientCube& probe = probes_[corners.probe[k]];
    const float w = corners.weight[k] * probe.validity;
    if (w <= 0) continue;
    sum += probe.irradiance(facing) * w;
    weight += w;
  }
  return weight > 1e-5F ? sum / weight : mean_;
}

IrradianceField::Corners IrradianceField::corners_at(const Place& place) const {
  const Shelf* shelf = shelf_of(place);
  return shelf != nullptr ? corners_in_shelf(*shelf, place.point) : corners_in_room(place.point);
}

Vec3f IrradianceField::at(const Place& place, Vec3f facing) const {
  return gathered(corners_at(place), facing);
}

float IrradianceField::tilt(const Place& place, Vec3f facing, Vec3f tilted) const {
  const Corners corners = corners_at(place);
  const float flat = luminance(gathered(corners, facing));
  return flat > 0 ? luminance(gathered(corners, tilted)) / flat : 1;
}

float IrradianceField::floor_mean() const {
  const auto layer = static_cast<std::size_t>(size_[0] * size_[1]);
  float sum = 0, count = 0;
  for (std::size_t i = 0; i < layer; ++i) {
    sum += luminance(probes_[i].irradiance({0, 0, 1})) * probes_[i].validity;
    count += probes_[i].validity;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace marketgen::raytrace
