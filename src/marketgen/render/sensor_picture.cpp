#include "render/sensor_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "render/sensor_edges.h"
#include "render/tone.h"

namespace marketgen::raytrace {
namespace {

// A tile of one of the shots.
struct TileOfShot {
  std::uint32_t shot = 0;
  int tile = 0;
};

std::vector<TileOfShot> tiles_of(std::span<const SensorShot> shots) {
  std::vector<TileOfShot> tiles;
  for (std::uint32_t s = 0; s < shots.size(); ++s) {
    const int count = sensor_tiles_across(shots[s].view) * sensor_tiles_down(shots[s].view);
    for (int t = 0; t < count; ++t)
      tiles.push_back({s, t});
  }
  return tiles;
}

Matter first_matter(const World& world, const SensorTile& tile, std::size_t i) {
  if (tile.pane_of[i] >= 0) return Matter::glass;
  return tile.depth[i] > 0 ? matter_of(world, tile.surface[i]) : Matter::none;
}

void write_geometry(const World& world, const SensorTile& tile, int width, const FrameBuffers& to) {
  tile.for_runs(width, [&](std::size_t first, std::size_t place, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k, at = place + k;
      const bool seen = tile.depth[i] > 0;
      if (to.depth_m != nullptr) to.depth_m[at] = tile.depth[i];
      if (to.instance != nullptr) to.instance[at] = seen ? tile.surface[i].id : 0;
      if (to.matter != nullptr)
        to.matter[at] = static_cast<std::uint8_t>(first_matter(world, tile, i));
      if (to.normals == nullptr) continue;
      const Vec3f normal = seen ? tile.surface[i].normal : Vec3f{};
      to.normals[3 * at] = normal.x;
      to.normals[3 * at + 1] = normal.y;
      to.normals[3 * at + 2] = normal.z;
    }
  });
}

void write_color(const SensorTile& tile, const SensorShot& shot) {
  const World& world = shot.lighting->world;
  std::array<std::uint8_t, 3 * sensor_tile_pixels> rgb;
  std::array<Float4, sensor_tile_pixels> radiance;
  for (std::size_t i = 0; i < sensor_tile_pixels; ++i) {
    if (tile.inside(i)) radiance[i] = radiance_of(world, tile, i);
  }
  tone_curve().write(radiance, world.exposure, rgb.data());
  tile.for_runs(shot.view.width(), [&](std::size_t first, std::size_t place, std::size_t count) {
    std::memcpy(shot.to.rgb + 3 * place, rgb.data() + 3 * first, 3 * count);
  });
}

bool wants_light(const SensorShot& shot) {
  return shot.to.rgb != nullptr;
}

}  // namespace

SensorEffort sensor_effort(const RenderOptions& options) {
  SensorEffort effort;
  effort.detail.opaque_mask = options.hide_ceiling ? mask_solid : mask_opaque;
  switch (options.quality) {
    case Quality::fast:
      effort.detail.textures = TextureDetail::level;
      effort.mirror_panes = effort.panel_shadows = effort.contact_shadows = false;
      effort.edge_samples = 0;
      break;
    case Quality::balanced:
      break;
    case Quality::best:
      effort.mirror_floor = effort.all_contact_pixels = true;
      effort.edge_samples = 4;
      break;
  }
  return effort;
}

void take_pictures(std::span<const SensorShot> shots,
                   const SensorEffort& effort,
                   Progress& progress) {
  const std::vector<TileOfShot> tiles = tiles_of(shots);
  // Kept between calls: fresh memory would cost as much as a fifth of the picture.
  static thread_local std::vector<SensorPlanes> kept;
  std::vector<SensorPlanes>& planes = kept;
  if (planes.size() < shots.size()) planes.resize(shots.size());
  if (effort.edge_samples > 0) {
    for (std::size_t s = 0; s < shots.size(); ++s) {
      if (wants_light(shots[s])) planes[s].resize(shots[s].view.width(), shots[s].view.height());
    }
  }
  progress.begin("picture", 2 * tiles.size());
  parallel_for(tiles.size(), [&](std::size_t t) {
    if (!check_interrupt().ok()) return;
    static thread_local SensorTile tile;
    const SensorShot& shot = shots[tiles[t].shot];
    trace_tile(shot.lighting->world, shot.view, tiles[t].tile, effort.detail, tile);
    write_geometry(shot.lighting->world, tile, shot.view.width(), shot.to);
    if (wants_light(shot)) {
      shade_tile(*shot.lighting, shot.view, effort, tile);
      if (effort.edge_samples > 0)
        planes[tiles[t].shot].take(shot.lighting->world, tile);
      else
        write_color(tile, shot);
    }
    progress.advance();
  });
  parallel_for(tiles.size(), [&](std::size_t t) {
    const SensorShot& shot = shots[tiles[t].shot];
    if (wants_light(shot) && effort.edge_samples > 0 && check_interrupt().ok())
      resolve_tile(
          *shot.lighting, shot.view, effort, planes[tiles[t].shot], tiles[t].tile, shot.to.rgb);
    progress.advance();
  });
  progress.end();
}

}  // namespace marketgen::raytrace
