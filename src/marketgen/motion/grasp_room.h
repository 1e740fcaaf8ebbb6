// The room that an open tool has at a grasp and on its way there: to the pack itself, to what it
// lies on and what is over it, to walls, and to the pack's likes.
#pragma once
#include <vector>

#include "motion/grasp_candidates.h"
#include "motion/grasp_surface.h"

namespace marketgen::motion {

constexpr double min_clearance_m = 0.002;  // of the open tool

class GraspRoom {
 public:
  GraspRoom(const catalog::Product& product,
            const robots::GraspTool& tool,
            const GraspQuery& query,
            const GraspSurface& surface);

  // Of everything of the open tool to the pack, the ground, what is over it, and walls. Exact down
  // to min_clearance_m, below it only that it is less.
  double clearance_of(const robots::Grasp& grasp) const;

  // Whether the tool is clear there and on the last 10 cm of its way: of the pack and walls by
  // min_clearance_m, and no deeper than max_like_overlap_m in the likes that lie round about.
  bool is_free(const robots::Grasp& grasp) const;

  // How far the open tool reaches into the pack's likes, at most; 0 when it is clear of them.
  double overlap_with_likes(const robots::Grasp& grasp) const;

  // Whether the pads meet the pack before the fingers behind them do, when `width_m` is between
  // them (a lid or shoulder may stand out above what is held), and no wall is between them and it.
  bool pads_touch_first(const robots::Grasp& grasp, double width_m) const;

 private:
  struct Wall {
    Pose box_from_product;
    GraspSurface box;
  };

  using Solids = std::vector<robots::ToolSolid>;

  Solids solids_of(const robots::Grasp& grasp) const;
  double room_over_and_under(const Pose& product_from_box, Vec3 half) const;
  double gap_to_walls(const Pose& product_from_box, Vec3 half, double enough_m) const;
  double clearance_at(const Pose& product_from_tool, const Solids& solids, double enough_m) const;
  double overlap_with_likes_at(const Pose& product_from_tool, const Solids& solids) const;
  bool closes_past_walls(const robots::Grasp& grasp, double width_m) const;
  bool clear_at(const Pose& product_from_tool, const Solids& solids) const;

  const robots::GraspTool& tool_;
  const GraspQuery& query_;
  const GraspSurface& surface_;
  std::vector<Wall> walls_;
  std::vector<Pose> product_from_likes_;
};

}  // namespace marketgen::motion
