#include "drawing/shell_of.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "base/text.h"
#include "drawing/curves.h"

namespace marketgen::drawing {
namespace {

using plan::OpeningKind;

constexpr double degree = std::numbers::pi / 180;
constexpr double min_side_mm = 4000, max_side_mm = 200000;  // of Shell::width_mm, depth_mm
constexpr int min_opening_mm = 600, max_opening_mm = 12000;

// The direction of most of the walls, between -45 and 45 degrees.
double main_direction(const Polygon& outline) {
  struct Direction {
    double angle, length;
  };
  std::vector<Direction> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 way = outline[(i + 1) % outline.size()] - outline[i];
    double angle = std::fmod(std::atan2(way.y, way.x), 90 * degree);
    if (angle > 45 * degree) angle -= 90 * degree;
    if (angle <= -45 * degree) angle += 90 * degree;
    edges.push_back({angle, std::hypot(way.x, way.y)});
  }
  double best = 0, best_length = 0;
  for (const Direction& about : edges) {
    double length = 0, sum = 0;
    for (const Direction& edge : edges) {
      double off = edge.angle - about.angle;
      if (off > 45 * degree) off -= 90 * degree;
      if (off < -45 * degree) off += 90 * degree;
      if (std::abs(off) > 0.7 * degree) continue;
      length += edge.length;
      sum += off * edge.length;
    }
    if (length <= best_length) continue;
    best_length = length;
    best = about.angle + sum / length;
  }
  return std::abs(best) < 0.02 * degree ? 0 : best;
}

// Walls that run nearly along x or y do.
void straighten(Polygon& outline, double within_mm) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Vec2& a = outline[i];
    Vec2& b = outline[(i + 1) % outline.size()];
    const double dx = std::abs(b.x - a.x), dy = std::abs(b.y - a.y);
    if (dy <= within_mm && dy < dx / 20) a.y = b.y = (a.y + b.y) / 2;
    if (dx <= within_mm && dx < dy / 20) a.x = b.x = (a.x + b.x) / 2;
  }
}

struct Bounds {
  Vec2 low{1e18, 1e18}, high{-1e18, -1e18};
};

Bounds bounds_of(const Polygon& outline) {
  Bounds box;
  for (const Vec2& p : outline) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

PointMm rounded(Vec2 p) {
  return {static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))};
}

// Whole millimetres; what lies nearly on a side of the bounds lies on it.
PolygonMm polygon_mm(const Polygon& outline, const Bounds& box, double within_mm) {
  PolygonMm polygon;
  const PointMm size = rounded(box.high - box.low);
  for (const Vec2& corner : outline) {
    PointMm p = rounded(corner - box.low);
    for (const std::size_t axis : {0U, 1U}) {
      if (p[axis] <= within_mm) p[axis] = 0;
      if (size[axis] - p[axis] <= within_mm) p[axis] = size[axis];
    }
    if (polygon.empty() || polygon.back() != p) polygon.push_back(p);
  }
  while (polygon.size() > 1 && polygon.front() == polygon.back())
    polygon.pop_back();
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
    const std::size_t n = polygon.size();
    const bool straight =
        marketgen::turn(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]) == 0;
    if (straight)
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return polygon;
}

bool is_rectangle(const PolygonMm& polygon) {
  if (polygon.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const PointMm a = polygon[i], b = polygon[(i + 1) % 4];
    if (a[0] != b[0] && a[1] != b[1]) return false;
  }
  return true;
}

// A door or window as it will stand in the shell.
struct Placed {
  DrawnOpening drawn;
  std::optional<plan::Wall> wall;
  int begin = 0, end = 0;  // along the wall
  bool window = false;
  std::string name;
  std::optional<OpeningKind> said;

  int width() const {
    return static_cast<int>(
        std::lround(std::hypot(drawn.to[0] - drawn.from[0], drawn.to[1] - drawn.from[1])));
  }
};

std::optional<OpeningKind> kind_said(const std::string& name) {
  struct Word {
    std::string_view text;
    OpeningKind kind;
  };
  constexpr Word words[] = {{"emergency", OpeningKind::emergency},
                            {"notausgang", OpeningKind::emergency},
                            {"fire", OpeningKind::emergency},
                            {"安全出口", OpeningKind::emergency},
                            {"消防", OpeningKind::emergency},
                            {"service", OpeningKind::service},
                            {"delivery", OpeningKind::service},
                            {"dock", OpeningKind::service},
                            {"anlieferung", OpeningKind::service},
                            {"卸货", OpeningKind::service},
                            {"entrance", OpeningKind::entrance},
                            {"entry", OpeningKind::entrance},
                            {"eingang", OpeningKind::entrance},
                            {"入口", OpeningKind::entrance},
                            {"ausgang", OpeningKind::exit},
                            {"exit", OpeningKind::exit},
                            {"出口", OpeningKind::exit}};
  const std::string lower = lower_ascii(name);
  for (const Word& word : words)
    if (lower.find(word.text) != std::string::npos) return word.kind;
  return std::nullopt;
}

// The part of a side of the bounds that the opening's wall is.
struct Side {
  plan::Wall wall;
  int from, to;
};
std::optional<Side> side_at(const PolygonMm& outline,
                            const plan::Shell& shell,
                            PointMm a,
                            PointMm b) {
  constexpr int near_mm = 60;
  struct Line {
    plan::Wall wall;
    std::size_t across;
    int at;
  };
  const Line lines[] = {{plan::Wall::south, 1, 0},
                        {plan::Wall::north, 1, shell.depth_mm},
                        {plan::Wall::west, 0, 0},
                        {plan::Wall::east, 0, shell.width_mm}};
  for (const Line& line : lines) {
    if (std::abs(a[line.across] - line.at) > near_mm ||
        std::abs(b[line.across] - line.at) > near_mm)
      continue;
    const std::size_t on = 1 - line.across;
    const int middle = (a[on] + b[on]) / 2;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PointMm p = outline[i], q = outline[(i + 1) % outline.size()];
      if (p[line.across] != line.at || q[line.across] != line.at) continue;
      const auto [low, high] = std::minmax(p[on], q[on]);
      if (low <= middle && middle <= high) return Side{line.wall, low, high};
    }
  }
  return std::nullopt;
}

Placed placed(const FoundOpening& opening, const PolygonMm& outline, const plan::Shell& shell) {
  Placed one;
  one.drawn.from = rounded(opening.from);
  one.drawn.to = rounded(opening.to);
  one.window = opening.role == Role::window;
  one.name = opening.name;
  one.said = kind_said(opening.name);
  const auto side = side_at(outline, shell, one.drawn.from, one.drawn.to);
  if (!side) return one;
  const std::size_t on = side->wall == plan::Wall::south || side->wall == plan::Wall::north ? 0 : 1;
  const auto [low, high] = std::minmax(one.drawn.from[on], one.drawn.to[on]);
  one.begin = std::max(low, side->from);
  one.end = std::min({high, side->to, one.begin + max_opening_mm});
  if (one.end - one.begin >= min_opening_mm) one.wall = side->wall;
  return one;
}

// Windows and named doors are what they are called. Of the others the widest is the entrance, one
// as wide beside it the exit; what is left is for goods where it is wide, else for emergencies.
void give_kinds(std::vector<Placed>& openings) {
  constexpr int goods_mm = 1400;
  constexpr double nearly_as_wide = 0.6;
  std::vector<Placed*> doors;
  for (Placed& one : openings) {
    one.drawn.kind = one.window ? OpeningKind::window : one.said.value_or(OpeningKind::emergency);
    if (!one.window && !one.said) doors.push_back(&one);
  }
  std::ranges::stable_sort(doors, [](const Placed* a, const Placed* b) {
    const bool first = a->wall.has_value(), second = b->wall.has_value();
    return first != second ? first : a->width() > b->width() + 50;
  });
  const auto first_of = [&](OpeningKind kind) -> Placed* {
    const auto found = std::ranges::find_if(
        openings, [&](const Placed& one) { return one.wall && one.said == kind && !one.window; });
    return found == openings.end() ? nullptr : &*found;
  };
  Placed* entrance = first_of(OpeningKind::entrance);
  if (entrance == nullptr && !doors.empty()) {
    entrance = doors.front();
    entrance->drawn.kind = OpeningKind::entrance;
    doors.erase(doors.begin());
  }
  bool has_exit = first_of(OpeningKind::exit) != nullptr;
  for (Placed* door : doors) {
    const bool beside = entrance != nullptr && door->wall && door->wall == entrance->wall;
    if (beside && !has_exit && door->width() >= nearly_as_wide * entrance->width()) {
      door->drawn.kind = OpeningKind::exit;
      has_exit = true;
    } else if (door->width() >= goods_mm) {
      door->drawn.kind = OpeningKind::service;
    }
  }
}

void add_openings(FloorPlan& floor, std::vector<Placed> openings) {
  constexpr std::size_t most = 40;
  give_kinds(openings);
  std::ranges::stable_sort(
      openings, {}, [](const Placed& one) { return static_cast<int>(one.drawn.kind); });
  std::map<OpeningKind, int> count;
  std::vector<const Placed*> taken;
  for (Placed& one : openings) {
    const std::string kind(name_of(one.drawn.kind));
    const bool free = std::ranges::none_of(taken, [&](const Placed* other) {
      return other->wall == one.wall && one.begin < other->end && other->begin < one.end;
    });
    one.drawn.in_shell = one.wall.has_value() && free && taken.size() < most;
    if (one.drawn.in_shell) taken.push_back(&one);
    floor.openings.push_back(one.drawn);
    if (!one.drawn.in_shell) {
      floor.warnings.push_back(fmt::format(
          "the {} {:.1f} m wide at x {:.1f}, y {:.1f} m is left out: a plan has openings in the "
          "northern, southern, eastern and western side only, from 0.6 m on, side by side and at "
          "most {}",
          one.window ? "window" : "door",
          one.width() * 1e-3,
          (one.drawn.from[0] + one.drawn.to[0]) * 5e-4,
          (one.drawn.from[1] + one.drawn.to[1]) * 5e-4,
          most));
      continue;
    }
    const bool along_x = *one.wall == plan::Wall::south || *one.wall == plan::Wall::north;
    const int length = along_x ? floor.shell.width_mm : floor.shell.depth_mm;
    plan::Opening opening;
    const int number = ++count[one.drawn.kind];
    opening.id = number == 1 ? kind : kind + "-" + std::to_string(number);
    opening.kind = one.drawn.kind;
    opening.wall = *one.wall;
    opening.width_mm = (one.end - one.begin) / 2 * 2;  // both halves whole
    opening.center = (one.begin + opening.width_mm / 2) / static_cast<double>(length);
    floor.shell.openings.push_back(std::move(opening));
  }
}

void add_columns(FloorPlan& floor, const Found& found, const Affine& place) {
  const PolygonMm outline = floor.shell.outline_mm.value_or(PolygonMm{});
  for (const FoundColumn& one : found.columns) {
    const PointMm at = rounded(place * one.centre);
    const int size = std::clamp(static_cast<int>(std::lround(one.size_mm)), 50, 2000);
    const int half = size / 2;
    const bool inside = at[0] >= half && at[1] >= half && at[0] + half <= floor.shell.width_mm &&
                        at[1] + half <= floor.shell.depth_mm;
    if (!inside || (!outline.empty() && !marketgen::contains(outline, at))) continue;
    floor.shell.columns.push_back({at[0], at[1], size});
  }
  std::ranges::sort(floor.shell.columns, {}, [](const plan::Column& c) {
    return std::pair{c.y_mm, c.x_mm};
  });
}

}  // namespace

Result<FloorPlan> shell_of(const Found& found,
                           const Tolerance& tolerance,
                           const std::string& where) {
  const double turned = main_direction(found.outline);
  const Affine turn_back = rotated(-turned);
  Polygon outline;
  for (const Vec2& p : found.outline)
    outline.push_back(turn_back * p);
  straighten(outline, 3 * tolerance.line_mm);
  const Bounds box = bounds_of(outline);
  const double width = box.high.x - box.low.x, depth = box.high.y - box.low.y;
  if (std::min(width, depth) < min_side_mm || std::max(width, depth) > max_side_mm)
    return Error{
        "drawing.no_scale",
        where,
        fmt::format("the floor would be {:.2f} x {:.2f} m; a shop is 4 to 200 m wide and deep. "
                    "Say the scale with --floor-plan-scale: \"1 unit = 10 mm\", or \"1:100\" "
                    "for a drawing on paper",
                    width * 1e-3,
                    depth * 1e-3)};
  FloorPlan floor;
  floor.turned_deg = turned / degree;
  floor.warnings = found.warnings;
  PolygonMm polygon = polygon_mm(outline, box, 2 * tolerance.line_mm);
  floor.shell.width_mm = rounded(box.high - box.low)[0];
  floor.shell.depth_mm = rounded(box.high - box.low)[1];
  Polygon whole;
  for (const PointMm& p : polygon)
    whole.push_back({static_cast<double>(p[0]), static_cast<double>(p[1])});
  if (polygon.size() < 4 || crossing_of(whole) != nullptr)
    return Error{"drawing.bad_outline",
                 where,
                 "the floor has fewer than four corners or touches itself; draw walls that go "
                 "round it once"};
  if (!is_rectangle(polygon)) floor.shell.outline_mm = polygon;
  const Affine place = moved(-box.low.x, -box.low.y) * turn_back;
  std::vector<Placed> openings;
  for (FoundOpening opening : found.openings) {
    opening.from = place * opening.from;
    opening.to = place * opening.to;
    openings.push_back(placed(opening, polygon, floor.shell));
  }
  add_openings(floor, std::move(openings));
  add_columns(floor, found, place);
  return floor;
}

}  // namespace marketgen::drawing
