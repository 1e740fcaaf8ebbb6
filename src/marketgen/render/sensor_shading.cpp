#include "render/sensor_shading.h"

#include <algorithm>
#include <cmath>

#include "render/sensor_window.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float polished_below = 0.45F;   // roughness of floors that get mirror rays
constexpr float mirroring_below = 0.35F;  // and that mirror more than panels
constexpr float level_floor = 0.98F;      // z of their normals
constexpr float like_facing = 0.985F, like_plane_m = 0.02F;
constexpr float rough_from = 0.55F;          // gloss so wide is as bright as the face is lit
constexpr float least_panel_share = 0.012F;  // of white: dimmer highlights need no shadow ray
constexpr float shadow_end_m = 0.02F;
constexpr float ceiling_room_m = 0.03F;  // panels hang in it
constexpr float nearest_contact_m = 0.005F, contact_reach_m = 0.035F;
constexpr float contact_until_m = 3.5F;  // farther, contact shadows are smaller than pixels
constexpr float darkest_contact = 0.45F;
// How far actors' shadows reach, and how dark they are: what they hide they replace in part by what
// they send back themselves.
constexpr float actor_reach_m = 0.8F, actor_darkness = 0.8F;
constexpr float window_plane_m = 0.006F, window_plane_per_m = 0.004F, window_facing = 0.85F;
constexpr float mirror_blur = 1.5F;         // footprint of a mirror ray, times alpha and distance
constexpr float widest_mirror = 1.02F;      // keeps GGX's long tail finite
constexpr float brightest_mirrored = 1.5F;  // times white

bool is_polished_floor(const Surface& surface) {
  return surface.roughness < polished_below && surface.normal.z > level_floor &&
         surface.fixture < 0 && surface.shelf < 0;
}

// Rays of a tile's pixels waiting for a full packet.
struct WaitingRays {
  std::array<Ray, packet_size> rays;
  std::array<std::uint16_t, packet_size> pixels{};
  std::size_t used = 0;
  bool add(std::size_t pixel, const Ray& ray) {
    rays[used] = ray;
    pixels[used++] = static_cast<std::uint16_t>(pixel);
    return used == packet_size;
  }
};

// The same as rough_fresnel(), in registers.
Float4 reflectance_of(const Surface& surface, Float4 direction) {
  const Float4 at_normal =
      Float4(dielectric_reflectance) +
      (Float4(surface.albedo) - Float4(dielectric_reflectance)) * surface.metallic;
  const float cosine = -dot(Float4(surface.relief_normal), direction);
  const Float4 lift = max(Float4(1 - surface.roughness), at_normal) - at_normal;
  return at_normal + lift * fifth_power(1 - std::clamp(cosine, 0.0F, 1.0F));
}

class TileShader {
 public:
  TileShader(const Lighting& lighting,
             const View& view,
             const SensorEffort& effort,
             SensorTile& tile)
      : lighting_(lighting),
        view_(view),
        effort_(effort),
        tile_(tile),
        white_(1 / lighting.world.exposure) {}

  void run() {
    take_stored_light();
    add_panels();
    if (effort_.mirror_floor) mirror_floor();
    shade_contacts();
    shade_under_actors();
    for (std::size_t p = 0; p < tile_.pane_count; ++p)
      mirror_pane(tile_.panes[p]);
    finish_panes();
  }

 private:
  // A quarter of the pixels stand for their neighbours, where those lie on the same face.
  void take_stored_light() {
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      like_[i] = static_cast<std::uint16_t>(i);
      mirror_[i] = false;
      if (!tile_.lit(i)) continue;
      const Surface& surface = tile_.surface[i];
      const std::size_t corner = i & ~std::size_t{5};  // of its 2 x 2 pixels
      if (corner != i && tile_.lit(corner) && alike(tile_.surface[corner], surface)) {
        like_[i] = static_cast<std::uint16_t>(corner);
        tile_.irradiance[i] = tile_.irradiance[corner];
        tile_.gloss[i] = tile_.gloss[corner];
      } else {
        look_up(i);
      }
    }
  }

  static bool alike(const Surface& a, const Surface& b) {
    return a.id == b.id && a.material == b.material &&
           dot(a.relief_normal, b.relief_normal) > like_facing &&
           std::fabs(dot(a.position - b.position, b.face_normal)) < like_plane_m;
  }

  void look_up(std::size_t i) {
    const Surface& surface = tile_.surface[i];
    const Float4 normal(surface.relief_normal);
    if (surface.roughness >= rough_from) {
      tile_.irradiance[i] = lighting_.field.at(place_of(surface), surface.relief_normal);
      tile_.gloss[i] = tile_.irradiance[i] * inverse_pi;
      return;
    }
    const IrradianceField::TwoSided light =
        lighting_.field.at(place_of(surface), normal, mirrored(Float4(tile_.direction[i]), normal));
    tile_.irradiance[i] = light.facing.xyz();
    tile_.gloss[i] = (light.mirror * inverse_pi).xyz();
  }

  // Panels in gloss. Where they would show, a ray tells whether they can be seen.
  void add_panels() {
    WaitingRays waiting;
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (!tile_.lit(i)) continue;
      const Surface& surface = tile_.surface[i];
      if (like_[i] != i) {
        panels_[i] = panels_[like_[i]];
        continue;
      }
      panels_[i] = {};
      if (surface.roughness >= rough_from) continue;
      const Vec3f mirror = mirrored(tile_.direction[i], surface.relief_normal);
      const PanelReflection::Seen seen = lighting_.panels.at(surface, mirror);
      panels_[i] = seen.radiance;
      const Vec3f reflected =
          seen.radiance * reflectance_of(surface, Float4(tile_.direction[i])).xyz();
      const bool shows = largest(reflected) > least_panel_share * white_;
      if (!effort_.panel_shadows || !shows || is_polished_floor(surface)) continue;
      if (waiting.add(i, {surface.position, mirror, 0, seen.distance - shadow_end_m}))
        hide_panels(waiting);
    }
    hide_panels(waiting);
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (tile_.lit(i)) panels_[i] = panels_[like_[i]];
    }
    if (effort_.panel_shadows) hide_panels_from_floor();
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (tile_.lit(i)) tile_.gloss[i] += panels_[i];
    }
  }

  // A floor's lobe is wide and its face even: one ray a pixel would cut highlights off sharply.
  // Every other pixel sends one into its lobe, and a window of 4 x 4 pixels knows how much of the
  // ceiling can be seen.
  void hide_panels_from_floor() {
    blocked_ = {};
    WaitingRays waiting;
    bool any = false;
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      mirror_[i] = tile_.lit(i) && is_polished_floor(tile_.surface[i]);
      sampled_[i] = mirror_[i] && is_even(i) && largest(panels_[i]) > 0;
      if (!sampled_[i]) continue;
      any = true;
      const Vec3f direction = floor_direction(i);
      const float up = lighting_.world.room.high.z - ceiling_room_m - tile_.surface[i].position.z;
      if (waiting.add(i, {tile_.surface[i].position, direction, 0, up / direction.z}))
        finish_contacts(waiting);
    }
    finish_contacts(waiting);
    for (std::size_t i = 0; any && i < sensor_tile_pixels; ++i) {
      if (mirror_[i]) panels_[i] *= open_share(i);
    }
  }

  std::array<bool, packet_size> blocked_of(const WaitingRays& waiting) const {
    std::array<bool, packet_size> blocked{};
    find_blocked(lighting_.world,
                 std::span(waiting.rays).first(waiting.used),
                 std::span(blocked).first(waiting.used),
                 mask_solid);
    return blocked;
  }

  void hide_panels(WaitingRays& waiting) {
    if (waiting.used == 0) return;
    const std::array<bool, packet_size> blocked = blocked_of(waiting);
    for (std::size_t k = 0; k < waiting.used; ++k) {
      if (blocked[k]) panels_[waiting.pixels[k]] = {};
    }
    waiting.used = 0;
  }

  // Every other pixel of a polished floor sends one ray into its lobe; a window of 4 x 4 pixels
  // makes one blurred mirror picture of them.
  void mirror_floor() {
    WaitingRays waiting;
    bool any = false;
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      // Few rays in a wide lobe would leave a lamp as sparks: such floors keep their stored light.
      mirror_[i] = tile_.lit(i) && is_polished_floor(tile_.surface[i]) &&
                   tile_.surface[i].roughness < mirroring_below;
      if (!mirror_[i]) continue;
      any = true;
      sampled_[i] = is_even(i);
      if (!sampled_[i]) continue;
      const Surface& surface = tile_.surface[i];
      if (waiting.add(i, {surface.position, floor_direction(i)})) finish_floor(waiting);
    }
    finish_floor(waiting);
    if (any) blur_floor();
  }

  static bool is_even(std::size_t i) {
    return (SensorTile::column_of(i) + SensorTile::row_of(i)) % 2 == 0;
  }

  Vec3f floor_direction(std::size_t i) const {
    const Surface& surface = tile_.surface[i];
    const std::size_t lane = i % packet_size;
    const float alpha = surface.roughness * surface.roughness;
    const float u = first_numbers[lane], angle = two_pi * second_numbers[lane];
    const float slope = alpha * std::sqrt(u / (widest_mirror - u));
    const TangentFrame frame(surface.relief_normal);
    const Vec3f half =
        normalized(frame.to_world({slope * std::cos(angle), slope * std::sin(angle), 1}));
    Vec3f direction = mirrored(tile_.direction[i], half);
    constexpr float least_rise = 0.004F;
    direction.z = std::max(direction.z, least_rise);
    return normalized(direction);
  }

  void finish_floor(WaitingRays& waiting) {
    if (waiting.used == 0) return;
    std::array<Hit, packet_size> hits;
    trace(lighting_.world,
          std::span(waiting.rays).first(waiting.used),
          std::span(hits).first(waiting.used),
          mask_opaque,
          RayBundle::scattered);
    fetch_surfaces(lighting_.world, std::span(hits).first(waiting.used));
    for (std::size_t k = 0; k < waiting.used; ++k) {
      const std::size_t i = waiting.pixels[k];
      const float alpha = tile_.surface[i].roughness * tile_.surface[i].roughness;
      floor_[i] = mirrored_light(waiting.rays[k], hits[k], alpha, tile_.surface[i].distance);
    }
    waiting.used = 0;
  }

  // What a mirror ray sees; panels are accounted for apart. `alpha` blurs its textures.
  Vec3f mirrored_light(const Ray& ray, const Hit& hit, float alpha, float before) const {
    const World& world = lighting_.world;
    if (!hit.any()) return world.surroundings.radiance(ray.direction);
    const float footprint = view_.footprint(before + hit.t) + mirror_blur * alpha * hit.t;
    const Surface seen = surface_at(world, ray, hit, footprint, TextureDetail::level);
    const bool panel =
        seen.light >= 0 && static_cast<std::uint32_t>(seen.light) < world.panel_count;
    const Vec3f radiance =
        stored_radiance(lighting_, seen, ray.direction, panel ? Lamps::left_out : Lamps::seen);
    const float top = largest(radiance), limit = brightest_mirrored * white_;
    return top > limit ? radiance * (limit / top) : radiance;
  }

  void blur_floor() {
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (!mirror_[i]) continue;
      Vec3f sum;
      float count = 0;
      for_window(i, [&](std::size_t q) {
        if (!mirror_[q] || !sampled_[q]) return;
        sum += floor_[q];
        count += 1;
      });
      if (count > 0) tile_.gloss[i] = sum / count + panels_[i];
    }
  }

  // Short rays find what stands close: the stored light is too coarse to know.
  void shade_contacts() {
    tile_.openness.fill(1);
    if (!effort_.contact_shadows) return;
    blocked_ = {};
    WaitingRays waiting;
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      sampled_[i] = tile_.lit(i) && tile_.surface[i].distance < contact_until_m &&
                    (effort_.all_contact_pixels || is_even(i));
      if (sampled_[i] && waiting.add(i, contact_ray(i))) finish_contacts(waiting);
    }
    finish_contacts(waiting);
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (tile_.lit(i) && blocked_.near(i))
        tile_.openness[i] = darkest_contact + (1 - darkest_contact) * open_share(i);
    }
  }

  Ray contact_ray(std::size_t i) const {
    const Surface& surface = tile_.surface[i];
    const float u = first_numbers[i % packet_size], v = second_numbers[i % packet_size];
    static const std::array<Vec3f, packet_size> directions = [] {
      std::array<Vec3f, packet_size> made;
      for (std::size_t k = 0; k < packet_size; ++k)
        made[k] = cosine_direction(first_numbers[k], second_numbers[k]);
      return made;
    }();
    const float far = nearest_contact_m + contact_reach_m * std::fmod(u * 5.37F + v, 1.0F);
    return {surface.position,
            TangentFrame(surface.normal).to_world(directions[i % packet_size]),
            0,
            far};
  }

  void finish_contacts(WaitingRays& waiting) {
    if (waiting.used > 0) note_blocked(waiting, blocked_of(waiting));
  }

  // Actors are not in the stored light: what they keep away from the surfaces around them is found
  // by longer rays that meet nothing else.
  void shade_under_actors() {
    const World& world = lighting_.world;
    if (!world.actors.bvh) return;
    RTCBounds box;
    rtcGetSceneBounds(world.actors.bvh.get(), &box);
    const auto is_near = [&](Vec3f p) {
      return p.x > box.lower_x - actor_reach_m && p.x < box.upper_x + actor_reach_m &&
             p.y > box.lower_y - actor_reach_m && p.y < box.upper_y + actor_reach_m &&
             p.z > box.lower_z - actor_reach_m && p.z < box.upper_z + actor_reach_m;
    };
    blocked_ = {};
    WaitingRays waiting;
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      sampled_[i] = tile_.lit(i) && is_near(tile_.surface[i].position);
      if (!sampled_[i]) continue;
      Ray ray = contact_ray(i);
      ray.far = actor_reach_m;
      if (waiting.add(i, ray)) finish_under_actors(waiting);
    }
    finish_under_actors(waiting);
    for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
      if (sampled_[i] && blocked_.near(i))
        tile_.openness[i] *= 1 - actor_darkness * (1 - open_share(i));
    }
  }

  void finish_under_actors(WaitingRays& waiting) {
    if (waiting.used == 0) return;
    std::array<bool, packet_size> blocked{};
    find_blocked_by_actors(lighting_.world,
                           std::span(waiting.rays).first(waiting.used),
                           std::span(blocked).first(waiting.used));
    note_blocked(waiting, blocked);
  }

  void note_blocked(WaitingRays& waiting, const std::array<bool, packet_size>& blocked) {
    for (std::size_t k = 0; k < waiting.used; ++k) {
      if (blocked[k]) blocked_.add(waiting.pixels[k]);
    }
    waiting.used = 0;
  }

  // Share of the rays around a pixel, on its face, that met nothing; 1 where there were none.
  float open_share(std::size_t i) const {
    const Surface& surface = tile_.surface[i];
    const float plane = window_plane_m + window_plane_per_m * tile_.depth[i];
    float open = 0, count = 0;
    for_window(i, [&](std::size_t q) {
      if (!sampled_[q] || dot(tile_.surface[q].normal, surface.normal) < window_facing ||
          std::fabs(dot(surface.normal, tile_.surface[q].position - surface.position)) > plane)
        return;
      count += 1;
      open += blocked_.has(q) ? 0.0F : 1.0F;
    });
    return count > 0 ? open / count : 1;
  }

  void mirror_pane(TilePane& pane) {
    const Vec3f direction = tile_.direction[pane.pixel];
    const Vec3f mirror = mirrored(direction, pane.first.normal);
    if (!effort_.mirror_panes) {
      const Float4 light =
          lighting_.field.at(place_of(pane.first), Float4(pane.first.normal), Float4(mirror))
              .mirror;
      const Vec3f panels = lighting_.panels.at(pane.first, mirror).radiance;
      tile_.overlay[pane.pixel] = ((light * inverse_pi).xyz() + panels) * pane.reflected;
      return;
    }
    pane_slots_[pane_rays_.used] = static_cast<std::uint16_t>(&pane - tile_.panes.data());
    if (pane_rays_.add(pane.pixel, {pane.first.position, mirror})) finish_panes();
  }

  void finish_panes() {
    if (pane_rays_.used == 0) return;
    std::array<Hit, packet_size> hits;
    const auto rays = std::span(pane_rays_.rays).first(pane_rays_.used);
    trace(lighting_.world,
          rays,
          std::span(hits).first(pane_rays_.used),
          mask_opaque,
          RayBundle::scattered);
    for (std::size_t k = 0; k < pane_rays_.used; ++k) {
      const TilePane& pane = tile_.panes[pane_slots_[k]];
      Vec3f light;
      if (hits[k].any()) {
        const Surface seen = surface_at(lighting_.world,
                                        rays[k],
                                        hits[k],
                                        view_.footprint(pane.first.distance + hits[k].t),
                                        TextureDetail::level);
        light = stored_radiance(lighting_, seen, rays[k].direction, Lamps::seen);
      } else {
        light = lighting_.world.surroundings.radiance(rays[k].direction);
      }
      tile_.overlay[pane.pixel] = light * pane.reflected;
    }
    pane_rays_.used = 0;
  }

  const Lighting& lighting_;
  const View& view_;
  const SensorEffort& effort_;
  SensorTile& tile_;
  float white_;                                           // radiance shown as white
  std::array<std::uint16_t, sensor_tile_pixels> like_{};  // whose light a pixel takes over
  std::array<Vec3f, sensor_tile_pixels> panels_, floor_;
  std::array<bool, sensor_tile_pixels> mirror_{}, sampled_{};
  TilePixels blocked_;  // whose ray met something
  WaitingRays pane_rays_;
  std::array<std::uint16_t, packet_size> pane_slots_{};
};

}  // namespace

void shade_tile(const Lighting& lighting,
                const View& view,
                const SensorEffort& effort,
                SensorTile& tile) {
  TileShader(lighting, view, effort, tile).run();
}

Float4 lit_radiance(const Surface& surface, Float4 direction, Float4 irradiance, Float4 gloss) {
  return Float4(surface.albedo) * irradiance * ((1 - surface.metallic) * inverse_pi) +
         reflectance_of(surface, direction) * gloss + Float4(surface.emission);
}

Float4 radiance_of(const World& world, const SensorTile& tile, std::size_t i) {
  const Float4 behind = tile.depth[i] > 0
                            ? lit_radiance(tile.surface[i],
                                           Float4(tile.direction[i]),
                                           Float4(tile.irradiance[i]) * tile.openness[i],
                                           Float4(tile.gloss[i]))
                            : Float4(world.surroundings.radiance(tile.direction[i]));
  if (tile.pane_of[i] < 0) return behind;
  const TilePane& pane = tile.panes[static_cast<std::size_t>(tile.pane_of[i])];
  return behind * Float4(pane.transmittance) + Float4(tile.overlay[i]);
}

}  // namespace marketgen::raytrace
