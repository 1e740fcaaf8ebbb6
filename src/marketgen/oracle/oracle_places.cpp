#include "oracle/oracle_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/box_extents.h"
#include "skills/held_product.h"

namespace marketgen {
namespace {

constexpr double pi_ = std::numbers::pi;
constexpr int yaws = 24, rolls = 12;
constexpr double steepest_deg = 62;  // tilt of the tool when it lets go
constexpr double edge_m = 0.006;     // to the edge of the area
constexpr double apart_m = 0.012;    // to what stands there
constexpr double grid_m = 0.035;
constexpr double over_counter_m = 0.003;  // of the tool
constexpr double off_walls_m = 0.012;     // of the tool to the basket's walls, outside
constexpr double down_m = 0.08;
constexpr double round_within_m = 0.002;
constexpr double keep_off_basket_m = 0.03, keep_off_area_m = 0.02;

struct Extents {
  Vec3 low, high;  // from the item's origin, station axes
};

// Of the item when it is turned so; exact.
Extents turned_extents(const CheckoutGoods& goods, const Quaternion& turned) {
  const TurnedBox box = turned_box(goods.body, {{}, turned});
  return {box.middle - box.half, box.middle + box.half};
}

// The turn that brings a direction of the product to point straight down.
Quaternion with_down(Vec3 axis) {
  const Vec3 down{0, 0, -1};
  const double cosine = dot(axis, down);
  if (cosine < -1 + 1e-9) return rotation_about({1, 0, 0}, pi_);
  if (cosine > 1 - 1e-9) return {};
  return rotation_about(normalized(cross(axis, down)), std::acos(cosine));
}

// Ways round in which it stays, but for the yaw.
std::vector<Quaternion> stable_turns(const CheckoutGoods& goods, const Quaternion& now) {
  std::vector<Quaternion> turns;
  for (const Vec3 down : {Vec3{0, 0, -1},
                          Vec3{0, 0, 1},
                          Vec3{1, 0, 0},
                          Vec3{-1, 0, 0},
                          Vec3{0, 1, 0},
                          Vec3{0, -1, 0}})
    turns.push_back(with_down(down));
  const Product& p = goods.product;
  const bool round = std::abs(p.width_m() - p.depth_m()) < round_within_m && p.archetype != "box";
  for (int i = 0; round && i < rolls; ++i) {
    const double angle = 2 * pi_ * (i + 0.5) / rolls;
    turns.push_back(with_down({std::cos(angle), std::sin(angle), 0}));
  }
  if (p.orientation == Orientation::any) turns.push_back(now);
  return turns;
}

struct Turn {
  Quaternion item;
  double cost = 0;
};

class PlaceSearch {
 public:
  PlaceSearch(const OracleScene& scene, const ArmExecutor& arm, const PlaceQuestion& question)
      : scene_(scene), arm_(arm), q_(question), item_from_tip_(inverse(question.tip_from_item)) {
    for (std::size_t other = 0; other < scene.items(); ++other) {
      if (other == question.item || scene.in_basket(other)) continue;
      const Pose pose = scene.world().item_pose(other);
      const Extents e = turned_extents(scene.world().goods(other), pose.rotation);
      taken_.push_back({pose.position + e.low, pose.position + e.high});
      others_.push_back(other);
    }
  }

  std::vector<PlaceChoice> find(std::size_t most) const {
    std::vector<PlaceChoice> found;
    for (const Turn& turn : turns()) {
      const std::size_t before = found.size();
      for (const Pose& pose : poses(turn.item)) {
        if (found.size() >= most) return found;
        if (found.size() - before >= 2) break;  // of one way round
        const PlaceChoice choice = choice_of(pose);
        if (tool_has_room(choice) && arm_.effort_to(choice.station_from_tip) &&
            arm_.effort_to(above(choice.station_from_tip)))
          found.push_back(choice);
      }
    }
    return found;
  }

 private:
  static Pose above(Pose tip) {
    tip.position.z += down_m;
    return tip;
  }

  PlaceChoice choice_of(const Pose& pose) const {
    const Pose tip = pose * item_from_tip_;
    return {pose, tip, rotate(inverse(tip.rotation), {0, 0, -down_m})};
  }

  // The tool straight down and the item low and wide come first.
  std::vector<Turn> turns() const {
    std::vector<Turn> turns;
    const CheckoutGoods& goods = scene_.world().goods(q_.item);
    const Quaternion now = scene_.world().item_pose(q_.item).rotation;
    for (const Quaternion& stable : stable_turns(goods, now)) {
      const Extents e = turned_extents(goods, stable);
      const Vec3 size = e.high - e.low;
      const double slender = size.z / std::min(size.x, size.y);
      for (int yaw = 0; yaw < yaws; ++yaw) {
        const Quaternion item = rotation_about({0, 0, 1}, 2 * pi_ * yaw / yaws) * stable;
        const double tilt = tilt_deg(item * item_from_tip_.rotation);
        if (tilt <= steepest_deg) turns.push_back({item, tilt + 15 * std::max(0.0, slender - 1)});
      }
    }
    std::ranges::stable_sort(turns, {}, &Turn::cost);
    return turns;
  }

  bool is_free(const AreaRow& footprint) const {
    for (const AreaRow& kept : q_.kept_free) {
      if (overlaps(footprint, kept, 0)) return false;
    }
    return std::ranges::none_of(taken_, [&](const Extents& e) {
      return overlaps(footprint, {{e.low.x, e.low.y}, {e.high.x, e.high.y}, {}}, apart_m);
    });
  }

  static bool overlaps(const AreaRow& a, const AreaRow& b, double gap) {
    return a.low_m[0] < b.high_m[0] + gap && b.low_m[0] < a.high_m[0] + gap &&
           a.low_m[1] < b.high_m[1] + gap && b.low_m[1] < a.high_m[1] + gap;
  }

  double nearest_taken(double x, double y) const {
    double nearest = 0.3;
    for (const Extents& e : taken_)
      nearest =
          std::min(nearest, std::hypot((e.low.x + e.high.x) / 2 - x, (e.low.y + e.high.y) / 2 - y));
    return nearest;
  }

  // Free places of the item turned so, the roomiest first, then those near the middle.
  std::vector<Pose> poses(const Quaternion& turned) const {
    const Extents e = turned_extents(scene_.world().goods(q_.item), turned);
    std::vector<std::pair<double, Pose>> ranked;
    const AreaRow& area = q_.area;
    for (double x = area.low_m[0] + edge_m - e.low.x; x <= area.high_m[0] - edge_m - e.high.x;
         x += grid_m) {
      for (double y = area.low_m[1] + edge_m - e.low.y; y <= area.high_m[1] - edge_m - e.high.y;
           y += grid_m) {
        if (!is_free({{x + e.low.x, y + e.low.y}, {x + e.high.x, y + e.high.y}, {}})) continue;
        const double away = std::hypot(x - (area.low_m[0] + area.high_m[0]) / 2,
                                       y - (area.low_m[1] + area.high_m[1]) / 2);
        ranked.push_back({away - 2 * nearest_taken(x, y), {{x, y, release_m - e.low.z}, turned}});
      }
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<Pose> poses;
    constexpr std::size_t most_tried = 12;
    for (std::size_t i = 0; i < std::min(ranked.size(), most_tried); ++i)
      poses.push_back(ranked[i].second);
    return poses;
  }

  bool tool_has_room(const PlaceChoice& choice) const {
    if (scene_.tool_meets_basket(choice.station_from_tip, q_.opening_m, off_walls_m)) return false;
    for (const ToolSolid& solid : scene_.tool_solids(q_.opening_m)) {
      const Pose pose = choice.station_from_tip * solid.tool_from_solid;
      if (pose.position.z - box_half_extents(pose.rotation, solid.half_size).z < over_counter_m)
        return false;
    }
    return std::ranges::none_of(others_, [&](std::size_t other) {
      return scene_.tool_overlap(other, choice.station_from_tip, q_.opening_m) > 0;
    });
  }

  const OracleScene& scene_;
  const ArmExecutor& arm_;
  const PlaceQuestion& q_;
  Pose item_from_tip_;
  std::vector<Extents> taken_;
  std::vector<std::size_t> others_;  // that stand outside the basket
};

// The basket and the unloading area, with room round them.
std::vector<AreaRow> basket_and_area(const CheckoutWorld& world) {
  const BasketRow& b = world.station().basket;
  const Vec3 at = world.basket_pose().position;
  const double x = b.top_m[0] / 2 + b.wall_m + keep_off_basket_m,
               y = b.top_m[1] / 2 + b.wall_m + keep_off_basket_m;
  AreaRow area = world.station().unloading.area();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    area.low_m[axis] -= keep_off_area_m;
    area.high_m[axis] += keep_off_area_m;
  }
  return {{{at.x - x, at.y - y}, {at.x + x, at.y + y}, {}}, area};
}

}  // namespace

PlaceQuestion place_question(const OracleScene& scene,
                             std::size_t item,
                             const Pose& tip_from_item,
                             double opening_m,
                             bool in_area) {
  const CheckoutStation& station = scene.world().station();
  PlaceQuestion question;
  question.item = item;
  question.tip_from_item = tip_from_item;
  question.opening_m = std::min(scene.tool().opening_m, opening_m);
  question.area = in_area ? station.unloading.area() : station.set_aside;
  if (!in_area) question.kept_free = basket_and_area(scene.world());
  return question;
}

std::vector<PlaceChoice> item_places(const OracleScene& scene,
                                     const ArmExecutor& arm,
                                     const PlaceQuestion& question,
                                     std::size_t most) {
  return PlaceSearch(scene, arm, question).find(most);
}

AttachedObject held_object(const OracleScene& scene, std::size_t item, const Pose& tip_from_item) {
  const Robot& robot = scene.world().robot();
  std::vector<int> may_touch;
  for (const char* name : {"hand", "finger_left", "finger_right", "link7"})
    if (const int link = robot.find_link(name); link >= 0) may_touch.push_back(link);
  return held_product(robot,
                      robot.find_group("arm")->tip,
                      scene.world().goods(item).body,
                      tip_from_item,
                      std::move(may_touch));
}

}  // namespace marketgen
