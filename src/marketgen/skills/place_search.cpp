#include "skills/place_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/box_extents.h"

namespace marketgen {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr int place_yaws = 24, place_rolls = 12;
constexpr double most_place_tilt_deg = 60;  // of the tool when it lets go
constexpr double place_edge_m = 0.010;      // to the edge of the area
constexpr double place_gap_m = 0.015;       // to what stands there
constexpr double place_grid_m = 0.035;
constexpr double tool_over_counter_m = 0.003;
constexpr double place_down_m = 0.08;
constexpr double round_size_m = 0.002;  // width and depth differ by less: a round pack
constexpr double standing_m = 0.009;  // what is seen higher than this over the counter stands there
constexpr double most_tool_touch_m = 0.0;  // of the tool with what stands there
constexpr double wall_room_m = 0.012;      // of the tool to the basket
constexpr int rim_points = 24;

struct Spread {
  Vec3 low, high;
};

// Points whose hull is the product's, product frame.
std::vector<Vec3> outline_points(const ProductBody& body) {
  std::vector<Vec3> points;
  for (const ContactPiece& piece : body.pieces) {
    const Vec3 c = to_double(piece.center), h = to_double(piece.half_size);
    const auto add = [&](Vec3 off) {
      points.push_back(c + (piece.lying ? Vec3{off.z, off.y, -off.x} : off));
    };
    if (piece.shape == PieceShape::hull) {
      for (const Vec3f& point : piece.points)
        points.push_back(to_double(point));
    } else if (piece.shape == PieceShape::box) {
      for (const double x : {-h.x, h.x})
        for (const double y : {-h.y, h.y})
          for (const double z : {-h.z, h.z})
            points.push_back(c + Vec3{x, y, z});
    } else {
      const bool flat_ends = piece.shape == PieceShape::cylinder;
      for (const double z : {-1.0, -0.7, 0.0, 0.7, 1.0}) {
        const double r = flat_ends ? 1 : std::sqrt(1 - z * z);
        for (int i = 0; i < rim_points; ++i) {
          const double a = 2 * half_turn * i / rim_points;
          add({h.x * r * std::cos(a), h.y * r * std::sin(a), h.z * z});
        }
      }
    }
  }
  return points;
}

Spread spread_of(const std::vector<Vec3>& points, const Quaternion& turned) {
  Spread s{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const Vec3& point : points) {
    const Vec3 p = rotate(turned, point);
    s.low = {std::min(s.low.x, p.x), std::min(s.low.y, p.y), std::min(s.low.z, p.z)};
    s.high = {std::max(s.high.x, p.x), std::max(s.high.y, p.y), std::max(s.high.z, p.z)};
  }
  return s;
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
std::vector<Quaternion> resting_turns(const Product& product) {
  std::vector<Quaternion> turns;
  for (const Vec3 down : {Vec3{0, 0, -1},
                          Vec3{0, 0, 1},
                          Vec3{1, 0, 0},
                          Vec3{-1, 0, 0},
                          Vec3{0, 1, 0},
                          Vec3{0, -1, 0}})
    turns.push_back(turned_down(down));
  const bool round =
      std::abs(product.width_m() - product.depth_m()) < round_size_m && product.archetype != "box";
  for (int i = 0; round && i < place_rolls; ++i) {
    const double angle = 2 * half_turn * (i + 0.5) / place_rolls;
    turns.push_back(turned_down({std::cos(angle), std::sin(angle), 0}));
  }
  return turns;
}

double lean_deg(const Quaternion& base_from_tip) {
  return std::acos(std::clamp(-rotate(base_from_tip, {0, 0, 1}).z, -1.0, 1.0)) * 180 / half_turn;
}

class FreePlaceSearch {
 public:
  FreePlaceSearch(const GraspTool& tool,
                  const ArmExecutor& arm,
                  const HeldProduct& held,
                  const PlaceAsk& ask)
      : tool_(tool),
        arm_(arm),
        held_(held),
        ask_(ask),
        outline_(outline_points(held.known->body)),
        product_from_tip_(inverse(held.tip_from_product)) {
    for (const Vec3f& point : ask.counter)
      if (point.z > static_cast<float>(standing_m)) standing_.push_back(point);
    solids_ = opened(tool, held.opening_m);
    solids_.insert(solids_.end(), tool.body.begin(), tool.body.end());
  }

  std::vector<FreePlace> find(std::size_t most) const {
    std::vector<FreePlace> found;
    for (const Quaternion& turned : turns()) {
      std::size_t of_turn = 0;
      for (const Pose& pose : poses(turned)) {
        if (found.size() >= most) return found;
        if (of_turn >= 2) break;
        const FreePlace place = place_of(pose);
        Pose above = place.base_from_tip;
        above.position.z += place_down_m;
        if (!tool_has_room(place.base_from_tip)) continue;
        if (!arm_.effort_to(place.base_from_tip) || !arm_.effort_to(above)) continue;
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

  // The tool straight down and the product low and wide come first.
  std::vector<Quaternion> turns() const {
    std::vector<std::pair<double, Quaternion>> ranked;
    for (const Quaternion& rests : resting_turns(held_.known->product)) {
      const Spread s = spread_of(outline_, rests);
      const Vec3 size = s.high - s.low;
      const double slender = size.z / std::min(size.x, size.y);
      for (int yaw = 0; yaw < place_yaws; ++yaw) {
        const Quaternion turned =
            rotation_about({0, 0, 1}, 2 * half_turn * yaw / place_yaws) * rests;
        const double lean = lean_deg(turned * product_from_tip_.rotation);
        if (lean <= most_place_tilt_deg)
          ranked.emplace_back(lean + 15 * std::max(0.0, slender - 1), turned);
      }
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<Quaternion> turns;
    for (const auto& entry : ranked)
      turns.push_back(entry.second);
    return turns;
  }

  // How far the nearest thing is from an upright box on the counter; less than 0: too near.
  double room_round(const WorkArea& footprint) const {
    for (const WorkArea& kept : ask_.kept_free) {
      if (footprint.low_m[0] < kept.high_m[0] && kept.low_m[0] < footprint.high_m[0] &&
          footprint.low_m[1] < kept.high_m[1] && kept.low_m[1] < footprint.high_m[1])
        return -1;
    }
    double nearest = 0.3;
    for (const Vec3f& p : standing_) {
      const double x = std::max({footprint.low_m[0] - p.x, p.x - footprint.high_m[0], 0.0});
      const double y = std::max({footprint.low_m[1] - p.y, p.y - footprint.high_m[1], 0.0});
      nearest = std::min(nearest, std::hypot(x, y));
    }
    return nearest - place_gap_m;
  }

  // Free places of the product turned so, the roomiest first, then those near the middle.
  std::vector<Pose> poses(const Quaternion& turned) const {
    const Spread s = spread_of(outline_, turned);
    std::vector<std::pair<double, Pose>> ranked;
    const WorkArea& area = ask_.area;
    const Vec3 low{
        area.low_m[0] + place_edge_m - s.low.x, area.low_m[1] + place_edge_m - s.low.y, 0};
    const Vec3 high{
        area.high_m[0] - place_edge_m - s.high.x, area.high_m[1] - place_edge_m - s.high.y, 0};
    for (double x = low.x; x <= high.x; x += place_grid_m) {
      for (double y = low.y; y <= high.y; y += place_grid_m) {
        const double room = room_round({{x + s.low.x, y + s.low.y}, {x + s.high.x, y + s.high.y}});
        if (room < 0) continue;
        const double away = std::hypot(x - (area.low_m[0] + area.high_m[0]) / 2,
                                       y - (area.low_m[1] + area.high_m[1]) / 2);
        ranked.push_back({away - 2 * room, {{x, y, let_go_height_m - s.low.z}, turned}});
      }
    }
    std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
    std::vector<Pose> poses;
    constexpr std::size_t most_tried = 8;
    for (std::size_t i = 0; i < std::min(ranked.size(), most_tried); ++i)
      poses.push_back(ranked[i].second);
    return poses;
  }

  bool tool_has_room(const Pose& tip) const {
    for (const ToolSolid& solid : solids_) {
      const Pose pose = tip * solid.tool_from_solid;
      if (pose.position.z - box_half_extents(pose.rotation, solid.half_size).z <
          tool_over_counter_m)
        return false;
      const Pose solid_from_base = inverse(pose);
      const Vec3 half = solid.half_size;
      for (const Vec3f& point : standing_) {
        const Vec3 at = solid_from_base * to_double(point);
        if (std::abs(at.x) < half.x + most_tool_touch_m &&
            std::abs(at.y) < half.y + most_tool_touch_m &&
            std::abs(at.z) < half.z + most_tool_touch_m)
          return false;
      }
    }
    return !tool_meets_walls(tip);
  }

  // By points on the tool's solids.
  bool tool_meets_walls(const Pose& tip) const {
    for (const ToolSolid& solid : solids_) {
      const Pose pose = tip * solid.tool_from_solid;
      for (int i = 0; i < 27; ++i) {
        const Vec3 share{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
        const Vec3 at = pose * (solid.half_size * share);
        for (const WorkBox& wall : ask_.walls) {
          const Vec3 in = inverse(wall.pose) * at, half = wall.half_size;
          if (std::abs(in.x) < half.x + wall_room_m && std::abs(in.y) < half.y + wall_room_m &&
              std::abs(in.z) < half.z + wall_room_m)
            return true;
        }
      }
    }
    return false;
  }

  const GraspTool& tool_;
  const ArmExecutor& arm_;
  const HeldProduct& held_;
  const PlaceAsk& ask_;
  std::vector<Vec3> outline_;
  Pose product_from_tip_;
  std::vector<Vec3f> standing_;
  std::vector<ToolSolid> solids_;
};

}  // namespace

std::vector<FreePlace> free_places(const GraspTool& tool,
                                   const ArmExecutor& arm,
                                   const HeldProduct& held,
                                   const PlaceAsk& ask,
                                   std::size_t most) {
  return FreePlaceSearch(tool, arm, held, ask).find(most);
}

AttachedObject held_spheres(const Robot& robot, const HeldProduct& held) {
  const RobotFrame& tip = robot.frames[static_cast<std::size_t>(robot.find_group("arm")->tip)];
  AttachedObject attached;
  attached.link = tip.link;
  for (const char* name : {"hand", "finger_left", "finger_right", "link7"})
    if (const int link = robot.find_link(name); link >= 0) attached.may_touch.push_back(link);
  const Spread s = spread_of(outline_points(held.known->body), {});
  const Vec3 half = (s.high - s.low) * 0.5, middle = (s.high + s.low) * 0.5;
  std::array<std::pair<double, Vec3>, 3> axes{
      std::pair{half.x, Vec3{1, 0, 0}}, {half.y, {0, 1, 0}}, {half.z, {0, 0, 1}}};
  std::ranges::sort(axes, {}, [](const auto& axis) { return axis.first; });
  const double radius = std::max(axes[0].first, axes[1].first);
  const double run = std::max(0.0, axes[2].first - radius);
  const int count = 1 + 2 * static_cast<int>(std::ceil(run / radius));
  for (int i = 0; i < count; ++i) {
    const double along = count > 1 ? run * (2.0 * i / (count - 1) - 1) : 0;
    attached.spheres.push_back(
        {tip.link_from_frame * (held.tip_from_product * (middle + axes[2].second * along)),
         radius});
  }
  return attached;
}

}  // namespace marketgen
