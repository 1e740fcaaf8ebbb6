#include "skills/place_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/box_extents.h"
#include "skills/hand_grasp.h"

namespace marketgen::skills {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr int place_yaws = 24, place_rolls = 12;
constexpr double max_place_tilt_deg = 62;  // of the tool when it lets go
constexpr double place_edge_m = 0.006;     // to the edge of the area
constexpr double place_gap_m = 0.012;      // to what stands there
constexpr double place_grid_m = 0.035;
constexpr std::size_t max_poses_tried = 12;  // of one way round
constexpr std::size_t max_of_a_turn = 2;     // places
constexpr double tool_over_counter_m = 0.003;
constexpr double hand_off_walls_m = 0.012;  // of the tool to the basket's walls, outside
constexpr double place_down_m = 0.08;
constexpr double round_within_m = 0.002;  // width and depth differ by less: a round pack
constexpr float standing_m =
    0.009F;  // what is measured higher than this over the counter stands there
// ---- Of a place's rank: slender packs topple, and what stands free is reached again. ----
constexpr double deg_of_slender = 15, room_over_middle = 2, max_place_room_m = 0.3;
constexpr double off_basket_m = 0.03, off_unloading_m = 0.02;

struct Spread {
  Vec3 low, high;  // from the pack's origin, base axes
};

// Of the pack when it is turned so; exact.
Spread spread_of(const assets::ProductBody& body, const Quaternion& turned) {
  const TurnedBox box = turned_box(body, {{}, turned});
  return {box.middle - box.half, box.middle + box.half};
}

// The turn that brings a direction of the product to point straight down.
Quaternion turned_down(Vec3 axis) {
  const Vec3 down{0, 0, -1};
  const double cosine = dot(axis, down);
  if (cosine < -1 + 1e-9) return rotation_about({1, 0, 0}, half_turn);
  if (cosine > 1 - 1e-9) return {};
  return rotation_about(normalized(cross(axis, down)), std::acos(cosine));
}

// Ways round in which it stays, but for the yaw.
std::vector<Quaternion> resting_turns(const HeldPack& held) {
  std::vector<Quaternion> turns;
  for (const Vec3 down : {Vec3{0, 0, -1},
                          Vec3{0, 0, 1},
                          Vec3{1, 0, 0},
                          Vec3{-1, 0, 0},
                          Vec3{0, 1, 0},
                          Vec3{0, -1, 0}})
    turns.push_back(turned_down(down));
  const catalog::Product& p = *held.product;
  const bool round = std::abs(p.width_m() - p.depth_m()) < round_within_m && p.archetype != "box";
  for (int i = 0; round && i < place_rolls; ++i) {
    const double angle = 2 * half_turn * (i + 0.5) / place_rolls;
    turns.push_back(turned_down({std::cos(angle), std::sin(angle), 0}));
  }
  if (p.orientation == catalog::Orientation::any) turns.push_back(held.base_from_product);
  return turns;
}

bool overlap(const agent::WorkArea& a, const agent::WorkArea& b, double gap) {
  return a.low_m[0] < b.high_m[0] + gap && b.low_m[0] < a.high_m[0] + gap &&
         a.low_m[1] < b.high_m[1] + gap && b.low_m[1] < a.high_m[1] + gap;
}

// What stands about, seen from above. A measured point is a thing without a size.
struct Thing {
  agent::WorkArea outline;
  double x = 0, y = 0;  // its middle
};

std::vector<Thing> things_of(const PlaceQuestion& question) {
  std::vector<Thing> things;
  for (const CounterBody& body : question.bodies) {
    const Vec3 low = body.box.middle - body.box.half, high = body.box.middle + body.box.half;
    things.push_back(
        {{{low.x, low.y}, {high.x, high.y}}, (low.x + high.x) / 2, (low.y + high.y) / 2});
  }
  return things;
}

std::vector<Vec3f> standing_points(const PlaceQuestion& question) {
  std::vector<Vec3f> standing;
  if (question.points != nullptr)
    std::ranges::copy_if(*question.points, std::back_inserter(standing), [](const Vec3f& point) {
      return point.z > standing_m;
    });
  return standing;
}

class FreePlaceSearch {
 public:
  FreePlaceSearch(const robots::GraspTool& tool,
                  const ArmExecutor& arm,
                  const HeldPack& held,
                  const PlaceQuestion& question)
      : arm_(arm),
        held_(held),
        question_(question),
        product_from_tip_(inverse(held.tip_from_product)),
        hand_(open_hand(tool, held.opening_m)),
        points_(standing_points(question)),
        things_(things_of(question)) {
    for (const Vec3f& p : points_) {
      const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
      things_.push_back({{{x, y}, {x, y}}, x, y});
    }
  }

  std::vector<FreePlace> find(std::size_t max_places) const {
    std::vector<FreePlace> found;
    for (const Quaternion& turned : turns()) {
      std::size_t of_turn = 0;
      for (const Pose& pose : poses(turned)) {
        if (found.size() >= max_places) return found;
        if (of_turn >= max_of_a_turn) break;
        const FreePlace place = place_of(pose);
        if (!tool_has_room(place.base_from_tip) || !is_in_reach(place.base_from_tip)) continue;
        found.push_back(place);
        ++of_turn;
      }
    }
    return found;
  }

 private:
  FreePlace place_of(const Pose& pose) const {
    const Pose tip = pose * product_from_tip_;
    return {pose, tip, rotate(inverse(tip.rotation), {0, 0, -place_down_m})};
  }

  bool is_in_reach(const Pose& tip) const {
    Pose above = tip;
    above.position.z += place_down_m;
    return arm_.effort_to(tip) && arm_.effort_to(above);
  }

  // The tool straight down and the pack low and wide come first.
  std::vector<Quaternion> turns() const {
    std::vector<std::pair<double, Quaternion>> ranked;
    for (const Quaternion& rests : resting_turns(held_)) {
      const Spread s = spread_of(*held_.body, rests);
      const Vec3 size = s.high - s.low;
      const double slender = size.z / std::min(size.x, size.y);
      for (int yaw = 0; yaw < place_yaws; ++yaw) {
        const Quaternion turned =
            rotation_about({0, 0, 1}, 2 * half_turn * yaw / place_yaws) * rests;
        const double tilt = tilt_deg(turned * product_from_tip_.rotation);
        if (tilt <= max_place_tilt_deg)
          ranked.emplace_back(tilt + deg_of_slender * std::max(0.0, slender - 1), turned);
      }
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<Quaternion> turns;
    for (const auto& entry : ranked)
      turns.push_back(entry.second);
    return turns;
  }

  bool is_free(const agent::WorkArea& footprint) const {
    const auto is_kept = [&](const agent::WorkArea& kept) { return overlap(footprint, kept, 0); };
    const auto is_taken = [&](const Thing& thing) {
      return overlap(footprint, thing.outline, place_gap_m + question_.unsure_m);
    };
    return std::ranges::none_of(question_.kept_free, is_kept) &&
           std::ranges::none_of(things_, is_taken);
  }

  // To the middle of what stands nearest.
  double room_at(double x, double y) const {
    double nearest = max_place_room_m;
    for (const Thing& thing : things_)
      nearest = std::min(nearest, std::hypot(thing.x - x, thing.y - y));
    return nearest;
  }

  // Free places of the pack turned so, the roomiest first, then those near the middle; or those
  // nearest to the corners.
  std::vector<Pose> poses(const Quaternion& turned) const {
    const Spread s = spread_of(*held_.body, turned);
    const agent::WorkArea& area = question_.area;
    const double edge = place_edge_m + question_.unsure_m;
    std::vector<std::pair<double, Pose>> ranked;
    for (double x = area.low_m[0] + edge - s.low.x; x <= area.high_m[0] - edge - s.high.x;
         x += place_grid_m) {
      for (double y = area.low_m[1] + edge - s.low.y; y <= area.high_m[1] - edge - s.high.y;
           y += place_grid_m) {
        if (!is_free({{x + s.low.x, y + s.low.y}, {x + s.high.x, y + s.high.y}})) continue;
        const double away = std::hypot(x - (area.low_m[0] + area.high_m[0]) / 2,
                                       y - (area.low_m[1] + area.high_m[1]) / 2);
        const double rank =
            question_.corners_first ? -away : away - room_over_middle * room_at(x, y);
        ranked.push_back({rank, {{x, y, let_go_height_m - s.low.z}, turned}});
      }
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < std::min(ranked.size(), max_poses_tried); ++i)
      poses.push_back(ranked[i].second);
    return poses;
  }

  bool tool_has_room(const Pose& tip) const {
    if (is_near(hand_, tip, question_.walls, hand_off_walls_m)) return false;
    for (const robots::ToolSolid& solid : hand_) {
      const Pose pose = tip * solid.tool_from_solid;
      if (pose.position.z - box_half_extents(pose.rotation, solid.half_size).z <
          tool_over_counter_m)
        return false;
    }
    return hand_overlap(hand_, tip, points_) == 0 &&
           std::ranges::none_of(question_.bodies, [&](const CounterBody& body) {
             return hand_overlap(hand_, tip, body) > 0;
           });
  }

  const ArmExecutor& arm_;
  const HeldPack& held_;
  const PlaceQuestion& question_;
  Pose product_from_tip_;
  std::vector<robots::ToolSolid> hand_;
  std::vector<Vec3f> points_;  // of what stands about
  std::vector<Thing> things_;
};

}  // namespace

std::vector<FreePlace> free_places(const robots::GraspTool& tool,
                                   const ArmExecutor& arm,
                                   const HeldPack& held,
                                   const PlaceQuestion& question,
                                   std::size_t max_places) {
  return FreePlaceSearch(tool, arm, held, question).find(max_places);
}

std::vector<agent::WorkArea> areas_kept_free(const agent::Workplace& place) {
  const Vec3 at = place.base_from_basket.position;
  const double x = place.inner_half.x + place.wall_m + off_basket_m,
               y = place.inner_half.y + place.wall_m + off_basket_m;
  agent::WorkArea unloading = place.unloading;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    unloading.low_m[axis] -= off_unloading_m;
    unloading.high_m[axis] += off_unloading_m;
  }
  return {{{at.x - x, at.y - y}, {at.x + x, at.y + y}}, unloading};
}

motion::AttachedObject held_spheres(const robots::Robot& robot,
                                    const assets::ProductBody& body,
                                    const Pose& tip_from_product) {
  std::vector<int> may_touch;
  for (const char* name : {"hand", "finger_left", "finger_right", "link7"})
    if (const int link = robot.find_link(name); link >= 0) may_touch.push_back(link);
  return held_product(
      robot, robot.find_group("arm")->tip, body, tip_from_product, std::move(may_touch));
}

}  // namespace marketgen::skills
