// Random problems for an arm in front of a shelf: three boards between sides and a back, boxes and
// cylinders standing on them, and a hand that reaches between the boards to a product's front.
//
// Everything is in the base frame of the arm, metres. The same index is the same problem.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/plan_arm.h"

namespace marketgen {

struct ShelfProblem {
  motion::Obstacles obstacles;
  motion::Configuration start, goal;  // both free
};

struct ShelfProduct {
  Vec3 middle;
  double half_width = 0, half_depth = 0, half_height = 0;
};

struct ShelfScene {
  motion::Obstacles obstacles;
  std::vector<ShelfProduct> products;
};

inline ShelfScene shelf_scene(std::uint64_t index) {
  Stream draw = Seed(2026).child("shelf_problem", index).stream();
  ShelfScene scene;
  const double front = draw.uniform(0.40, 0.52), depth = draw.uniform(0.30, 0.40);
  const double side = draw.uniform(0.40, 0.55), pitch = draw.uniform(0.32, 0.42);
  const double bottom = draw.uniform(-0.05, 0.12), middle = front + depth / 2;
  auto& boxes = scene.obstacles.boxes;
  const double top = bottom + 3 * pitch;
  for (int board = 0; board < 4; ++board)
    boxes.push_back({{{middle, 0, bottom + board * pitch}, {}}, {depth / 2, side, 0.012}});
  for (const double sign : {-1.0, 1.0})
    boxes.push_back(
        {{{middle, sign * side, (bottom + top) / 2}, {}}, {depth / 2, 0.012, (top - bottom) / 2}});
  boxes.push_back(
      {{{front + depth, 0, (bottom + top) / 2}, {}}, {0.012, side, (top - bottom) / 2}});
  for (int board = 0; board < 3; ++board) {
    const double floor = bottom + board * pitch + 0.012;
    for (double y = -side + 0.03; y < side - 0.12;) {
      ShelfProduct p;
      p.half_width = draw.uniform(0.025, 0.06);
      p.half_depth = draw.uniform(0.025, 0.08);
      p.half_height = draw.uniform(0.04, 0.12);
      const bool round = draw.chance(0.5);
      if (round) p.half_depth = p.half_width;
      p.middle = {front + p.half_depth + draw.uniform(0.0, depth - 2 * p.half_depth - 0.02),
                  y + p.half_width,
                  floor + p.half_height};
      y += 2 * p.half_width + draw.uniform(0.01, 0.10);
      if (draw.chance(0.2)) continue;  // a gap
      if (round)
        scene.obstacles.cylinders.push_back({{p.middle, {}}, p.half_width, p.half_height});
      else
        boxes.push_back({{p.middle, {}}, {p.half_depth, p.half_width, p.half_height}});
      scene.products.push_back(p);
    }
  }
  return scene;
}

// A free posture with the hand in front of one of the products, fingers level or upright; empty
// when none of `tries` draws has one.
inline motion::Configuration reach_posture(const ShelfScene& scene,
                                           const motion::ArmChecker& checker,
                                           Stream& draw,
                                           int tries) {
  const motion::ArmModel& model = checker.model();
  const motion::Configuration near{0, -0.785, 0, -2.356, 0, 1.571, 0.785};
  for (int i = 0; i < tries && !scene.products.empty(); ++i) {
    const auto pick = draw.integer(0, static_cast<int>(scene.products.size()) - 1);
    const ShelfProduct& p = scene.products[static_cast<std::size_t>(pick)];
    const Vec3 at = p.middle - Vec3{p.half_depth + draw.uniform(0.005, 0.06), 0, 0} +
                    Vec3{0, 0, draw.uniform(-0.3, 0.6) * p.half_height};
    const double roll = draw.chance(0.5) ? 0 : std::numbers::pi / 2;
    const Pose tip{at,
                   rotation_about({0, 0, 1}, draw.uniform(-0.3, 0.3)) *
                       rotation_about({0, 1, 0}, std::numbers::pi / 2 + draw.uniform(-0.1, 0.3)) *
                       rotation_about({0, 0, 1}, roll)};
    const auto goals = motion::arm_goals(*model.robot, model.group, tip, near);
    if (!goals.ok()) continue;
    for (const motion::Configuration& q : *goals) {
      if (checker.free(q)) return q;
    }
  }
  return {};
}

// Half of the problems start at the posture "ready", half in another part of the same shelf. Empty
// goal: the scene had no free posture to ask for.
inline ShelfProblem shelf_problem(const motion::ArmModel& model,
                                  const std::vector<double>& ready,
                                  std::uint64_t index) {
  const ShelfScene scene = shelf_scene(index);
  ShelfProblem problem;
  problem.obstacles = scene.obstacles;
  const auto world = motion::CollisionWorld::make(scene.obstacles);
  if (!world.ok()) return problem;
  const auto checker = motion::ArmChecker::make(model, ready, {}, *world);
  if (!checker.ok()) return problem;
  Stream draw = Seed(2026).child("shelf_reach", index).stream();
  for (const int dof : model.group.dofs)
    problem.start.push_back(ready[static_cast<std::size_t>(dof)]);
  if (index % 2 == 1) problem.start = reach_posture(scene, *checker, draw, 40);
  if (problem.start.empty() || !checker->free(problem.start)) return problem;
  problem.goal = reach_posture(scene, *checker, draw, 40);
  return problem;
}

}  // namespace marketgen
