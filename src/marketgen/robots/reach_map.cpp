#include "robots/reach_map.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/parallel.h"
#include "robots/rotation.h"

namespace marketgen::robots {
namespace {

constexpr double max_cells = 4e6;

Error bad_options(const std::string& message) {
  return {"robot.bad_state", "reach map", message};
}

Result<std::array<int, 3>> cells_of(const ReachMapOptions& options) {
  const Vec3 size = options.high - options.low;
  const bool sound = size.x > 0 && size.y > 0 && size.z > 0 && std::isfinite(length(size)) &&
                     std::isfinite(length(options.low));
  if (!sound) return bad_options("the region must be finite, with low below high");
  if (!(options.cell_m > 0) || options.directions < 1 || options.rolls < 1)
    return bad_options("cells, directions and rolls must be above 0");
  const Vec3 count = size / options.cell_m;
  if (!(std::ceil(count.x) * std::ceil(count.y) * std::ceil(count.z) <= max_cells))
    return bad_options(fmt::format("the map would have more than {} cells; take larger ones",
                                   static_cast<int>(max_cells)));
  constexpr double slack = 1e-9;  // 2 m in cells of 0.1 m are 20 cells, not 21
  return std::array<int, 3>{static_cast<int>(std::ceil(count.x - slack)),
                            static_cast<int>(std::ceil(count.y - slack)),
                            static_cast<int>(std::ceil(count.z - slack))};
}

}  // namespace

std::vector<Quaternion> reach_orientations(int directions, int rolls) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Quaternion> turns;
  for (int i = 0; i < directions; ++i) {
    const double z = 1 - (2 * i + 1.0) / directions;
    const double flat = std::sqrt(1 - z * z);
    const Quaternion aim = rotation_from_z_to(
        normalized(Vec3{flat * std::cos(golden * i), flat * std::sin(golden * i), z}));
    for (int k = 0; k < rolls; ++k)
      turns.push_back(aim * rotation_about({0, 0, 1}, 2 * std::numbers::pi * k / rolls));
  }
  return turns;
}

bool can_reach(const ArmIk& arm, const Pose& base_from_tip, const SweepOptions& sweep) {
  for (const double redundancy : redundancies(arm, sweep)) {
    if (!solve_arm(arm, base_from_tip, redundancy).empty()) return true;
  }
  return false;
}

float ReachMap::share_at(Vec3 point) const {
  const Vec3 at = (point - low) / cell_m;
  const auto inside = [](double value, int count) { return value >= 0 && value < count; };
  if (!inside(at.x, cells[0]) || !inside(at.y, cells[1]) || !inside(at.z, cells[2])) return 0;
  return share(static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z));
}

Result<ReachMap> make_reach_map(const ArmIk& arm, const ReachMapOptions& options) {
  ReachMap map{options.low, options.cell_m, {}, {}};
  MARKETGEN_TRY(map.cells, cells_of(options));
  const std::vector<Quaternion> turns = reach_orientations(options.directions, options.rolls);
  const auto count = static_cast<std::size_t>(map.cells[0]) *
                     static_cast<std::size_t>(map.cells[1]) *
                     static_cast<std::size_t>(map.cells[2]);
  map.shares = parallel_map(count, [&](std::size_t cell) {
    const int x = static_cast<int>(cell) % map.cells[0];
    const int y = static_cast<int>(cell) / map.cells[0] % map.cells[1];
    const int z = static_cast<int>(cell) / map.cells[0] / map.cells[1];
    int reached = 0;
    for (const Quaternion& turn : turns)
      reached += can_reach(arm, {map.center(x, y, z), turn}, options.sweep) ? 1 : 0;
    return static_cast<float>(reached) / static_cast<float>(turns.size());
  });
  return map;
}

}  // namespace marketgen::robots
