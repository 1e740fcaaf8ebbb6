#include "render/sensor/sensor_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/interrupt.h"
#include "base/parallel.h"
#include "render/sensor/sensor_edges.h"
#include "render/sensor/sensor_packs.h"
#include "render/tone.h"

namespace marketgen::render::raytrace {
namespace {

// A tile, or a strip of rows, of one of the shots.
struct PartOfShot {
  std::uint32_t shot = 0;
  int part = 0;
};

template <class Count>
std::vector<PartOfShot> parts_of(std::span<const SensorShot> shots, const Count& count) {
  std::vector<PartOfShot> parts;
  for (std::uint32_t s = 0; s < shots.size(); ++s) {
    const int in_shot = count(shots[s].view);
    for (int p = 0; p < in_shot; ++p)
      parts.push_back({s, p});
  }
  return parts;
}

// A Matter for each lane.
Int8 first_matter(const SensorTile& tile, std::size_t group) {
  const auto code = [](Matter matter) { return Int8(static_cast<std::int32_t>(matter)); };
  const Surface8& s = tile.surface[group];
  Int8 matter =
      select(s.metallic > Float8(min_bare_metal), code(Matter::metal), code(Matter::solid));
  matter = select(s.clear, code(Matter::clear), matter);
  matter = select(tile.depth[group] > Float8(), matter, code(Matter::none));
  for (std::size_t k = 0; tile.pane_count > 0 && k < lane_count; ++k) {
    if (tile.pane_of[group * lane_count + k] >= 0)
      matter.set(k, static_cast<std::int32_t>(Matter::glass));
  }
  return matter;
}

void write_normals(const Vec8& normal, std::size_t count, float* to) {
  std::array<std::array<float, lane_count>, 3> rows;
  normal.x.store(rows[0].data());
  normal.y.store(rows[1].data());
  normal.z.store(rows[2].data());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      to[3 * k + c] = rows[c][k];
  }
}

void write_geometry(const SensorTile& tile, int width, const FrameBuffers& to) {
  tile.for_groups(width, [&](std::size_t g, std::size_t place, std::size_t count) {
    const Mask8 seen = tile.depth[g] > Float8();
    std::array<std::uint32_t, lane_count> numbers;
    std::array<float, lane_count> depth;
    if (to.depth_m != nullptr) {
      tile.depth[g].store(depth.data());
      std::copy_n(depth.begin(), count, to.depth_m + place);
    }
    if (to.instance != nullptr) {
      select(seen, tile.surface[g].id, Int8(0)).store(numbers.data());
      std::copy_n(numbers.begin(), count, to.instance + place);
    }
    if (to.matter != nullptr) {
      first_matter(tile, g).store(numbers.data());
      for (std::size_t k = 0; k < count; ++k)
        to.matter[place + k] = static_cast<std::uint8_t>(numbers[k]);
    }
    if (to.normals != nullptr)
      write_normals(select(seen, tile.surface[g].normal, Vec8{}), count, to.normals + 3 * place);
  });
}

void write_color(const SensorTile& tile, const SensorShot& shot, Vec3f light) {
  const World& world = shot.lighting->world;
  tile.for_groups(shot.view.width(), [&](std::size_t g, std::size_t place, std::size_t count) {
    const ToneCurve::Pixels shown =
        tone_curve().shown(exposed(radiance_of(world, tile, g), world.exposure, light));
    std::copy_n(shown.begin(), 3 * count, shot.to.rgb + 3 * place);
  });
}

bool wants_light(const SensorShot& shot) {
  return shot.to.rgb != nullptr;
}

// What is not asked for costs nothing. Relief may say what is bare metal.
SensorDetail detail_of(const SensorShot& shot, SensorDetail detail) {
  if (!wants_light(shot) && shot.to.matter == nullptr) detail.textures = TextureDetail::none;
  if (!wants_light(shot)) detail.packs_deep = 0;
  return detail;
}

}  // namespace

SensorEffort sensor_effort(const RenderOptions& options) {
  SensorEffort effort;
  effort.detail.opaque_mask = options.hide_ceiling ? mask_solid : mask_opaque;
  effort.light = options.light;
  switch (options.quality) {
    case Quality::fast:
      effort.detail.textures = TextureDetail::level;
      effort.mirror_panes = effort.panel_shadows = effort.contact_shadows = false;
      effort.edge_samples = 0;
      effort.detail.packs_deep = 1;
      effort.detail.share_packs = true;
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
  const std::vector<PartOfShot> tiles = parts_of(
      shots, [](const View& view) { return sensor_tiles_across(view) * sensor_tiles_down(view); });
  const bool smooth = effort.edge_samples > 0;
  const std::vector<PartOfShot> strips =
      smooth ? parts_of(shots, sensor_strips) : std::vector<PartOfShot>{};
  // Kept between calls: fresh memory would cost as much as a fifth of the picture.
  static thread_local std::vector<SensorPlanes> kept;
  std::vector<SensorPlanes>& planes = kept;
  if (planes.size() < shots.size()) planes.resize(shots.size());
  for (std::size_t s = 0; smooth && s < shots.size(); ++s) {
    if (wants_light(shots[s])) planes[s].resize(shots[s].view);
  }
  progress.begin("picture", tiles.size() + strips.size());
  parallel_for(tiles.size(), [&](std::size_t t) {
    if (!check_interrupt().ok()) return;
    static thread_local SensorTile tile;
    const SensorShot& shot = shots[tiles[t].shot];
    trace_tile(
        shot.lighting->world, shot.view, tiles[t].part, detail_of(shot, effort.detail), tile);
    write_geometry(tile, shot.view.width(), shot.to);
    if (wants_light(shot)) {
      look_through_packs(shot.lighting->world, shot.view, effort.detail, tile);
      shade_tile(*shot.lighting, shot.view, effort, tile);
      if (smooth)
        planes[tiles[t].shot].take(shot.lighting->world, tile);
      else
        write_color(tile, shot, effort.light);
    }
    progress.advance();
  });
  parallel_for(strips.size(), [&](std::size_t t) {
    const SensorShot& shot = shots[strips[t].shot];
    if (wants_light(shot) && check_interrupt().ok())
      resolve_strip(
          *shot.lighting, shot.view, effort, planes[strips[t].shot], strips[t].part, shot.to.rgb);
    progress.advance();
  });
  progress.end();
}

}  // namespace marketgen::render::raytrace
