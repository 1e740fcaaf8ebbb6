// The room of an open hand: how far it reaches into what stands about, there and on its way there.
// What stands about is given: bodies whose shape and place are known, or points that were measured.
//
// Base frame, metres. A hand comes along its own Z.
#pragma once
#include <span>
#include <vector>

#include "agent/workplace.h"
#include "motion/grasp_surface.h"
#include "robots/grasp_tool.h"

namespace marketgen::skills {

// A body that lies so. Its surface must outlive it.
struct PlacedBody {
  const motion::GraspSurface* surface = nullptr;  // body frame
  Pose base_from_body;
};

// The walls and ledges of a basket, wherever it stands.
class BasketWalls {
 public:
  explicit BasketWalls(const agent::Workplace& place);
  std::vector<PlacedBody> at(const Pose& base_from_basket) const;

 private:
  std::vector<motion::GraspSurface> surfaces_;
  std::vector<Pose> basket_from_box_;
};

// Fingers and palm of a gripper that stands open so far, tool frame.
std::vector<robots::ToolSolid> open_hand(const robots::GraspTool& tool, double opening_m);

// How deep the box reaches into the body; 0 when they are apart.
double box_overlap(const PlacedBody& body, const Pose& base_from_box, Vec3 half);

// How deep the hand reaches into the body, at most, standing there and on its last 14 cm.
double hand_overlap(const std::vector<robots::ToolSolid>& hand,
                    const Pose& base_from_tip,
                    const PlacedBody& body);
// The same into measured points: a few strays do not count.
double hand_overlap(const std::vector<robots::ToolSolid>& hand,
                    const Pose& base_from_tip,
                    const std::vector<Vec3f>& points);

// Whether the hand, standing there, is nearer than `gap_m` to one of the bodies.
bool is_near(const std::vector<robots::ToolSolid>& hand,
             const Pose& base_from_tip,
             std::span<const PlacedBody> bodies,
             double gap_m);

}  // namespace marketgen::skills
