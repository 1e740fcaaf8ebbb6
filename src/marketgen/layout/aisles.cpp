#include "layout/aisles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "layout/faces.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int nook_mm = 1300;        // a narrower stretch this short at an end is a nook of its own
constexpr double nook_factor = 0.8;  // how much narrower it must be
constexpr double same_share = 0.6;   // strips that cover so much of each other are one aisle
constexpr int strip_joint_mm = 1300;       // strips in line this near are one aisle
constexpr double main_length_share = 0.5;  // of the store's side
constexpr int same_end_mm = 300;           // run ends this near to a line end on it

// A strip of floor, with the side on which its fixtures stand.
struct Strip {
  std::string id;
  RectMm rect;
  bool along_x = true;
  int width_mm = 0;
  AisleKind kind = AisleKind::secondary;
};

struct Obstacle {
  RectMm rect;
  int door_swing_mm = 0;  // towards its front
  Side front = Side::south;
};

struct Sight {
  int distance_mm = open_floor_mm;  // to what stands there
  int width_mm = open_floor_mm;     // the same, less the doors that open into it
};

class Surroundings {
 public:
  Surroundings(const Design& design, const std::vector<Face>& faces)
      : floor_(&design.floor), bounds_(design.floor.bounds) {
    for (const Face& face : faces)
      obstacles_.push_back({face.rect, face.door_swing_mm, face.front});
    for (const RectMm& rect : design.floor.columns)
      obstacles_.push_back({rect, 0, Side::south});
    for (const RectMm& rect : design.floor.outside)
      obstacles_.push_back({rect, 0, Side::south});
  }

  Sight look(const RectMm& rect, Side side) const {
    const int wall = distance_beyond(rect, side, strip_beyond(bounds_, side, 1));
    Sight sight{std::min(open_floor_mm, wall), std::min(open_floor_mm, wall)};
    const RectMm ahead = strip_beyond(rect, side, open_floor_mm);
    for (const Obstacle& obstacle : obstacles_) {
      if (!marketgen::overlap(ahead, obstacle.rect)) continue;
      const int distance = distance_beyond(rect, side, obstacle.rect);
      if (distance < 0) continue;
      const int swing = obstacle.front == opposite(side) ? obstacle.door_swing_mm : 0;
      sight.distance_mm = std::min(sight.distance_mm, distance);
      sight.width_mm = std::min(sight.width_mm, distance - swing);
    }
    return sight;
  }

  bool clear(const RectMm& rect) const {
    return std::ranges::none_of(
        obstacles_, [&](const Obstacle& o) { return marketgen::overlap(o.rect, rect); });
  }

  // No floor behind the face: it stands against a wall.
  bool stands_at_wall(const Face& face) const {
    constexpr int behind_mm = 100;
    return !on_floor(*floor_, strip_beyond(face.rect, opposite(face.front), behind_mm));
  }

  // Where the view from the side changes along it.
  std::vector<Span> stretches(const RectMm& rect, Side side) const {
    const Span whole = along(rect, side);
    std::vector<int> cuts{whole.from, whole.to};
    const RectMm ahead = strip_beyond(rect, side, open_floor_mm);
    for (const Obstacle& obstacle : obstacles_) {
      if (!marketgen::overlap(ahead, obstacle.rect)) continue;
      const Span span = along(obstacle.rect, side);
      for (const int cut : {span.from, span.to}) {
        if (cut > whole.from && cut < whole.to) cuts.push_back(cut);
      }
    }
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    std::vector<Span> spans;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      spans.push_back({cuts[i], cuts[i + 1]});
    return spans;
  }

 private:
  const Floor* floor_;
  RectMm bounds_;
  std::vector<Obstacle> obstacles_;
};

// The face's span without short narrow ends; those come after it.
std::vector<Span> main_span_and_nooks(const Surroundings& around, const Face& face) {
  const std::vector<Span> parts = around.stretches(face.rect, face.front);
  std::vector<int> distance;
  for (const Span& part : parts) {
    const RectMm stretch = cut_along(face.rect, face.front, part);
    distance.push_back(around.look(stretch, face.front).distance_mm);
  }
  const Span whole{parts.front().from, parts.back().to};
  std::size_t first = 0, last = parts.size();
  while (first < last && parts[first].to <= whole.from + nook_mm)
    ++first;
  while (last > first && parts[last - 1].from >= whole.to - nook_mm)
    --last;
  if (first == last) return {whole};
  const auto begin = distance.begin();
  const int core = *std::min_element(begin + static_cast<std::ptrdiff_t>(first),
                                     begin + static_cast<std::ptrdiff_t>(last));
  // Ends that are as wide as the middle belong to it.
  while (first > 0 && distance[first - 1] >= nook_factor * core)
    --first;
  while (last < parts.size() && distance[last] >= nook_factor * core)
    ++last;
  std::vector<Span> spans{{parts[first].from, parts[last - 1].to}};
  if (first > 0) spans.push_back({whole.from, parts[first].from});
  if (last < parts.size()) spans.push_back({parts[last].from, whole.to});
  return spans;
}

void add_face_strips(std::vector<Strip>& strips, const Surroundings& around, const Face& face) {
  const std::vector<Span> spans = main_span_and_nooks(around, face);
  constexpr std::array<std::string_view, 4> names{"south", "east", "north", "west"};
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const RectMm part = cut_along(face.rect, face.front, spans[i]);
    const Sight sight = around.look(part, face.front);
    Strip strip;
    strip.id = face.run + "/aisle-" + std::string(names[index_of(face.front)]);
    if (i > 0) strip.id += "-nook-" + std::to_string(i);
    strip.rect = strip_beyond(part, face.front, sight.distance_mm);
    strip.along_x = lies_along_x(face.front);
    strip.width_mm = std::max(0, sight.width_mm - face.door_swing_mm);
    strip.kind =
        face.role == catalog::FixtureRole::checkout ? AisleKind::checkout : AisleKind::secondary;
    strips.push_back(std::move(strip));
  }
}

// The end of a free-standing run, or the endcap that closes it.
struct RunEnd {
  RectMm rect;
  Side side;
  std::string zone;
};

std::vector<RunEnd> run_ends(const Surroundings& around, const std::vector<Face>& faces) {
  std::vector<RunEnd> ends;
  for (const Face& face : faces) {
    if (face.role != catalog::FixtureRole::shelving || around.stands_at_wall(face)) continue;
    if (face.endcap) ends.push_back({face.rect, face.front, face.zone});
    if (face.endcap) continue;
    ends.push_back({face.rect, left_of(face.front), face.zone});
    ends.push_back({face.rect, opposite(left_of(face.front)), face.zone});
  }
  return ends;
}

// Run ends of one zone that lie on one line.
std::vector<std::vector<RunEnd>> end_lines(const std::vector<RunEnd>& ends) {
  std::vector<std::vector<RunEnd>> lines;
  for (const RunEnd& end : ends) {
    const auto same = std::ranges::find_if(lines, [&](const std::vector<RunEnd>& line) {
      const RunEnd& e = line.front();
      return e.zone == end.zone && e.side == end.side &&
             std::abs(coordinate(e.rect, e.side) - coordinate(end.rect, e.side)) <= same_end_mm;
    });
    if (same == lines.end()) {
      lines.push_back({end});
    } else {
      same->push_back(end);
    }
  }
  return lines;
}

RectMm bounds_of_ends(const std::vector<RunEnd>& line) {
  RectMm box = line.front().rect;
  for (const RunEnd& end : line) {
    box = bounds_of(box, end.rect);
  }
  return box;
}

// The floor beyond the ends of a zone's runs, one strip for all that end on one line, where it is
// as wide as an aisle may be.
void add_cross_strips(std::vector<Strip>& strips,
                      const Surroundings& around,
                      const std::vector<Face>& faces,
                      int min_mm) {
  std::map<std::string, int> numbers;
  for (const std::vector<RunEnd>& line : end_lines(run_ends(around, faces))) {
    const Side side = line.front().side;
    const RectMm box = bounds_of_ends(line);
    const int distance = around.look(box, side).distance_mm;
    Strip strip;
    strip.width_mm = open_floor_mm;
    for (const RunEnd& end : line) {
      strip.width_mm = std::min(strip.width_mm, around.look(end.rect, side).width_mm);
    }
    // An endcap stands there, or it is a gap that nobody needs to pass: fronts have their own
    // aisles.
    const bool closed = distance < 1 || strip.width_mm < min_mm;
    if (closed || distance >= open_floor_mm || along(box, side).length() < distance) continue;
    strip.id = line.front().zone + "/cross-" + std::to_string(++numbers[line.front().zone]);
    strip.rect = strip_beyond(box, side, distance);
    strip.along_x = lies_along_x(side);
    strip.kind = AisleKind::cross;
    strips.push_back(std::move(strip));
  }
}

// Passages between lanes that stand side by side.
void add_lane_strips(std::vector<Strip>& strips,
                     const std::vector<Fixture>& fixtures,
                     const catalog::Catalog& catalog) {
  std::vector<const Fixture*> lanes;
  for (const Fixture& fixture : fixtures) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
    if (kind != nullptr && kind->generator == "checkout_lane") lanes.push_back(&fixture);
  }
  for (const Fixture* lane : lanes) {
    const RectMm rect = footprint_of(*lane);
    const Side beside = rect.width() < rect.depth() ? Side::east : Side::north;
    const RectMm* next = nullptr;
    std::vector<RectMm> others;
    for (const Fixture* other : lanes) {
      if (other != lane && overlap(along(rect, beside), along(footprint_of(*other), beside)) &&
          distance_beyond(rect, beside, footprint_of(*other)) >= 0) {
        others.push_back(footprint_of(*other));
      }
    }
    for (const RectMm& other : others) {
      if (next == nullptr ||
          distance_beyond(rect, beside, other) < distance_beyond(rect, beside, *next))
        next = &other;
    }
    if (next == nullptr || distance_beyond(rect, beside, *next) > open_floor_mm / 2) continue;
    const int width = distance_beyond(rect, beside, *next);
    if (width <= 0) continue;
    strips.push_back({lane->id + "/passage",
                      strip_beyond(rect, beside, width),
                      beside == Side::north,
                      width,
                      AisleKind::checkout});
  }
}

Span length_span(const Strip& s) {
  return s.along_x ? Span{s.rect.x0, s.rect.x1} : Span{s.rect.y0, s.rect.y1};
}
Span width_span(const Strip& s) {
  return s.along_x ? Span{s.rect.y0, s.rect.y1} : Span{s.rect.x0, s.rect.x1};
}

bool same_floor(const Strip& a, const Strip& b) {
  const auto common = marketgen::intersection(a.rect, b.rect);
  if (!common || a.along_x != b.along_x) return false;
  const auto smaller = std::min(a.rect.area_mm2(), b.rect.area_mm2());
  return static_cast<double>(common->area_mm2()) >= same_share * static_cast<double>(smaller);
}

RectMm joined(const Strip& a, const Strip& b) {
  const Span wide = intersection(width_span(a), width_span(b));
  const Span la = length_span(a), lb = length_span(b);
  const Span length{std::min(la.from, lb.from), std::max(la.to, lb.to)};
  return a.along_x ? RectMm{length.from, wide.from, length.to, wide.to}
                   : RectMm{wide.from, length.from, wide.to, length.to};
}

bool in_line(const Strip& a, const Strip& b, const Surroundings& around) {
  if (a.along_x != b.along_x || (a.kind == AisleKind::checkout) != (b.kind == AisleKind::checkout))
    return false;
  const Span wa = width_span(a), wb = width_span(b);
  const Span common = intersection(wa, wb);
  if (common.length() < 0.8 * std::max(wa.length(), wb.length())) return false;
  const Span la = length_span(a), lb = length_span(b);
  const int apart = std::max(la.from, lb.from) - std::min(la.to, lb.to);
  return apart <= strip_joint_mm && around.clear(joined(a, b));
}

// Folds strips into those before them until no two cover or continue each other.
std::vector<Strip> merged(std::vector<Strip> strips, const Surroundings& around) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < strips.size(); ++i) {
      for (std::size_t k = i + 1; k < strips.size();) {
        Strip& a = strips[i];
        const Strip& b = strips[k];
        const bool same = same_floor(a, b) &&
                          intersection(width_span(a), width_span(b)).length() > 0 &&
                          around.clear(joined(a, b));
        if (!same && !in_line(a, b, around)) {
          ++k;
          continue;
        }
        a.rect = joined(a, b);
        a.width_mm = std::min(a.width_mm, b.width_mm);
        if (b.kind == AisleKind::cross && a.kind == AisleKind::secondary) a.kind = b.kind;
        strips.erase(strips.begin() + static_cast<std::ptrdiff_t>(k));
        changed = true;
      }
    }
  }
  return strips;
}

void name_main_aisles(std::vector<Strip>& strips, const Design& design) {
  for (Strip& strip : strips) {
    const int side = strip.along_x ? design.floor.bounds.width() : design.floor.bounds.depth();
    const bool is_long = length_span(strip).length() >= main_length_share * side;
    const bool is_wide = strip.width_mm >= design.profile.main_aisle_mm;
    if (strip.kind != AisleKind::checkout && is_long && is_wide) strip.kind = AisleKind::main;
  }
}

}  // namespace

int min_untight_aisle_mm(const Design& design) {
  const double habit_mm = tight_aisle_share * design.profile.secondary_aisle_mm;
  return std::max(design.min_aisle_mm(), static_cast<int>(std::ceil(habit_mm)));
}

bool runs_along_x(const Aisle& aisle) {
  const RectMm rect = bounds_of(aisle.polygon_mm);
  // Doors standing open make an aisle narrower than its floor, never wider.
  const int off_x = std::abs(rect.width() - aisle.width_mm);
  const int off_y = std::abs(rect.depth() - aisle.width_mm);
  return off_y < off_x || (off_y == off_x && rect.width() >= rect.depth());
}

std::vector<Aisle> find_aisles(const Design& design, const std::vector<Fixture>& fixtures) {
  const std::vector<Face> faces = faces_of(fixtures, design.catalog);
  const Surroundings around(design, faces);
  std::vector<Strip> strips;
  for (const Face& face : faces) {
    if (face.role == catalog::FixtureRole::shelving && !face.endcap)
      add_face_strips(strips, around, face);
  }
  add_cross_strips(strips, around, faces, design.profile.minimum_aisle_mm);
  strips = merged(std::move(strips), around);
  add_lane_strips(strips, fixtures, design.catalog);
  name_main_aisles(strips, design);
  std::vector<Aisle> aisles;
  for (const Strip& strip : strips) {
    if (!strip.rect.empty())
      aisles.push_back({strip.id, strip.kind, polygon_of(strip.rect), strip.width_mm});
  }
  std::ranges::sort(aisles, {}, &Aisle::id);
  return aisles;
}

}  // namespace marketgen::layout
