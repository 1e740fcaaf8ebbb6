#include "layout/zone_ground.h"

#include <algorithm>

#include "plan/bsp.h"

namespace marketgen::layout {
namespace {

constexpr int max_pieces = 3;
constexpr int min_side_mm = 900;    // narrower ground holds no fixture with a shopper before it
constexpr double min_piece_m2 = 3;  // further pieces must be worth a run of their own
constexpr int widest_shared_gap_mm = 3000;  // walls along wider gaps are left to the aisle

// Sorted distinct cut lines of the rectangles within [low, high].
std::vector<int> cuts(const std::vector<RectMm>& taken, Side side, Span within) {
  std::vector<int> lines{within.from, within.to};
  for (const RectMm& rect : taken) {
    const Span span = along(rect, side);
    for (const int line : {span.from, span.to}) {
      if (line > within.from && line < within.to) lines.push_back(line);
    }
  }
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

// The largest rectangle within `rect` that overlaps none of `taken`.
RectMm largest_free(const RectMm& rect, const std::vector<RectMm>& taken) {
  std::vector<RectMm> near;
  for (const RectMm& t : taken) {
    if (marketgen::overlap(t, rect)) near.push_back(t);
  }
  if (near.empty()) return rect;
  const std::vector<int> ys = cuts(near, Side::west, {rect.y0, rect.y1});
  RectMm best{};
  for (std::size_t low = 0; low < ys.size(); ++low) {
    for (std::size_t high = low + 1; high < ys.size(); ++high) {
      const RectMm slab{rect.x0, ys[low], rect.x1, ys[high]};
      std::vector<Span> blocked;
      for (const RectMm& t : near) {
        if (marketgen::overlap(t, slab)) blocked.push_back({t.x0, t.x1});
      }
      for (const Span& open : without({rect.x0, rect.x1}, blocked)) {
        const RectMm candidate{open.from, slab.y0, open.to, slab.y1};
        if (candidate.area_mm2() > best.area_mm2()) best = candidate;
      }
    }
  }
  return best;
}

std::vector<RectMm> pieces_of(const RectMm& zone, const Floor& floor) {
  std::vector<RectMm> pieces;
  std::vector<RectMm> taken = floor.outside;
  for (int i = 0; i < max_pieces; ++i) {
    const RectMm piece = largest_free(zone, taken);
    if (std::min(piece.width(), piece.depth()) < min_side_mm) break;
    if (i > 0 && piece.area_m2() < min_piece_m2) break;
    pieces.push_back(piece);
    taken.push_back(piece);
  }
  return pieces;
}

int gap_beyond(const std::vector<Ground>& grounds,
               const Floor& floor,
               const Ground& ground,
               Side side) {
  int gap = distance_beyond(ground.rect, side, strip_beyond(floor.bounds, side, 1));
  const auto consider = [&](const RectMm& other) {
    const int distance = distance_beyond(ground.rect, side, other);
    const bool beside = overlap(along(ground.rect, side), along(other, side));
    if (beside && distance >= 0) gap = std::min(gap, distance);
  };
  for (const Ground& other : grounds) {
    if (&other != &ground) consider(other.rect);
  }
  for (const RectMm& gone : floor.outside)
    consider(gone);
  return gap;
}

// A wall run may reach over half of the gap to the next zone: no wall is wasted where an aisle
// meets it.
int share_of_gap(int gap_mm) {
  return gap_mm <= widest_shared_gap_mm ? gap_mm / 2 : 0;
}

void find_walls(Ground& ground, const Floor& floor) {
  for (const Side side : all_sides) {
    const bool x = lies_along_x(side);
    const int low = ground.gap_mm[index_of(x ? Side::west : Side::south)];
    const int high = ground.gap_mm[index_of(x ? Side::east : Side::north)];
    ground.walls[index_of(side)] =
        wall_spans(floor, ground.rect, side, {share_of_gap(low), share_of_gap(high)});
  }
}

// One pass of Sutherland-Hodgman: what lies on the inner side of the rectangle's side.
PolygonMm clipped(const PolygonMm& polygon, const RectMm& rect, Side side) {
  const int line = coordinate(rect, side);
  const std::size_t axis = lies_along_x(side) ? 1 : 0;
  const bool keep_low = side == Side::north || side == Side::east;
  const auto inside = [&](const PointMm& p) {
    return keep_low ? p[axis] <= line : p[axis] >= line;
  };
  PolygonMm kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointMm& a = polygon[i];
    const PointMm& b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) kept.push_back(a);
    if (inside(a) == inside(b)) continue;
    PointMm cut{};
    cut[axis] = line;
    cut[1 - axis] = static_cast<int>(a[1 - axis] + std::int64_t{b[1 - axis] - a[1 - axis]} *
                                                       (line - a[axis]) / (b[axis] - a[axis]));
    kept.push_back(cut);
  }
  return kept;
}

}  // namespace

std::vector<Ground> zone_grounds(const plan::Plan& plan, const Floor& floor) {
  std::vector<Ground> grounds;
  const std::vector<RectMm> rectangles = plan::zone_rectangles(plan);
  for (std::size_t zone = 0; zone < rectangles.size(); ++zone) {
    for (const RectMm& piece : pieces_of(rectangles[zone], floor)) {
      Ground ground;
      ground.zone = zone;
      ground.rect = piece;
      grounds.push_back(ground);
    }
  }
  for (Ground& ground : grounds) {
    for (const Side side : all_sides) {
      ground.gap_mm[index_of(side)] = gap_beyond(grounds, floor, ground, side);
    }
  }
  for (Ground& ground : grounds)
    find_walls(ground, floor);
  return grounds;
}

PolygonMm zone_polygon(const RectMm& rect, const Floor& floor) {
  if (on_floor(floor, rect)) return polygon_of(rect);
  PolygonMm polygon = floor.outline;
  for (const Side side : all_sides)
    polygon = clipped(polygon, rect, side);
  const auto repeated = std::unique(polygon.begin(), polygon.end());
  polygon.erase(repeated, polygon.end());
  if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  return polygon;
}

std::vector<LayoutZone> layout_zones(const Design& design) {
  std::vector<LayoutZone> zones;
  const std::vector<RectMm> rectangles = plan::zone_rectangles(design.plan);
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const plan::Zone& zone = design.plan.zones[i];
    const catalog::ZoneTypeRow* type = design.catalog.zone_type(zone.type);
    const std::string label = zone.label.empty() && type != nullptr ? type->label : zone.label;
    const PolygonMm polygon = zone_polygon(rectangles[i], design.floor);
    zones.push_back({zone.id, zone.type, label, polygon, area_m2(polygon)});
  }
  return zones;
}

}  // namespace marketgen::layout
