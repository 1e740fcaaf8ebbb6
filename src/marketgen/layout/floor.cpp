#include "layout/floor.h"

#include <algorithm>

#include "base/text.h"
#include "plan/bsp.h"
#include "plan/floor_places.h"

namespace marketgen::layout {
namespace {

constexpr int slab_mm = 250;  // slanted walls are stepped this finely

// Heights at which the floor's cross-section is taken: corners, and steps along slanted walls.
std::vector<int> slab_heights(const PolygonMm& outline) {
  std::vector<int> heights;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PointMm& a = outline[i];
    const PointMm& b = outline[(i + 1) % outline.size()];
    heights.push_back(a[1]);
    if (a[0] == b[0] || a[1] == b[1]) continue;
    for (int y = std::min(a[1], b[1]); y < std::max(a[1], b[1]); y += slab_mm)
      heights.push_back(y);
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

// Stretches of x that are floor at every height between y0 and y1. No corner lies strictly between
// the two.
std::vector<Span> floor_spans(const PolygonMm& outline, int y0, int y1) {
  struct Crossing {
    int low, high;  // of the wall within the slab
  };
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PointMm& a = outline[i];
    const PointMm& b = outline[(i + 1) % outline.size()];
    if (std::min(a[1], b[1]) > y0 || std::max(a[1], b[1]) < y1 || a[1] == b[1]) continue;
    const auto x_at = [&](int y) {
      return static_cast<int>(a[0] + std::int64_t{b[0] - a[0]} * (y - a[1]) / (b[1] - a[1]));
    };
    crossings.push_back({std::min(x_at(y0), x_at(y1)), std::max(x_at(y0), x_at(y1))});
  }
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return c.low + c.high; });
  std::vector<Span> spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i].high < crossings[i + 1].low) {
      spans.push_back({crossings[i].high, crossings[i + 1].low});
    }
  }
  return spans;
}

std::vector<RectMm> outside_of(const PolygonMm& outline, const RectMm& bounds) {
  std::vector<RectMm> outside;
  std::vector<int> heights = slab_heights(outline);
  heights.insert(heights.begin(), bounds.y0);
  heights.push_back(bounds.y1);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const int y0 = heights[i], y1 = heights[i + 1];
    if (y0 >= y1) continue;
    const std::vector<Span> floor = floor_spans(outline, y0, y1);
    for (const Span& gap : without({bounds.x0, bounds.x1}, floor)) {
      outside.push_back({gap.from, y0, gap.to, y1});
    }
  }
  return outside;
}

// How many rectangles outside_of() makes at most: between two heights, each wall ends one.
std::size_t pieces_outside(const PolygonMm& outline, const RectMm& bounds) {
  std::vector<int> heights = slab_heights(outline);
  heights.insert(heights.begin(), bounds.y0);
  heights.push_back(bounds.y1);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const PointMm& a = outline[i];
    const PointMm& b = outline[(i + 1) % outline.size()];
    const auto first = std::ranges::lower_bound(heights, std::min(a[1], b[1]));
    const auto last = std::ranges::lower_bound(heights, std::max(a[1], b[1]));
    crossings += static_cast<std::size_t>(last - first);
  }
  return crossings / 2 + heights.size();
}

Doorway make_doorway(const plan::Shell& shell, const RectMm& bounds, std::size_t index) {
  const plan::Opening& opening = shell.openings[index];
  Doorway door{index, side_of(opening.wall), {}, {}, {}};
  const Span wall = along(bounds, door.wall);
  door.threshold = plan::point_inside(bounds, opening, 0);
  const int middle = door.threshold[lies_along_x(door.wall) ? 0 : 1];
  door.span = {middle - opening.width_mm / 2, middle - opening.width_mm / 2 + opening.width_mm};
  if (opening.kind == plan::OpeningKind::window) return door;
  const Span wide =
      intersection({door.span.from - approach_side_mm, door.span.to + approach_side_mm}, wall);
  const int deep = std::min(approach_depth_mm, across(bounds, door.wall).length() / 3);
  door.approach = cut_along(strip_inside(bounds, door.wall, deep), door.wall, wide);
  return door;
}

const Doorway* first_of_kind(const Floor& floor, const plan::Shell& shell, plan::OpeningKind kind) {
  const auto found = std::ranges::find_if(floor.doorways, [&](const Doorway& door) {
    return shell.openings[door.opening].kind == kind;
  });
  return found == floor.doorways.end() ? nullptr : &*found;
}

}  // namespace

Floor make_floor(const plan::Shell& shell) {
  Floor floor;
  floor.bounds = plan::shell_rect(shell);
  floor.outline = shell.outline_mm.value_or(polygon_of(floor.bounds));
  if (shell.outline_mm) floor.outside = outside_of(floor.outline, floor.bounds);
  for (const plan::Column& column : shell.columns)
    floor.columns.push_back(plan::footprint_of(column));
  for (std::size_t i = 0; i < shell.openings.size(); ++i) {
    floor.doorways.push_back(make_doorway(shell, floor.bounds, i));
  }
  return floor;
}

Result<void> check_floor(const plan::Shell& shell) {
  if (!shell.outline_mm) return {};
  const std::size_t pieces = pieces_outside(*shell.outline_mm, plan::shell_rect(shell));
  if (pieces <= max_pieces_outside) return {};
  return Error{"plan.bad_shell",
               "/shell/outline_mm",
               "its slanted walls cut the ground into " +
                   with_thousands(static_cast<std::int64_t>(pieces)) + " pieces; at most " +
                   with_thousands(static_cast<std::int64_t>(max_pieces_outside)) +
                   " are laid out: use fewer corners, or walls that run along x and y"};
}

std::vector<Span> wall_spans(
    const Floor& floor, const RectMm& rect, Side side, Span more, int reach_mm) {
  const Span line = along(rect, side);
  const Span whole =
      intersection({line.from - more.from, line.to + more.to}, along(floor.bounds, side));
  const int from_edge = distance_beyond(rect, side, strip_beyond(floor.bounds, side, 1));
  if (from_edge <= reach_mm) return {whole};
  const RectMm behind = cut_along(strip_beyond(rect, side, reach_mm), side, whole);
  std::vector<Span> open{whole};
  for (const RectMm& gone : floor.outside) {
    if (!marketgen::overlap(behind, gone)) continue;
    std::vector<Span> left;
    for (const Span& span : open) {
      for (const Span& piece : without(span, {along(gone, side)}))
        left.push_back(piece);
    }
    open = left;
  }
  return without(whole, open);
}

bool on_floor(const Floor& floor, const RectMm& rect) {
  return floor.bounds.contains(rect) && std::ranges::none_of(floor.outside, [&](const RectMm& r) {
           return marketgen::overlap(r, rect);
         });
}

const Doorway* entrance_of(const Floor& floor, const plan::Shell& shell) {
  const Doorway* door = first_of_kind(floor, shell, plan::OpeningKind::entrance);
  return door != nullptr ? door : first_of_kind(floor, shell, plan::OpeningKind::exit);
}

const Doorway* exit_of(const Floor& floor, const plan::Shell& shell) {
  const Doorway* door = first_of_kind(floor, shell, plan::OpeningKind::exit);
  return door != nullptr ? door : first_of_kind(floor, shell, plan::OpeningKind::entrance);
}

}  // namespace marketgen::layout
