#include "intake/drawn_tills.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/rectangle.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

constexpr double till_part = 0.5;  // of a zone
// What is better: shares of the floor's longer side, of the drawn floor and of the lanes wanted.
constexpr double away_weight = 1.5, lost_weight = 1.5, missing_weight = 0.5;

// The largest rectangle of squares that nothing is drawn on.
RectMm largest_bare(const drawing::ZoneMap& map) {
  RectMm best{0, 0, 0, 0};
  std::vector<int> height(static_cast<std::size_t>(map.columns) + 1);
  for (int y = 0; y < map.rows; ++y) {
    std::vector<int> open;  // columns whose rectangles still grow, the lowest first
    for (int x = 0; x <= map.columns; ++x) {
      int& here = height[static_cast<std::size_t>(x)];
      here = x < map.columns && map.at(x, y) == drawing::ZoneMap::bare ? here + 1 : 0;
      while (!open.empty() && height[static_cast<std::size_t>(open.back())] >= here) {
        const int tall = height[static_cast<std::size_t>(open.back())];
        open.pop_back();
        const RectMm rect{open.empty() ? 0 : open.back() + 1, y + 1 - tall, x, y + 1};
        if (rect.area_m2() > best.area_m2()) best = rect;
      }
      open.push_back(x);
    }
  }
  return best;
}

class TillPlacer {
 public:
  TillPlacer(const drawing::ZoneMap& map,
             const StoreProgram& program,
             std::size_t tills,
             PointMm door,
             bool lanes_asked)
      : map_(map), program_(program), tills_(tills), door_(door), lanes_asked_(lanes_asked) {}

  std::optional<TillPlace> run() {
    for (std::size_t i = 0; i < program_.zones.size(); ++i)
      if (program_.zones[i].stance != Stance::front)
        try_ends(bounds_of(static_cast<int>(i)), static_cast<int>(i), till_part);
    try_ends(largest_bare(map_), drawing::ZoneMap::bare, 1);
    return best_;
  }

 private:
  RectMm bounds_of(int zone) const {
    RectMm box{map_.columns, map_.rows, 0, 0};
    for (int y = 0; y < map_.rows; ++y) {
      for (int x = 0; x < map_.columns; ++x) {
        if (map_.at(x, y) != zone) continue;
        box = {std::min(box.x0, x),
               std::min(box.y0, y),
               std::max(box.x1, x + 1),
               std::max(box.y1, y + 1)};
      }
    }
    return box.x1 > box.x0 ? box : RectMm{0, 0, 0, 0};
  }

  int squares_of(double mm) const {
    return static_cast<int>(std::ceil(mm * map_.columns / program_.width_mm));
  }

  // How much of a side a strip for so many lanes takes, when it is as long as `across`; nothing
  // when it has no room.
  std::optional<int> along_for(int lanes, int across) const {
    ProgramZone zone = program_.zones[tills_];
    zone.count = lanes;
    const int deep = squares_of(usual_front_mm);
    const int wide = squares_of(till_width_mm(zone, usual_front_mm));
    std::optional<int> best;
    for (const auto& [side, other] : {std::pair{wide, deep}, std::pair{deep, wide}})
      if (side <= across && (!best || other < *best)) best = other;
    return best;
  }

  void try_ends(const RectMm& box, int giver, double part) {
    if (box.x1 <= box.x0) return;
    const int wanted = program_.zones[tills_].count.value_or(1);
    for (int lanes = wanted; lanes >= (lanes_asked_ ? wanted : 1); --lanes) {
      for (const bool cut_x : {true, false}) {
        const int across = cut_x ? box.depth() : box.width();
        const int along = cut_x ? box.width() : box.depth();
        const auto taken = along_for(lanes, across);
        if (!taken || *taken > part * along) continue;
        RectMm low = box, high = box;
        (cut_x ? low.x1 : low.y1) = (cut_x ? box.x0 : box.y0) + *taken;
        (cut_x ? high.x0 : high.y0) = (cut_x ? box.x1 : box.y1) - *taken;
        judge({low, giver, lanes}, wanted);
        judge({high, giver, lanes}, wanted);
      }
    }
  }

  void judge(const TillPlace& place, int wanted) {
    const double longer = std::max(map_.columns, map_.rows);
    const double away = geometry::distance_mm(place.squares, geometry::point_rect(door_)) / longer;
    const double lost = place.giver == drawing::ZoneMap::bare
                            ? 0
                            : 1.0 * place.squares.width() * place.squares.depth() /
                                  (1.0 * map_.columns * map_.rows);
    const double missing = 1.0 * (wanted - place.lanes) / wanted;
    const double cost = away_weight * away + lost_weight * lost + missing_weight * missing;
    if (best_ && cost >= best_cost_) return;
    best_ = place;
    best_cost_ = cost;
  }

  const drawing::ZoneMap& map_;
  const StoreProgram& program_;
  std::size_t tills_;
  PointMm door_;
  bool lanes_asked_;
  std::optional<TillPlace> best_;
  double best_cost_ = 0;
};

}  // namespace

std::optional<TillPlace> place_for_tills(const drawing::ZoneMap& map,
                                         const StoreProgram& program,
                                         std::size_t tills,
                                         PointMm door,
                                         bool lanes_asked) {
  return TillPlacer(map, program, tills, door, lanes_asked).run();
}

}  // namespace marketgen::intake
