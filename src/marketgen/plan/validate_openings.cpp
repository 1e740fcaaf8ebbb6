#include <algorithm>
#include <vector>

#include "base/text.h"
#include "plan/floor_places.h"
#include "plan/validation.h"

namespace marketgen::plan {
namespace {

// Part of a wall, in millimetres from its west or south end.
struct Stretch {
  int from = 0, to = 0;
};

Stretch stretch_of(const Opening& opening, const Shell& shell) {
  const int wall_mm = runs_east(opening.wall) ? shell.width_mm : shell.depth_mm;
  const int middle = static_cast<int>(opening.center * wall_mm + 0.5);
  return {middle - opening.width_mm / 2, middle - opening.width_mm / 2 + opening.width_mm};
}

// The parts of one side of the shell where there is a wall.
std::vector<Stretch> wall_parts(Wall wall, const Shell& shell) {
  const int length = runs_east(wall) ? shell.width_mm : shell.depth_mm;
  if (!shell.outline_mm) return {{0, length}};
  const int across = runs_east(wall) ? 1 : 0;
  const int line = wall == Wall::north ? shell.depth_mm : (wall == Wall::east ? shell.width_mm : 0);
  std::vector<Stretch> parts;
  const PolygonMm& outline = *shell.outline_mm;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PointMm a = outline[i];
    const PointMm b = outline[(i + 1) % outline.size()];
    if (a[across] != line || b[across] != line) continue;
    parts.push_back(
        {std::min(a[1 - across], b[1 - across]), std::max(a[1 - across], b[1 - across])});
  }
  return parts;
}

Error opening_fault(const PlanCheck& check,
                    std::size_t i,
                    std::string_view field,
                    std::string message) {
  return {"plan.bad_opening",
          check.at(element_pointer("shell/openings", i, field)),
          std::move(message)};
}

Result<void> check_in_wall(const PlanCheck& check, std::size_t i) {
  const Opening& opening = check.plan.shell.openings[i];
  const Stretch at = stretch_of(opening, check.plan.shell);
  const std::vector<Stretch> parts = wall_parts(opening.wall, check.plan.shell);
  const bool fits = std::ranges::any_of(
      parts, [&](Stretch part) { return part.from <= at.from && at.to <= part.to; });
  if (fits) return {};
  return opening_fault(check,
                       i,
                       "center",
                       "the opening takes " + with_thousands(at.from) + " to " +
                           with_thousands(at.to) + " mm of the " +
                           std::string(name_of(opening.wall)) +
                           " wall, which is not all wall; move its center or make it narrower");
}

}  // namespace

Result<void> check_openings(const PlanCheck& check) {
  const std::vector<Opening>& openings = check.plan.shell.openings;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    MARKETGEN_CHECK(check_in_wall(check, i));
    const Stretch mine = stretch_of(openings[i], check.plan.shell);
    for (std::size_t k = 0; k < i; ++k) {
      const Stretch other = stretch_of(openings[k], check.plan.shell);
      const bool apart = mine.to <= other.from || other.to <= mine.from;
      if (openings[k].wall != openings[i].wall || apart) continue;
      return opening_fault(
          check,
          i,
          "center",
          "the opening overlaps \"" + openings[k].id + "\" on the same wall; move one of them");
    }
  }
  return {};
}

}  // namespace marketgen::plan
