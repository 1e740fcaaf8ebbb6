// All goods of a region let go at once in a World, and where they are after a while.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalog/rows.h"
#include "scene/scene.h"

namespace marketgen::physics {

struct LetGoOptions {
  std::array<double, 4> region_m{};  // x0, y0, x1, y1; by the middle of a product's foot
  double seconds = 2;
  double lift_m = 0;  // raised by so much first, but for what hangs on a peg
  bool soft = true;   // bags and pouches bend; otherwise they are rigid, as exports have them
  std::vector<catalog::FrictionRow> frictions = {};  // as WorldOptions have them
};

struct LetGoProduct {
  std::uint32_t product = 0;  // row
  Pose world_from_product;
  bool rests = false;  // nothing of it moves
};

// By row. What the region's goods push awakes, too, and is not among them. The whole store is in
// the World. Errors: physics.bad_command when more goods stand there than a World can move, 1,024;
// those of World; internal.interrupted.
Result<std::vector<LetGoProduct>> let_go(const scene::Scene& scene,
                                         const LetGoOptions& options,
                                         Progress& progress = silent_progress());

}  // namespace marketgen::physics
