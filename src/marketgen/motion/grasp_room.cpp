#include "motion/grasp_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/box_extents.h"

namespace marketgen::motion {
namespace {

// Where else on the way to the pack the open tool is looked at: so far back.
constexpr std::array on_the_way_m = {0.01, 0.02, 0.035, 0.05, 0.075, 0.1};
// Between shut (0) and open (1): where fingers that close are looked at.
constexpr std::array while_closing = {0.0, 0.25, 0.5, 0.75};
// A cup's body may be this near to what its bellows press on.
constexpr double bellows_m = 0.03;
constexpr double no_end = std::numeric_limits<double>::infinity();

// Whether a ball touches the box: most of a tool is far from most packs, and hulls are slow.
bool near_bounds(const Bounds3& bounds, Vec3 middle, double radius_m) {
  const Vec3 low = to_double(bounds.low), high = to_double(bounds.high);
  const Vec3 nearest{std::clamp(middle.x, low.x, high.x),
                     std::clamp(middle.y, low.y, high.y),
                     std::clamp(middle.z, low.z, high.z)};
  return length(middle - nearest) <= radius_m;
}

}  // namespace

GraspRoom::GraspRoom(const catalog::Product& product,
                     const robots::GraspTool& tool,
                     const GraspQuery& query,
                     const GraspSurface& surface)
    : tool_(tool), query_(query), surface_(surface) {
  for (const GraspObstacle& wall : query.walls) {
    assets::ContactPiece box;
    box.half_size = to_float(wall.half_size);
    walls_.push_back(
        {inverse(wall.world_from_box) * query.world_from_product, GraspSurface({box})});
  }
  const Pose product_from_world = inverse(query.world_from_product);
  for (const Pose& like : query.likes)
    product_from_likes_.push_back(product_from_world * like);
  if (query.neighbour_gap_m <= 0) return;
  for (const double side : {-1.0, 1.0})
    product_from_likes_.push_back({{side * (product.width_m() + query.neighbour_gap_m), 0, 0}, {}});
}

GraspRoom::Solids GraspRoom::solids_of(const robots::Grasp& grasp) const {
  Solids solids = robots::opened(tool_, grasp.opening_m);
  solids.insert(solids.end(), tool_.body.begin(), tool_.body.end());
  return solids;
}

double GraspRoom::clearance_of(const robots::Grasp& grasp) const {
  return clearance_at(grasp.product_from_tool, solids_of(grasp), no_end);
}

double GraspRoom::clearance_at(const Pose& product_from_tool,
                               const Solids& solids,
                               double enough_m) const {
  double least = no_end;
  for (const robots::ToolSolid& solid : solids) {
    const Pose pose = product_from_tool * solid.tool_from_solid;
    least = std::min(least, room_over_and_under(pose, solid.half_size));
    if (least < min_clearance_m) return least;
    least = std::min(least, gap_to_walls(pose, solid.half_size, std::min(least, enough_m)));
    if (least < min_clearance_m) return least;
    const bool bellows = tool_.kind == robots::ToolKind::suction &&
                         solid.tool_from_solid.position.z + solid.half_size.z > -bellows_m;
    if (!bellows)
      least =
          std::min(least, surface_.gap_to_box(pose, solid.half_size, std::min(least, enough_m)));
    if (least < min_clearance_m) return least;
  }
  return least;
}

double GraspRoom::room_over_and_under(const Pose& product_from_box, Vec3 half) const {
  const Pose pose = query_.world_from_product * product_from_box;
  const double reach = box_half_extents(pose.rotation, half).z;
  const double under = pose.position.z - reach;
  if (!query_.ceiling_m) return under;
  return std::min(under, *query_.ceiling_m - pose.position.z - reach);
}

double GraspRoom::gap_to_walls(const Pose& product_from_box, Vec3 half, double enough_m) const {
  double least = no_end;
  for (const Wall& wall : walls_)
    least =
        std::min(least,
                 wall.box.gap_to_box(
                     wall.box_from_product * product_from_box, half, std::min(least, enough_m)));
  return least;
}

double GraspRoom::overlap_with_likes(const robots::Grasp& grasp) const {
  return overlap_with_likes_at(grasp.product_from_tool, solids_of(grasp));
}

double GraspRoom::overlap_with_likes_at(const Pose& product_from_tool, const Solids& solids) const {
  double room = 0;
  for (const Pose& like : product_from_likes_) {
    const Pose like_from_tool = inverse(like) * product_from_tool;
    for (const robots::ToolSolid& solid : solids) {
      const Pose pose = like_from_tool * solid.tool_from_solid;
      if (near_bounds(surface_.bounds(), pose.position, length(solid.half_size)))
        room = std::min(room, surface_.gap_to_box(pose, solid.half_size, 0));
    }
  }
  return -room;
}

bool GraspRoom::clear_at(const Pose& product_from_tool, const Solids& solids) const {
  return clearance_at(product_from_tool, solids, min_clearance_m) >= min_clearance_m &&
         (query_.likes.empty() ||
          overlap_with_likes_at(product_from_tool, solids) <= max_like_overlap_m);
}

bool GraspRoom::is_free(const robots::Grasp& grasp) const {
  const Solids solids = solids_of(grasp);
  Pose tool = grasp.product_from_tool;
  if (!clear_at(tool, solids)) return false;
  const Vec3 back = rotate(tool.rotation, {0, 0, -1});
  return std::ranges::all_of(on_the_way_m, [&](double by) {
    tool.position = grasp.product_from_tool.position + back * by;
    return clear_at(tool, solids);
  });
}

// One finger may be inside a basket and the other outside.
bool GraspRoom::closes_past_walls(const robots::Grasp& grasp, double width_m) const {
  if (walls_.empty()) return true;
  return std::ranges::all_of(while_closing, [&](double share) {
    const double opening = width_m + share * (grasp.opening_m - width_m);
    return std::ranges::all_of(robots::opened(tool_, opening), [&](const robots::ToolSolid& solid) {
      return gap_to_walls(grasp.product_from_tool * solid.tool_from_solid, solid.half_size, 0) >= 0;
    });
  });
}

bool GraspRoom::pads_touch_first(const robots::Grasp& grasp, double width_m) const {
  const std::vector<robots::ToolSolid> shut = robots::opened(tool_, width_m);
  for (std::size_t i = 0; i < shut.size(); ++i) {
    if (i == 0 || i == tool_.left.size()) continue;  // the pads
    const Pose pose = grasp.product_from_tool * shut[i].tool_from_solid;
    if (surface_.gap_to_box(pose, shut[i].half_size, 0) < 0) return false;
  }
  return closes_past_walls(grasp, width_m);
}

}  // namespace marketgen::motion
