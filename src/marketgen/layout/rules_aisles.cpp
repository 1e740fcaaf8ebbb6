// Rules about aisles: how wide they are and whether they lead anywhere.
#include <algorithm>

#include "layout/aisles.h"
#include "layout/rule_facts.h"

namespace marketgen::layout {
namespace {

constexpr int niche_mm = 3000;
constexpr int longest_dead_end_mm = 6100;  // NFPA 101: 20 ft
constexpr int long_aisle_mm = 3000;

std::string about(const Aisle& aisle, const std::string& what) {
  return "aisle " + aisle.id + " " + what;
}

PointMm middle(const Aisle& aisle) {
  return bounds_of(aisle.polygon_mm).center();
}

int length_of(const Aisle& aisle) {
  const RectMm rect = bounds_of(aisle.polygon_mm);
  return runs_along_x(aisle) ? rect.width() : rect.depth();
}

Findings narrower_than(const RuleFacts& facts, double limit, bool checkout, int min_length) {
  Findings found;
  for (const Aisle& aisle : facts.layout.aisles) {
    if ((aisle.kind == AisleKind::checkout) != checkout || aisle.width_mm >= limit) continue;
    if (length_of(aisle) < min_length) continue;
    found.push_back(
        {aisle.id,
         static_cast<double>(aisle.width_mm),
         limit,
         about(aisle,
               "is " + in_mm(aisle.width_mm) + " wide; at least " + in_mm(limit) + " are needed"),
         middle(aisle)});
  }
  return found;
}

// How deep the aisle's dead end is: from its shut end to the first place where one can leave it. 0
// when both ends are open.
int dead_end_depth(const Reach& reach, const Aisle& aisle) {
  const RectMm rect = bounds_of(aisle.polygon_mm);
  const bool along_x = runs_along_x(aisle);
  const Span length = along_x ? Span{rect.x0, rect.x1} : Span{rect.y0, rect.y1};
  const int ring = 2 * reach.grid.cell_mm;
  int nearest_low = length.length(), nearest_high = length.length();
  bool inside_reached = false;
  const RectMm around = rect.grown(ring);
  const navigation::OccupancyGrid& grid = reach.grid;
  const auto column_of = [&](int x) {
    return std::clamp((x - grid.bounds.x0) / grid.cell_mm, 0, grid.columns - 1);
  };
  const auto row_of = [&](int y) {
    return std::clamp((y - grid.bounds.y0) / grid.cell_mm, 0, grid.rows - 1);
  };
  for (int row = row_of(around.y0); row <= row_of(around.y1); ++row) {
    for (int column = column_of(around.x0); column <= column_of(around.x1); ++column) {
      const PointMm p = grid.center(column, row);
      const bool inside = rect.contains(p);
      if (inside && inside_reached) {  // on to the ring east of the aisle
        column = std::max(column, column_of(rect.x1) - 1);
        continue;
      }
      if (!reach.reached(grid.index(column, row))) continue;
      if (inside) {
        inside_reached = true;
        continue;
      }
      const int at = std::clamp(along_x ? p[0] : p[1], length.from, length.to);
      nearest_low = std::min(nearest_low, at - length.from);
      nearest_high = std::min(nearest_high, length.to - at);
    }
  }
  return inside_reached ? std::max(nearest_low, nearest_high) : 0;
}

Findings dead_ends(const RuleFacts& facts, int limit_mm) {
  Findings found;
  for (const Aisle& aisle : facts.layout.aisles) {
    if (aisle.kind == AisleKind::checkout || length_of(aisle) <= limit_mm) continue;
    const int depth = dead_end_depth(facts.person, aisle);
    if (depth <= limit_mm) continue;
    found.push_back({aisle.id,
                     static_cast<double>(depth),
                     static_cast<double>(limit_mm),
                     about(aisle,
                           "ends blind after " + in_mm(depth) + "; more than " + in_mm(limit_mm) +
                               " is a dead end"),
                     middle(aisle)});
  }
  return found;
}

}  // namespace

Findings aisle_too_narrow(const RuleFacts& facts) {
  return narrower_than(facts, facts.profile().minimum_aisle_mm, false, 0);
}

Findings aisle_tight(const RuleFacts& facts) {
  return narrower_than(
      facts, tight_aisle_share * facts.profile().secondary_aisle_mm, false, long_aisle_mm);
}

Findings lane_too_narrow(const RuleFacts& facts) {
  return narrower_than(facts, facts.profile().wheelchair_mm, true, 0);
}

Findings aisle_dead_end(const RuleFacts& facts) {
  return dead_ends(facts, niche_mm);
}

Findings dead_end_too_long(const RuleFacts& facts) {
  return dead_ends(facts, longest_dead_end_mm);
}

}  // namespace marketgen::layout
