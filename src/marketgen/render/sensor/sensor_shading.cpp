#include "render/sensor/sensor_shading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/ray_queue.h"
#include "render/sensor/sensor_panes.h"
#include "render/sensor/sensor_window.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float polished_below = 0.45F;   // roughness of floors that get mirror rays
constexpr float mirroring_below = 0.35F;  // and that mirror more than panels
constexpr float level_floor = 0.98F;      // z of their normals
constexpr float like_facing = 0.985F, like_plane_m = 0.02F;
constexpr float wide_gloss_from = 0.55F;  // gloss so wide is as bright as the face is lit
constexpr float ceiling_room_m = 0.03F;   // panels hang in it
constexpr float nearest_contact_m = 0.005F, contact_reach_m = 0.035F;
constexpr float contact_until_m = 3.5F;  // farther, contact shadows are smaller than pixels
constexpr float darkest_contact = 0.45F;
// How far actors' shadows reach, and how dark they are: what they hide they replace in part by what
// they send back themselves.
constexpr float actor_reach_m = 0.8F, actor_darkness = 0.8F;
constexpr float mirror_blur = 1.5F;         // footprint of a mirror ray, times alpha and distance
constexpr float widest_mirror = 1.02F;      // keeps GGX's long tail finite
constexpr float brightest_mirrored = 1.5F;  // times white

Mask8 polished_floor(const Surface8& s) {
  return (s.roughness < Float8(polished_below)) & (s.normal.z > Float8(level_floor)) &
         (Int8(0) > s.fixture) & (Int8(0) > s.shelf);
}

// What gloss needs to know of eight points.
struct Gloss8 {
  Vec8 albedo, normal;
  Float8 roughness, metallic;
};

// The same as rough_fresnel(), side by side.
Vec8 reflectance_of(const Gloss8& s, const Vec8& direction) {
  const Float8 cosine = clamp(-dot(s.normal, direction), Float8(0), Float8(1));
  const Float8 away = 1 - cosine, away2 = away * away, away5 = away2 * away2 * away;
  const auto channel = [&](Float8 albedo) {
    const Float8 dielectric = dielectric_reflectance;
    const Float8 at_normal = dielectric + (albedo - dielectric) * s.metallic;
    return at_normal + (max(1 - s.roughness, at_normal) - at_normal) * away5;
  };
  return {channel(s.albedo.x), channel(s.albedo.y), channel(s.albedo.z)};
}

// The values of the even lanes, twice each: those of the left of two neighbours.
Float8 of_left(Float8 v) {
  return Float8(_mm256_moveldup_ps(v.m));
}
Int8 of_left(Int8 v) {
  return bits_of(of_left(float_of_bits(v)));
}
Vec8 of_left(const Vec8& v) {
  return {of_left(v.x), of_left(v.y), of_left(v.z)};
}

// Lanes that lie on the same face as the left upper one of their 2 x 2 pixels.
unsigned alike(const Surface8& upper, const Surface8& s) {
  const Vec8 way = of_left(upper.position) - s.position;
  return ((of_left(upper.id) == s.id) & (of_left(upper.material) == s.material) &
          (dot(of_left(upper.relief_normal), s.relief_normal) > Float8(like_facing)) &
          (absolute(dot(way, s.face_normal)) < Float8(like_plane_m)))
      .bits();
}

Mask8 mask_of(unsigned bits) {
  const __m256i lane_bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  return (Int8(static_cast<std::int32_t>(bits)) & Int8(lane_bits)) == Int8(lane_bits);
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
    find_alike();
    take_stored_light();
    add_panels();
    if (effort_.mirror_floor) mirror_floor();
    tile_.openness.fill(1);
    if (effort_.contact_shadows) shade_contacts();
    shade_under_actors();
    light_panes(lighting_, view_, effort_, tile_);
  }

 private:
  // A quarter of the pixels stand for their neighbours, where those lie on the same face.
  void find_alike() {
    constexpr std::size_t across = sensor_tile_side / lane_count;
    asked_count_ = 0;
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      const std::size_t upper = g & ~across;
      const unsigned lit = tile_.lit(g);
      const unsigned left = tile_.lit(upper) & 0x55U;
      like_[g] = alike(tile_.surface[upper], tile_.surface[g]) & lit & (left | left << 1);
      like_[g] &= ~(tile_.walled(g) ^ left_walled(upper));
      if (g == upper) like_[g] &= 0xAAU;
      for_lanes(lit & ~like_[g], [&](std::size_t k) {
        asked_[asked_count_++] = static_cast<std::uint16_t>(g * lane_count + k);
      });
    }
  }

  // Lanes whose left upper pixel looks through a pack; `upper` is that one's group.
  unsigned left_walled(std::size_t upper) const {
    const unsigned left = tile_.walled(upper) & 0x55U;
    return left | left << 1;
  }

  // Hands what the left upper pixels have to those that are like them.
  void spread(TileVectors& values) const {
    constexpr std::size_t across = sensor_tile_side / lane_count;
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      if (like_[g] != 0)
        values[g] = select(mask_of(like_[g]), of_left(values[g & ~across]), values[g]);
    }
  }

  void take_stored_light() {
    for (std::size_t a = 0; a < asked_count_; ++a)
      look_up(asked_[a]);
    spread(tile_.irradiance);
    spread(tile_.gloss);
  }

  void look_up(std::size_t i) {
    const std::size_t g = i / lane_count, k = i % lane_count;
    const Surface8& s = tile_.surface[g];
    const Vec3f normal = lane(s.relief_normal, k);
    const Place place =
        place_of(lane(s.position, k), lane(s.face_normal, k), s.fixture[k], s.shelf[k]);
    if (s.roughness[k] >= wide_gloss_from) {
      const Vec3f light = lighting_.field.at(place, normal);
      set_lane(tile_.irradiance[g], k, light + light_let_in(lighting_, tile_, i, normal, light));
      set_lane(tile_.gloss[g], k, light * inverse_pi);
      return;
    }
    const Vec3f mirror = mirrored(lane(tile_.direction[g], k), normal);
    const IrradianceField::TwoSided light =
        lighting_.field.at(place, Float4(normal), Float4(mirror));
    const Vec3f facing = light.facing.xyz();
    set_lane(tile_.irradiance[g], k, facing + light_let_in(lighting_, tile_, i, normal, facing));
    set_lane(tile_.gloss[g], k, (light.mirror * inverse_pi).xyz());
  }

  // Panels in gloss. Where they would show, a ray tells whether they can be seen.
  void add_panels() {
    panels_.fill({});
    std::array<std::uint16_t, lane_count> pixels{};
    std::size_t count = 0;
    for (std::size_t a = 0; a < asked_count_; ++a) {
      const std::size_t i = asked_[a];
      if (tile_.surface[i / lane_count].roughness[i % lane_count] >= wide_gloss_from) continue;
      pixels[count++] = static_cast<std::uint16_t>(i);
      if (count < lane_count) continue;
      see_panels(pixels, count);
      count = 0;
    }
    if (count > 0) see_panels(pixels, count);
    hide_panels();
    spread(panels_);
    if (effort_.panel_shadows) hide_panels_from_floor();
    for (std::size_t g = 0; g < sensor_tile_groups; ++g)
      tile_.gloss[g] += panels_[g];
  }

  // Of `count` pixels, side by side.
  void see_panels(const std::array<std::uint16_t, lane_count>& pixels, std::size_t count) {
    PanelReflection::Points points;
    Gloss8 gloss;
    Vec8 direction;
    unsigned floor = 0;
    for (std::size_t l = 0; l < lane_count; ++l) {
      const std::size_t i = pixels[l < count ? l : 0], g = i / lane_count, k = i % lane_count;
      const Surface8& s = tile_.surface[g];
      set_lane(points.position, l, lane(s.position, k));
      set_lane(gloss.albedo, l, lane(s.albedo, k));
      set_lane(gloss.normal, l, lane(s.relief_normal, k));
      gloss.roughness.set(l, s.roughness[k]);
      gloss.metallic.set(l, s.metallic[k]);
      set_lane(direction, l, lane(tile_.direction[g], k));
      floor |= (polished_floor(s).bits() >> k & 1U) << l;
    }
    points.normal = gloss.normal;
    points.roughness = gloss.roughness;
    points.mirror = mirrored(direction, gloss.normal);
    const PanelReflection::Seen seen = lighting_.panels.at(points);
    const Float8 reflected = largest(seen.radiance * reflectance_of(gloss, direction));
    const unsigned shows = (reflected > Float8(min_panel_share * white_)).bits() & ~floor;
    for (std::size_t l = 0; l < count; ++l) {
      const std::size_t i = pixels[l];
      set_lane(panels_[i / lane_count], i % lane_count, lane(seen.radiance, l));
      if (!effort_.panel_shadows || (shows >> l & 1U) == 0) continue;
      if (queue_.add(i,
                     {lane(points.position, l),
                      lane(points.mirror, l),
                      0,
                      seen.distance[l] - shadow_end_m}))
        hide_panels();
    }
  }

  void hide_panels() {
    for_lanes(blocked_in_queue(), [&](std::size_t k) {
      set_lane(panels_[queue_.pixels[k] / lane_count], queue_.pixels[k] % lane_count, {});
    });
  }

  // A floor's lobe is wide and its face even: one ray a pixel would cut highlights off sharply.
  // Every other pixel sends one into its lobe, and a window of 4 x 4 pixels knows how much of the
  // ceiling can be seen.
  void hide_panels_from_floor() {
    sampled_ = blocked_ = mirror_ = {};
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      const unsigned floor = polished_floor(tile_.surface[g]).bits() & tile_.lit(g);
      mirror_.set_group(g, floor);
      if (floor == 0) continue;
      const unsigned asked = floor & even_lanes(g) & (largest(panels_[g]) > Float8()).bits();
      sampled_.set_group(g, asked);
      for_lanes(asked, [&](std::size_t k) {
        const std::size_t i = g * lane_count + k;
        const Vec3f direction = floor_direction(i), position = lane(tile_.surface[g].position, k);
        const float up = lighting_.world.room.high.z - ceiling_room_m - position.z;
        if (queue_.add(i, {position, direction, 0, up / direction.z})) note_blocked();
      });
    }
    note_blocked();
    if (!sampled_.any()) return;
    const TileWindows windows(tile_);
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      for_lanes(mirror_.group(g), [&](std::size_t k) {
        const float open = windows.open_share(g * lane_count + k, sampled_, blocked_);
        set_lane(panels_[g], k, lane(panels_[g], k) * open);
      });
    }
  }

  // Which of the waiting rays something lies on; none waits afterwards.
  unsigned blocked_in_queue() {
    if (queue_.used == 0) return 0;
    queue_.fill();
    const std::size_t used = std::exchange(queue_.used, 0);
    return find_blocked(lighting_.world, queue_.packet.ray, used, mask_solid);
  }

  void note_blocked() {
    for_lanes(blocked_in_queue(), [&](std::size_t k) { blocked_.add(queue_.pixels[k]); });
  }

  // Every other pixel, as on a chessboard.
  static unsigned even_lanes(std::size_t group) { return group / 2 % 2 == 0 ? 0x55U : 0xAAU; }

  // Every other pixel of a polished floor sends one ray into its lobe; a window of 4 x 4 pixels
  // makes one blurred mirror picture of them.
  void mirror_floor() {
    sampled_ = mirror_ = {};
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      // Few rays in a wide lobe would leave a lamp as sparks: such floors keep their stored light.
      const Surface8& s = tile_.surface[g];
      const unsigned floor =
          (polished_floor(s) & (s.roughness < Float8(mirroring_below))).bits() & tile_.lit(g);
      mirror_.set_group(g, floor);
      sampled_.set_group(g, floor & even_lanes(g));
      for_lanes(floor & even_lanes(g), [&](std::size_t k) {
        const std::size_t i = g * lane_count + k;
        if (queue_.add(i, {lane(s.position, k), floor_direction(i)})) finish_floor();
      });
    }
    if (queue_.used > 0) finish_floor();
    if (mirror_.any()) blur_floor();
  }

  Vec3f floor_direction(std::size_t i) const {
    const Surface8& s = tile_.surface[i / lane_count];
    const std::size_t number = number_in_block(i);
    const float roughness = s.roughness[i % lane_count], alpha = roughness * roughness;
    const float u = first_numbers[number], angle = two_pi * second_numbers[number];
    const float slope = alpha * std::sqrt(u / (widest_mirror - u));
    const TangentFrame frame(lane(s.relief_normal, i % lane_count));
    const Vec3f half =
        normalized(frame.to_world({slope * std::cos(angle), slope * std::sin(angle), 1}));
    Vec3f direction = mirrored(tile_.direction_of(i), half);
    constexpr float min_rise = 0.004F;
    direction.z = std::max(direction.z, min_rise);
    return normalized(direction);
  }

  void finish_floor() {
    queue_.fill();
    trace(lighting_.world, queue_.packet, queue_.used, mask_opaque, RayBundle::scattered);
    fetch_surfaces(lighting_.world, queue_.packet);
    for (std::size_t k = 0; k < queue_.used; ++k) {
      const Surface8& s = tile_.surface[queue_.pixels[k] / lane_count];
      const std::size_t l = queue_.pixels[k] % lane_count;
      floor_[queue_.pixels[k]] = mirrored_light(ray_in(queue_.packet.ray, k),
                                                hit_in(queue_.packet, k),
                                                s.roughness[l] * s.roughness[l],
                                                s.distance[l]);
    }
    queue_.used = 0;
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
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      for_lanes(mirror_.group(g), [&](std::size_t k) {
        const WindowCorner corner(g * lane_count + k);
        Vec3f sum;
        float count = 0;
        for (int row = corner.row; row < corner.row + 4; ++row) {
          for_lanes(sampled_.four(row, corner.column), [&](std::size_t column) {
            sum += floor_[SensorTile::number_of(corner.column, row) + column];
            count += 1;
          });
        }
        if (count > 0) set_lane(tile_.gloss[g], k, sum / count + lane(panels_[g], k));
      });
    }
  }

  // Short rays find what stands close: the stored light is too coarse to know.
  void shade_contacts() {
    sampled_ = blocked_ = {};
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      const unsigned near = (tile_.surface[g].distance < Float8(contact_until_m)).bits();
      const unsigned asked = tile_.lit(g) & near &
                             (effort_.all_contact_pixels ? 255U : even_lanes(g)) & ~tile_.walled(g);
      sampled_.set_group(g, asked);
      for_lanes(asked, [&](std::size_t k) {
        const std::size_t i = g * lane_count + k;
        if (queue_.add(i, contact_ray(i))) note_blocked();
      });
    }
    note_blocked();
    darken(Window::narrow,
           [](float open) { return darkest_contact + (1 - darkest_contact) * open; });
  }

  // Openness of the pixels near a blocked one, by what their windows say.
  template <class Remaining>
  void darken(Window window, const Remaining& remaining) {
    if (!blocked_.any()) return;
    const TileWindows windows(tile_);
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      for_lanes(tile_.lit(g) & ~tile_.walled(g), [&](std::size_t k) {
        const std::size_t i = g * lane_count + k;
        if (!blocked_.near(i, window)) return;
        const float open = windows.open_share(i, sampled_, blocked_, window);
        tile_.openness[g].set(k, tile_.openness[g][k] * remaining(open));
      });
    }
  }

  Ray contact_ray(std::size_t i) const {
    const std::size_t number = number_in_block(i);
    const float u = first_numbers[number], v = second_numbers[number];
    static const std::array<Vec3f, packet_size> directions = [] {
      std::array<Vec3f, packet_size> made;
      for (std::size_t k = 0; k < packet_size; ++k)
        made[k] = cosine_direction(first_numbers[k], second_numbers[k]);
      return made;
    }();
    const float far = nearest_contact_m + contact_reach_m * std::fmod(u * 5.37F + v, 1.0F);
    return over(i, directions[number], far);
  }

  // From a pixel's face; `direction` has z along its normal.
  Ray over(std::size_t i, Vec3f direction, float reach_m) const {
    const Surface8& s = tile_.surface[i / lane_count];
    const TangentFrame frame(lane(s.normal, i % lane_count));
    return {lane(s.position, i % lane_count), frame.to_world(direction), 0, reach_m};
  }

  // Actors are not in the stored light: what they keep away from the surfaces around them is found
  // by longer rays that meet nothing else. Few directions would leave a ghost of the actor each.
  void shade_under_actors() {
    const World& world = lighting_.world;
    if (!world.actors.bvh) return;
    RTCBounds box;
    rtcGetSceneBounds(world.actors.bvh.get(), &box);
    const auto within = [](Float8 p, float low, float high) {
      return (p > Float8(low - actor_reach_m)) & (p < Float8(high + actor_reach_m));
    };
    sampled_ = blocked_ = {};
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      const Vec8& p = tile_.surface[g].position;
      const unsigned asked = tile_.lit(g) & (within(p.x, box.lower_x, box.upper_x) &
                                             within(p.y, box.lower_y, box.upper_y) &
                                             within(p.z, box.lower_z, box.upper_z))
                                                .bits();
      sampled_.set_group(g, asked);
      for_lanes(asked, [&](std::size_t k) {
        const std::size_t i = g * lane_count + k;
        const auto [u, v] = wide_numbers(i);
        if (queue_.add(i, over(i, cosine_direction(u, v), actor_reach_m))) note_blocked_by_actors();
      });
    }
    note_blocked_by_actors();
    darken(Window::wide, [](float open) { return 1 - actor_darkness * (1 - open); });
  }

  void note_blocked_by_actors() {
    if (queue_.used == 0) return;
    queue_.fill();
    const std::size_t used = std::exchange(queue_.used, 0);
    for_lanes(find_blocked_by_actors(lighting_.world, queue_.packet.ray, used),
              [&](std::size_t k) { blocked_.add(queue_.pixels[k]); });
  }

  const Lighting& lighting_;
  const View& view_;
  const SensorEffort& effort_;
  SensorTile& tile_;
  float white_;  // radiance shown as white
  // Lanes of each group that take over the light of the left upper of their 2 x 2 pixels; the
  // other pixels.
  std::array<unsigned, sensor_tile_groups> like_;
  std::array<std::uint16_t, sensor_tile_pixels> asked_;
  std::size_t asked_count_ = 0;
  TileVectors panels_;
  std::array<Vec3f, sensor_tile_pixels> floor_;
  TilePixels mirror_, sampled_;
  TilePixels blocked_;  // whose ray met something
  RayQueue queue_;
};

}  // namespace

void shade_tile(const Lighting& lighting,
                const View& view,
                const SensorEffort& effort,
                SensorTile& tile) {
  TileShader(lighting, view, effort, tile).run();
}

Vec8 lit_radiance(const Surface8& s,
                  const Vec8& direction,
                  const Vec8& irradiance,
                  const Vec8& gloss) {
  const Vec8 reflectance =
      reflectance_of({s.albedo, s.relief_normal, s.roughness, s.metallic}, direction);
  return s.albedo * irradiance * ((1 - s.metallic) * Float8(inverse_pi)) + reflectance * gloss +
         s.emission;
}

Vec8 radiance_of(const World& world, const SensorTile& tile, std::size_t group) {
  Vec8 radiance = lit_radiance(tile.surface[group],
                               tile.direction[group],
                               tile.irradiance[group] * tile.openness[group],
                               tile.gloss[group]);
  const unsigned inside = tile.inside_of(group);
  for_lanes(inside & ~tile.lit(group), [&](std::size_t k) {
    set_lane(radiance, k, world.surroundings.radiance(lane(tile.direction[group], k)));
  });
  const auto veil = [&](const auto& panes, const auto& index) {
    for_lanes(inside, [&](std::size_t k) {
      const std::int16_t found = index[group * lane_count + k];
      if (found < 0) return;
      const TilePane& pane = panes[static_cast<std::size_t>(found)];
      set_lane(radiance, k, lane(radiance, k) * pane.transmittance + pane.light);
    });
  };
  if (tile.wall_count > 0) veil(tile.walls, tile.wall_of);
  if (tile.pane_count > 0) veil(tile.panes, tile.pane_of);
  return radiance;
}

}  // namespace marketgen::render::raytrace
