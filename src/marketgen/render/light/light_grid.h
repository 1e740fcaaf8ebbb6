// Which lights matter where: for each cell of the room, the strongest lights and how likely each is
// to be picked.
//
// Estimating a point's light from one light costs one shadow ray; picking lights by what they would
// give unblocked at the cell's middle keeps the noise low in rooms with hundreds of panels and
// cooler strips.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/stage/world.h"

namespace marketgen::render::raytrace {

struct LightChoice {
  std::uint32_t light = 0;
  float cumulative = 0;  // probability of this choice or an earlier one
};

// One point on one light.
struct LightSample {
  Vec3f direction;  // unit, towards the light
  float distance = 0;
  Vec3f irradiance_scale;  // radiance / probability density over solid angle; zero when the light
                           // faces away
  float pdf = 0;           // over solid angle
  std::uint32_t light = 0;
};

class LightGrid {
 public:
  explicit LightGrid(const World& world);

  // The choices at a point, most important first. Empty when the world has no lights.
  std::span<const LightChoice> choices(Vec3f point) const;
  // Picks by `pick`, places by (u, v), all in [0, 1). The leftover of `pick` within its choice is
  // spread again, so that stratified numbers stay stratified on the light.
  LightSample sample(Vec3f point, float pick, float u, float v) const;
  // Density over solid angle with which `sample` would have chosen this point of this light.
  float pdf(Vec3f point, std::int32_t light, Vec3f direction, float distance) const;

 private:
  std::size_t cell_of(Vec3f point) const;
  const World& world_;
  Vec3f low_, cells_per_m_;
  int columns_ = 1, rows_ = 1, layers_ = 1;
  std::vector<LightChoice> choices_;
  std::vector<std::uint32_t> first_;  // of each cell in choices_, one past the last at the end
};

}  // namespace marketgen::render::raytrace
