#include "intake/fit_slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

constexpr double min_share = 0.085;  // of a side of a cut: near what nodes of plans allow
constexpr int min_gap_mm = 400;      // less bare floor is a drawn line
constexpr int branching_cuts = 3;    // so far from the root, several cuts are tried
constexpr std::size_t tried_cuts = 4;

struct Cells {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

// How many squares of each zone, and of bare floor, a rectangle of the map has.
class Counts {
 public:
  Counts(const drawing::ZoneMap& map, std::size_t zones)
      : columns_(map.columns), rows_(map.rows), bare_(zones), sums_(zones + 1) {
    for (std::vector<int>& sums : sums_)
      sums.assign(static_cast<std::size_t>(columns_ + 1) * (rows_ + 1), 0);
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        const int zone = map.at(x, y);
        for (std::size_t z = 0; z < sums_.size(); ++z) {
          const bool here = zone >= 0 ? static_cast<std::size_t>(zone) == z
                                      : z == bare_ && zone == drawing::ZoneMap::bare;
          std::vector<int>& sums = sums_[z];
          sums[at(x + 1, y + 1)] =
              sums[at(x, y + 1)] + sums[at(x + 1, y)] - sums[at(x, y)] + (here ? 1 : 0);
        }
      }
    }
  }

  int of(std::size_t zone, const Cells& r) const {
    const std::vector<int>& sums = sums_[zone];
    return sums[at(r.x1, r.y1)] - sums[at(r.x0, r.y1)] - sums[at(r.x1, r.y0)] +
           sums[at(r.x0, r.y0)];
  }
  int bare(const Cells& r) const { return of(bare_, r); }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * (columns_ + 1) + static_cast<std::size_t>(x);
  }

  int columns_, rows_;
  std::size_t bare_;
  std::vector<std::vector<int>> sums_;
};

struct Cut {
  plan::Axis axis = plan::Axis::x;
  int at = 0;         // the first square of the second side
  int misplaced = 0;  // squares on the wrong side
  int balance = 0;    // squares by which it is off the middle
  std::vector<std::size_t> first, second;
};

struct Fit {
  Slice slice;
  int misplaced = 0;
};

class Fitter {
 public:
  Fitter(const drawing::ZoneMap& map, std::size_t zones, int width_mm, int depth_mm)
      : counts_(map, zones),
        mm_x_(static_cast<double>(width_mm) / map.columns),
        mm_y_(static_cast<double>(depth_mm) / map.rows) {}

  const Counts& counts() const { return counts_; }

  Fit fit(const Cells& room, const std::vector<std::size_t>& zones, int depth) const {
    if (zones.size() == 1) return {zone_slice(static_cast<int>(zones[0])), 0};
    const std::vector<Cut> cuts = best_cuts(room, zones);
    const bool branching = depth < branching_cuts && cuts.front().misplaced > 0;
    std::optional<Fit> best;
    for (std::size_t i = 0; i < (branching ? cuts.size() : 1); ++i) {
      if (best && cuts[i].misplaced >= best->misplaced) break;
      Fit made = cut(room, cuts[i], depth);
      if (!best || made.misplaced < best->misplaced) best = std::move(made);
    }
    return std::move(*best);
  }

 private:
  static Cells part(const Cells& room, plan::Axis axis, int from, int to) {
    return axis == plan::Axis::x ? Cells{from, room.y0, to, room.y1}
                                 : Cells{room.x0, from, room.x1, to};
  }
  static std::array<int, 2> ends(const Cells& room, plan::Axis axis) {
    return axis == plan::Axis::x ? std::array{room.x0, room.x1} : std::array{room.y0, room.y1};
  }
  int mm(plan::Axis axis, int square) const {
    return static_cast<int>(std::lround(square * (axis == plan::Axis::x ? mm_x_ : mm_y_)));
  }

  // Each zone goes to the side on which it has more squares; a side without one takes the zone
  // that loses least by it.
  Cut cut_at(const Cells& room,
             const std::vector<std::size_t>& zones,
             plan::Axis axis,
             int at) const {
    const auto [from, to] = ends(room, axis);
    Cut cut{axis, at, 0, std::abs(from + to - 2 * at), {}, {}};
    const Cells low = part(room, axis, from, at), high = part(room, axis, at, to);
    int least = std::numeric_limits<int>::max();
    std::size_t loser = 0;
    for (const std::size_t zone : zones) {
      const int a = counts_.of(zone, low), b = counts_.of(zone, high);
      (a > b ? cut.first : cut.second).push_back(zone);
      cut.misplaced += std::min(a, b);
      if (std::abs(a - b) >= least) continue;
      least = std::abs(a - b);
      loser = zone;
    }
    if (!cut.first.empty() && !cut.second.empty()) return cut;
    std::erase(cut.first, loser);
    std::erase(cut.second, loser);
    (cut.first.empty() ? cut.first : cut.second).push_back(loser);
    cut.misplaced += least;
    return cut;
  }

  // The best cuts of the room, no two of them of the same axis and the same sides; never none.
  std::vector<Cut> best_cuts(const Cells& room, const std::vector<std::size_t>& zones) const {
    std::vector<Cut> cuts;
    for (const plan::Axis axis : {plan::Axis::x, plan::Axis::y}) {
      const auto [from, to] = ends(room, axis);
      const int margin = std::max(1, static_cast<int>(std::ceil((to - from) * min_share)));
      for (int at = from + margin; at <= to - margin; ++at)
        cuts.push_back(cut_at(room, zones, axis, at));
      if (to - from > 1 && to - from < 2 * margin)
        cuts.push_back(cut_at(room, zones, axis, (from + to) / 2));
    }
    if (cuts.empty()) cuts.push_back(cut_at(room, zones, plan::Axis::x, room.x1));
    std::ranges::stable_sort(cuts, [](const Cut& a, const Cut& b) {
      return std::pair{a.misplaced, a.balance} < std::pair{b.misplaced, b.balance};
    });
    std::vector<Cut> best;
    for (Cut& cut : cuts) {
      const auto same = [&](const Cut& known) {
        return known.axis == cut.axis && known.first == cut.first;
      };
      if (std::ranges::any_of(best, same)) continue;
      best.push_back(std::move(cut));
      if (best.size() == tried_cuts) break;
    }
    return best;
  }

  // Where one side of a cut ends: it leaves squares to the gap while more of them are bare than
  // its own. `step` leads from the cut into the side.
  int trimmed(const Cells& room,
              const Cut& cut,
              const std::vector<std::size_t>& zones,
              int step,
              int last) const {
    int best = cut.at, gain = 0, best_gain = 0;
    for (int at = cut.at; at != last; at += step) {
      const Cells line = part(room, cut.axis, std::min(at, at + step), std::max(at, at + step));
      gain += counts_.bare(line);
      for (const std::size_t zone : zones)
        gain -= counts_.of(zone, line);
      if (gain <= best_gain) continue;
      best_gain = gain;
      best = at + step;
    }
    return best;
  }

  Fit cut(const Cells& room, const Cut& cut, int depth) const {
    const auto [from, to] = ends(room, cut.axis);
    const int margin = static_cast<int>((to - from) * min_share);
    int a = trimmed(room, cut, cut.first, -1, std::min(cut.at, from + margin));
    int b = trimmed(room, cut, cut.second, 1, std::max(cut.at, to - margin));
    if (mm(cut.axis, b) - mm(cut.axis, a) < min_gap_mm) a = b = cut.at;
    while (mm(cut.axis, b) - mm(cut.axis, a) > plan::max_gap_mm)
      (b - cut.at > cut.at - a) ? --b : ++a;
    Fit first = fit(part(room, cut.axis, from, a), cut.first, depth + 1);
    Fit second = fit(part(room, cut.axis, b, to), cut.second, depth + 1);
    Fit made{cut_slice(cut.axis), cut.misplaced + first.misplaced + second.misplaced};
    made.slice.add(std::move(first.slice), mm(cut.axis, a) - mm(cut.axis, from), 0);
    made.slice.add(std::move(second.slice),
                   mm(cut.axis, to) - mm(cut.axis, b),
                   mm(cut.axis, b) - mm(cut.axis, a));
    return made;
  }

  Counts counts_;
  double mm_x_, mm_y_;
};

}  // namespace

FittedSlices fit_slices(const drawing::ZoneMap& map,
                        std::size_t zones,
                        int width_mm,
                        int depth_mm) {
  const Fitter fitter(map, zones, width_mm, depth_mm);
  const Cells all{0, 0, map.columns, map.rows};
  std::vector<std::size_t> there;
  for (std::size_t zone = 0; zone < zones; ++zone)
    if (fitter.counts().of(zone, all) > 0) there.push_back(zone);
  FittedSlices fitted;
  fitted.root = fitter.fit(all, there, 0).slice;
  fitted.rects = zone_rects(fitted.root, {0, 0, width_mm, depth_mm}, zones);
  fitted.iou = micro_iou(map, fitted.rects, width_mm, depth_mm);
  return fitted;
}

double micro_iou(const drawing::ZoneMap& map,
                 const std::vector<RectMm>& rects,
                 int width_mm,
                 int depth_mm) {
  std::int64_t same = 0, either = 0;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.columns; ++x) {
      const double px = (x + 0.5) * width_mm / map.columns, py = (y + 0.5) * depth_mm / map.rows;
      const int drawn = map.at(x, y);
      if (drawn == drawing::ZoneMap::outside) continue;
      bool met = false;
      int built = 0;
      for (std::size_t zone = 0; zone < rects.size(); ++zone) {
        const RectMm& r = rects[zone];
        if (px < r.x0 || px >= r.x1 || py < r.y0 || py >= r.y1) continue;
        ++built;
        met = met || drawn == static_cast<int>(zone);
      }
      same += met ? 1 : 0;
      either += built + (drawn >= 0 && !met ? 1 : 0);
    }
  }
  return either > 0 ? static_cast<double>(same) / static_cast<double>(either) : 0;
}

}  // namespace marketgen::intake
