#include "render/sensor/sensor_tile.h"

#include <algorithm>

#include "render/ray_queue.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr int max_panes_deep = 4;  // seen through one another
constexpr float behind_pane_m = 2e-3F;

class TileTracer {
 public:
  TileTracer(const World& world, const View& view, const SensorDetail& detail, SensorTile& tile)
      : world_(world),
        view_(view),
        detail_(detail),
        tile_(tile),
        mask_(detail.opaque_mask | (world.has_glass ? mask_glass : 0U)) {}

  // All rays first: what their hits need is on its way meanwhile.
  void run() {
    for_blocks([this](int column, int row) { trace_block(column, row); });
    for_blocks([this](int column, int row) {
      for (int r = row; r < row + block_rows; ++r)
        take(group_at(column, r));
    });
    if (behind_.used > 0) trace_behind();
  }

 private:
  static constexpr int block_rows = 4;

  static std::size_t group_at(int column, int row) {
    return SensorTile::number_of(column, row) / lane_count;
  }

  // Calls body(column, row) for each block of 8 x 4 pixels that lies in the picture.
  template <class Body>
  void for_blocks(const Body& body) {
    for (int row = 0; row < sensor_tile_side; row += block_rows) {
      for (int column = 0; column < sensor_tile_side; column += static_cast<int>(lane_count)) {
        if (column < tile_.columns && row < tile_.rows) {
          body(column, row);
          continue;
        }
        for (int r = row; r < row + block_rows; ++r)
          tile_.depth[group_at(column, r)] = 0;
      }
    }
  }

  // Two packets of 4 x 4 pixels side by side: squares hold together better than strips.
  void trace_block(int column, int row) {
    std::array<std::array<Hits8, 2>, 2> hits;
    for (int r = row; r < row + block_rows; ++r)
      rays_[group_at(column, r)] = rays_of(column, r);
    for (const Side side : {Side::first, Side::last}) {
      RTCRayHit16 packet;
      for (std::size_t half = 0; half < 2; ++half) {
        const Rays8& upper = rays_[group_at(column, row + 2 * static_cast<int>(half))];
        const Rays8& lower = rays_[group_at(column, row + 2 * static_cast<int>(half) + 1)];
        set_rays(packet.ray,
                 half,
                 {four_each(upper.origin, lower.origin, side),
                  four_each(upper.direction, lower.direction, side)},
                 View::near_m);
      }
      trace(world_, packet, packet_size, mask_, RayBundle::coherent);
      fetch_surfaces(world_, packet);
      for (std::size_t half = 0; half < 2; ++half)
        hits[half][side == Side::first ? 0 : 1] = hits_of(packet, half);
    }
    for (std::size_t half = 0; half < 2; ++half) {
      const int upper = row + 2 * static_cast<int>(half);
      hits_[group_at(column, upper)] = four_each(hits[half][0], hits[half][1], Side::first);
      hits_[group_at(column, upper + 1)] = four_each(hits[half][0], hits[half][1], Side::last);
    }
  }

  // Pixels past the picture's edge repeat the last one: a full packet is as cheap as a part.
  Rays8 rays_of(int column, int row) const {
    const Float8 lanes(_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7));
    const Float8 x = min(static_cast<float>(tile_.x0 + column) + lanes,
                         Float8(static_cast<float>(view_.width() - 1)));
    const auto y = static_cast<float>(std::min(tile_.y0 + row, view_.height() - 1));
    return view_.rays(x + 0.5F, y + 0.5F);
  }

  void take(std::size_t group) {
    const Rays8& rays = rays_[group];
    const Hits8& hits = hits_[group];
    Surface8& seen = tile_.surface[group];
    see_surfaces(world_, rays, hits, view_.footprint(hits.t), detail_.textures, seen);
    tile_.direction[group] = rays.direction;
    tile_.depth[group] = select(hits.any, view_.depth_of(rays.direction, hits.t), Float8());
    std::fill_n(&tile_.pane_of[group * lane_count], lane_count, std::int16_t{-1});
    std::fill_n(&tile_.wall_of[group * lane_count], lane_count, std::int16_t{-1});
    if (detail_.packs_deep > 0) {
      for_lanes((hits.any & seen.clear).bits(), [&](std::size_t k) {
        const std::size_t i = group * lane_count + k;
        note_wall(i, tile_.surface_of(i), static_cast<std::uint32_t>(hits.instance[k]));
      });
    }
    if (!world_.has_glass) return;
    for_lanes((hits.any & seen.glass).bits(), [&](std::size_t k) {
      tile_.depth[group].set(k, 0);
      take_pane(group * lane_count + k, {lane(rays.origin, k), lane(rays.direction, k)});
    });
  }

  // A clear pack: what lies behind it is looked for later, see sensor_packs.h.
  void note_wall(std::size_t i, const Surface& wall, std::uint32_t instance) {
    const bool sheet = world_.materials[wall.material].refraction <= 1;
    tile_.wall_of[i] = static_cast<std::int16_t>(tile_.wall_count);
    TilePane& noted = tile_.walls[tile_.wall_count++];
    noted.pixel = static_cast<std::uint16_t>(i);
    noted.instance = instance;
    noted.first = wall;
    const Vec3f direction = tile_.direction_of(i);
    noted.mirror = mirrored(direction, wall.normal);
    noted.reflected = reflected_by(sheet ? pane_reflectance : dielectric_reflectance,
                                   -dot(wall.normal, direction));
  }

  void take_pane(std::size_t i, const Ray& ray) {
    tile_.pane_of[i] = static_cast<std::int16_t>(tile_.pane_count);
    TilePane& pane = tile_.panes[tile_.pane_count++];
    pane.pixel = static_cast<std::uint16_t>(i);
    pane.first = tile_.surface_of(i);
    pane.mirror = mirrored(ray.direction, pane.first.normal);
    pane.reflected = reflected_by(pane_reflectance, -dot(pane.first.normal, ray.direction));
    pane.transmittance = pane.first.albedo * (1 - pane.reflected);
    look_behind(i, ray, pane.first.distance);
  }

  static float reflected_by(float straight_on, float cosine) {
    return fresnel({straight_on, straight_on, straight_on}, cosine).x;
  }

  // Goes on behind the pane that was met at `distance`.
  void look_behind(std::size_t i, Ray ray, float distance) {
    ray.near = distance + behind_pane_m;
    if (behind_.add(i, ray)) trace_behind();
  }

  // Every pass goes through one more pane; the last looks through all that are left.
  void trace_behind() {
    for (int pane = 1; behind_.used > 0; ++pane) {
      const unsigned mask = pane < max_panes_deep ? mask_ : detail_.opaque_mask;
      RayQueue now = behind_;
      behind_.used = 0;
      now.fill();
      trace(world_, now.packet, now.used, mask, RayBundle::scattered);
      for (std::size_t k = 0; k < now.used; ++k) {
        const Hit hit = hit_in(now.packet, k);
        if (!hit.any()) continue;
        Ray ray = ray_in(now.packet.ray, k);
        if (see_behind(now.pixels[k], ray, hit)) continue;
        ray.near = hit.t + behind_pane_m;
        ray.far = ray_infinity;
        behind_.add(now.pixels[k], ray);
      }
    }
  }

  // Whether the pixel has arrived at something that is no pane.
  bool see_behind(std::size_t i, const Ray& ray, const Hit& hit) {
    const Surface seen = surface_at(world_, ray, hit, view_.footprint(hit.t), detail_.textures);
    if (seen.glass) {
      TilePane& pane = tile_.panes[static_cast<std::size_t>(tile_.pane_of[i])];
      pane.transmittance *=
          seen.albedo * (1 - reflected_by(pane_reflectance, -dot(seen.normal, ray.direction)));
      return false;
    }
    const std::size_t group = i / lane_count, k = i % lane_count;
    const bool clear = world_.materials[seen.material].clear;
    set_surface(tile_.surface[group], k, seen, clear);
    if (clear && detail_.packs_deep > 0) note_wall(i, seen, hit.instance);
    tile_.depth[group].set(k, view_.depth_of(ray, hit.t));
    return true;
  }

  const World& world_;
  const View& view_;
  const SensorDetail& detail_;
  SensorTile& tile_;
  unsigned mask_;
  RayQueue behind_;
  std::array<Rays8, sensor_tile_groups> rays_;
  std::array<Hits8, sensor_tile_groups> hits_;
};

}  // namespace

const TilePane& SensorTile::model_of(const TilePane& wall) const {
  constexpr float same_facing = 0.985F;  // cosine between their normals
  const int column = column_of(wall.pixel), row = row_of(wall.pixel);
  const std::int16_t found = wall_of[number_of(column & ~1, row & ~1)];
  if (found < 0) return wall;
  const TilePane& model = walls[static_cast<std::size_t>(found)];
  const bool same =
      model.instance == wall.instance && dot(model.first.normal, wall.first.normal) > same_facing;
  return same ? model : wall;
}

void trace_tile(
    const World& world, const View& view, int index, const SensorDetail& detail, SensorTile& tile) {
  tile.x0 = index % sensor_tiles_across(view) * sensor_tile_side;
  tile.y0 = index / sensor_tiles_across(view) * sensor_tile_side;
  tile.columns = std::min(sensor_tile_side, view.width() - tile.x0);
  tile.rows = std::min(sensor_tile_side, view.height() - tile.y0);
  tile.pane_count = tile.wall_count = 0;
  TileTracer(world, view, detail, tile).run();
}

}  // namespace marketgen::render::raytrace
