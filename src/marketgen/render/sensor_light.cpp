#include "render/sensor_light.h"

#include <algorithm>
#include <cmath>

#include "render/sample_pattern.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float glossy_below = 0.4F;  // roughness
constexpr float light_end_m = 0.01F;  // shadow rays stop this short of the lamp
constexpr float bounce_footprint =
    0.25F;  // metres per metre: a bounce sees the mean colour of a patch
constexpr float mirror_footprint = 0.6F;  // times alpha, metres per metre
// Single samples are capped, in units of what a picture shows as white: rarer, brighter ones would
// stay as spots.
constexpr float brightest_direct = 30, brightest_bounce = 6, brightest_mirror = 5;
// Relief changes the light on a surface within these bounds, once it turns by about 2 degrees.
constexpr float darkest_relief = 0.3F, brightest_relief = 1.8F, least_turn = 6e-4F;
constexpr float ceiling_share = 0.97F;  // a ray that gets this far along has reached the ceiling

Vec3f capped(Vec3f value, float limit) {
  const float top = largest(value);
  return top > limit ? value * (limit / top) : value;
}

// Rays of one kind waiting for a full packet.
template <class Payload>
struct RayQueue {
  std::array<Ray, packet_size> rays;
  std::array<Payload, packet_size> payloads;
  std::size_t used = 0;
  bool full() const { return used == packet_size; }
  void add(const Ray& ray, const Payload& payload) {
    rays[used] = ray;
    payloads[used++] = payload;
  }
};

// A ray's pixel and what its answer is worth.
struct Weighted {
  std::size_t pixel = 0;
  Vec3f weight;
};

// A ray to the mirror side, and what the ceiling would give if nothing is in its way.
struct Mirrored {
  std::size_t pixel = 0;
  float weight = 1;
  PanelReflection::Seen panels;
};

class TileLighter {
 public:
  TileLighter(const Lighting& lighting, const View& view, const Tile& tile, int samples)
      : lighting_(lighting),
        view_(view),
        tile_(tile),
        samples_(samples),
        white_(1 / lighting.world.exposure) {}

  void run(Film& film) {
    for (int s = 0; s < samples_; ++s) {
      add_direct(s);
      add_bounce(s);
    }
    add_gloss();
    add_pane_reflections();
    store(film);
  }

 private:
  bool lit(std::size_t i) const { return tile_.inside(i) && tile_.hits[i].any; }
  SamplePattern pattern(std::size_t i, int count) const {
    return {tile_.x_of(i), tile_.y_of(i), count};
  }

  void add_direct(int s) {
    RayQueue<Weighted> queue;
    const float share = 1.0F / static_cast<float>(samples_);
    for (std::size_t i = 0; i < tile_pixels; ++i) {
      if (!lit(i)) continue;
      const Surface& surface = tile_.hits[i].surface;
      const SamplePattern numbers = pattern(i, samples_);
      const Vec2f pick = numbers.at(SampleUse::light_pick, s),
                  point = numbers.at(SampleUse::light_point, s);
      const LightSample sample =
          lighting_.lights.sample(surface.position, pick.x, point.x, point.y);
      const float cosine = dot(sample.direction, surface.normal);
      if (sample.pdf <= 0 || cosine <= 0 || dot(sample.direction, surface.face_normal) <= 0)
        continue;
      const Vec3f weight =
          capped(sample.irradiance_scale * cosine, brightest_direct * white_ * pi) * share;
      queue.add({surface.position, sample.direction, 0, sample.distance - light_end_m},
                {i, weight});
      if (queue.full()) finish_direct(queue);
    }
    finish_direct(queue);
  }

  void finish_direct(RayQueue<Weighted>& queue) {
    if (queue.used == 0) return;
    std::array<bool, packet_size> blocked{};
    find_blocked(lighting_.world,
                 std::span(queue.rays).first(queue.used),
                 std::span(blocked).first(queue.used),
                 mask_opaque);
    for (std::size_t k = 0; k < queue.used; ++k) {
      if (!blocked[k]) irradiance_[queue.payloads[k].pixel] += queue.payloads[k].weight;
    }
    queue.used = 0;
  }

  void add_bounce(int s) {
    RayQueue<Weighted> queue;
    const float share = pi / static_cast<float>(samples_);
    for (std::size_t i = 0; i < tile_pixels; ++i) {
      if (!lit(i)) continue;
      const Surface& surface = tile_.hits[i].surface;
      const Vec2f numbers = pattern(i, samples_).at(SampleUse::bounce, s);
      const Vec3f direction =
          TangentFrame(surface.normal).to_world(cosine_direction(numbers.x, numbers.y));
      if (dot(direction, surface.face_normal) <= 0) continue;
      queue.add({surface.position, direction}, {i, {share, share, share}});
      if (queue.full()) finish_bounce(queue);
    }
    finish_bounce(queue);
  }

  void finish_bounce(RayQueue<Weighted>& queue) {
    if (queue.used == 0) return;
    std::array<Hit, packet_size> hits;
    trace(lighting_.world,
          std::span(queue.rays).first(queue.used),
          hits,
          mask_opaque,
          RayBundle::scattered);
    for (std::size_t k = 0; k < queue.used; ++k) {
      if (!hits[k].any()) continue;  // daylight comes from the windows' own area lights
      const Surface seen =
          surface_at(lighting_.world, queue.rays[k], hits[k], bounce_footprint * hits[k].t);
      const Vec3f radiance =
          stored_radiance(lighting_, seen, queue.rays[k].direction, Lamps::left_out);
      irradiance_[queue.payloads[k].pixel] +=
          capped(radiance, brightest_bounce * white_) * queue.payloads[k].weight;
    }
    queue.used = 0;
  }

  void add_gloss() {
    RayQueue<Mirrored> queue;
    const int rays = std::max(1, samples_ / 2);  // panels need none: what is left to see is dim
    for (std::size_t i = 0; i < tile_pixels; ++i) {
      if (!lit(i)) continue;
      const Surface& surface = tile_.hits[i].surface;
      const Vec3f mirror = mirrored(tile_.hits[i].ray.direction, surface.relief_normal);
      if (!is_glossy(surface)) {
        gloss_[i] = lighting_.field.at(place_of(surface), mirror) * inverse_pi;
        continue;
      }
      const PanelReflection::Seen panels = lighting_.panels.at(surface, mirror);
      for (int s = 0; s < rays; ++s) {
        const Vec3f direction = mirror_direction(i, s, rays);
        if (dot(direction, surface.face_normal) <= 0) continue;
        queue.add({surface.position, direction}, {i, 1.0F / static_cast<float>(rays), panels});
        if (queue.full()) finish_gloss(queue);
      }
    }
    finish_gloss(queue);
  }

  Vec3f mirror_direction(std::size_t i, int s, int rays) const {
    const Surface& surface = tile_.hits[i].surface;
    const Vec2f numbers = pattern(i, rays).at(SampleUse::reflection, s);
    const TangentFrame frame(surface.relief_normal);
    const Vec3f view = frame.to_local(-tile_.hits[i].ray.direction);
    const float alpha = surface.roughness * surface.roughness;
    const Vec3f half = ggx_half_vector(view, std::max(alpha, 1e-3F), numbers.x, numbers.y);
    return frame.to_world(half * (2 * dot(view, half)) - view);
  }

  void finish_gloss(RayQueue<Mirrored>& queue) {
    if (queue.used == 0) return;
    std::array<Hit, packet_size> hits;
    trace(lighting_.world,
          std::span(queue.rays).first(queue.used),
          hits,
          mask_opaque,
          RayBundle::scattered);
    for (std::size_t k = 0; k < queue.used; ++k) {
      const Mirrored& mirror = queue.payloads[k];
      const float roughness = tile_.hits[mirror.pixel].surface.roughness;
      const bool sees_ceiling = hits[k].t > ceiling_share * mirror.panels.distance;
      Vec3f radiance =
          mirror_radiance(queue.rays[k], hits[k], roughness * roughness, Panels::apart);
      radiance = capped(radiance, brightest_mirror * white_);
      if (sees_ceiling) radiance += mirror.panels.radiance;
      gloss_[mirror.pixel] += radiance * mirror.weight;
    }
    queue.used = 0;
  }

  // Panels seen by a ray shine, or are accounted for apart.
  enum class Panels { shining, apart };
  Vec3f mirror_radiance(const Ray& ray, const Hit& hit, float alpha, Panels panels) const {
    if (!hit.any()) return lighting_.world.surroundings.radiance(ray.direction);
    const float footprint = view_.footprint(hit.t) + mirror_footprint * alpha * hit.t;
    const Surface seen = surface_at(lighting_.world, ray, hit, footprint);
    const bool panel =
        seen.light >= 0 && static_cast<std::uint32_t>(seen.light) < lighting_.world.panel_count;
    const Lamps lamps = panel && panels == Panels::apart ? Lamps::left_out : Lamps::seen;
    return stored_radiance(lighting_, seen, ray.direction, lamps);
  }

  void add_pane_reflections() {
    RayQueue<Weighted> queue;
    for (std::size_t i = 0; i < tile_pixels; ++i) {
      if (!tile_.inside(i) || !tile_.hits[i].glass) continue;
      const GlassLayer& glass = *tile_.hits[i].glass;
      const Vec3f mirror = mirrored(tile_.hits[i].ray.direction, glass.pane.relief_normal);
      queue.add({glass.pane.position, mirror}, {i, Vec3f{1, 1, 1} * glass.reflectance});
      if (queue.full()) finish_panes(queue);
    }
    finish_panes(queue);
  }

  void finish_panes(RayQueue<Weighted>& queue) {
    if (queue.used == 0) return;
    std::array<Hit, packet_size> hits;
    trace(lighting_.world,
          std::span(queue.rays).first(queue.used),
          hits,
          mask_opaque,
          RayBundle::coherent);
    for (std::size_t k = 0; k < queue.used; ++k) {
      overlay_[queue.payloads[k].pixel] =
          mirror_radiance(queue.rays[k], hits[k], 0, Panels::shining) * queue.payloads[k].weight;
    }
    queue.used = 0;
  }

  void store(Film& film) const {
    for (std::size_t k = 0; k < tile_pixels; ++k) {
      if (!tile_.inside(k)) continue;
      const std::size_t i = film.index(tile_.x_of(k), tile_.y_of(k));
      film.irradiance.set(i, irradiance_[k]);
      // Light is gathered and smoothed as on a flat face; what the relief makes of it goes to the
      // albedo, which stays sharp.
      if (tile_.hits[k].any)
        film.albedo.set(i, film.albedo.at(i) * relief_shade(lighting_, tile_.hits[k].surface));
      film.gloss.set(i, gloss_[k]);
      film.overlay.set(i, overlay_[k]);
    }
  }

  const Lighting& lighting_;
  const View& view_;
  const Tile& tile_;
  int samples_;
  float white_;  // radiance shown as white
  std::array<Vec3f, tile_pixels> irradiance_{}, gloss_{}, overlay_{};
};

}  // namespace

bool is_glossy(const Surface& surface) {
  return surface.roughness < glossy_below;
}

float relief_shade(const Lighting& lighting, const Surface& surface) {
  if (dot(surface.relief_normal, surface.normal) > 1 - least_turn) return 1;
  const float shade = lighting.field.tilt(place_of(surface), surface.normal, surface.relief_normal);
  return std::clamp(shade, darkest_relief, brightest_relief);
}

Vec3f stored_radiance(const Lighting& lighting,
                      const Surface& surface,
                      Vec3f direction,
                      Lamps lamps) {
  const Place place = place_of(surface);
  Vec3f radiance = surface.diffuse() * lighting.field.at(place, surface.normal) * inverse_pi;
  if (surface.metallic > 0) {
    radiance += surface.albedo * surface.metallic *
                lighting.field.at(place, mirrored(direction, surface.normal)) * inverse_pi;
  }
  if (lamps == Lamps::seen || surface.light < 0) radiance += surface.emission;
  return radiance;
}

void light_tile(
    const Lighting& lighting, const View& view, const Tile& tile, int samples, Film& film) {
  TileLighter(lighting, view, tile, samples).run(film);
}

}  // namespace marketgen::raytrace
