// Our arm planner beside VAMP, in one process: the shelf problems with every product as a box (VAMP
// has no upright cylinder), the same start and goal. Times are the least of seven calls, in turn.
//
//   compare DATA_FOLDER [PROBLEMS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "bench/vamp/vamp_side.h"
#include "robots/robot_row.h"
#include "tests/support/shelf_problems.h"

using namespace marketgen;

namespace {

constexpr int calls = 7;

template <class Work>
double min_us(Work&& work) {
  double least = 1e30;
  for (int i = 0; i < calls; ++i) {
    const auto from = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - from;
    least = std::min(least, spent.count());
  }
  return least;
}

double share_of(std::vector<double> values, double share) {
  if (values.empty()) return -1;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  return values[std::min(at, values.size() - 1)];
}

void print_beside(const char* what,
                  const std::vector<double>& own,
                  const std::vector<double>& its) {
  std::printf("%s: ours median %.0f us p95 %.0f, VAMP median %.0f p95 %.0f, ratio %.2f\n",
              what,
              share_of(own, 0.5),
              share_of(own, 0.95),
              share_of(its, 0.5),
              share_of(its, 0.95),
              share_of(own, 0.5) / share_of(its, 0.5));
}

Obstacles as_boxes(Obstacles obstacles) {
  for (const CylinderObstacle& c : obstacles.cylinders)
    obstacles.boxes.push_back({c.pose, {c.radius, c.radius, c.half_length}});
  obstacles.cylinders.clear();
  return obstacles;
}

std::array<float, 7> floats(const Configuration& q) {
  std::array<float, 7> out{};
  for (std::size_t j = 0; j < 7; ++j)
    out[j] = static_cast<float>(q[j]);
  return out;
}

std::vector<VampBox> vamp_boxes(const Obstacles& obstacles) {
  std::vector<VampBox> boxes;
  for (const BoxObstacle& b : obstacles.boxes) {
    const Vec3f at = to_float(b.pose.position), half = to_float(b.half_size);
    boxes.push_back({{at.x, at.y, at.z}, {half.x, half.y, half.z}});
  }
  return boxes;
}

double length_of_vamp(const std::vector<std::array<float, 7>>& path) {
  JointPath own;
  for (const auto& q : path)
    own.emplace_back(q.begin(), q.end());
  return length_of(own);
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 2 ? std::atoi(argv[2]) : 100;
  const Robot robot = load_robot(argv[1], "panda").value();
  std::vector<double> ready = with_posture(*robot.find_posture("ready"), neutral_state(robot));
  ready[static_cast<std::size_t>(robot.find_dof("finger_joint1"))] = 0.04;
  ready = with_followers(robot, ready);
  const ArmModel model = make_arm_model(robot, "arm").value();
  std::vector<double> search, plan, vamp_search, vamp_plan;
  int asked = 0, solved = 0, vamp_asked = 0, vamp_solved = 0;
  double length = 0, vamp_length = 0;
  for (std::uint64_t index = 0; asked < most; ++index) {
    const ShelfProblem problem = shelf_problem(model, ready, index);
    if (problem.goal.empty()) continue;
    const Obstacles boxes = as_boxes(problem.obstacles);
    const CollisionWorld world = CollisionWorld::make(boxes).value();
    const ArmChecker checker = ArmChecker::make(model, ready, {}, world).value();
    if (!checker.free(problem.start) || !checker.free(problem.goal)) continue;
    ++asked;
    const auto found = plan_arm(checker, problem.start, {problem.goal}, Seed(1));
    solved += found.ok() ? 1 : 0;
    const VampAnswer its =
        vamp_solve(vamp_boxes(boxes), floats(problem.start), floats(problem.goal), calls);
    vamp_asked += its.asked ? 1 : 0;
    vamp_solved += its.solved ? 1 : 0;
    if (!found.ok() || !its.solved) continue;
    const ConfigurationSpace space = checker.space(ArmPlanOptions{}.coarse_step_m);
    search.push_back(
        min_us([&] { (void)rrt_connect(space, problem.start, {problem.goal}, Seed(1)); }));
    plan.push_back(
        min_us([&] { (void)plan_arm(checker, problem.start, {problem.goal}, Seed(1)); }));
    vamp_search.push_back(its.search_us);
    vamp_plan.push_back(its.search_us + its.simplify_us);
    length += length_of(found->path);
    vamp_length += length_of_vamp(its.path);
  }
  std::printf("ours solved %d of %d; VAMP %d of the %d whose ends it holds for free\n",
              solved,
              asked,
              vamp_solved,
              vamp_asked);
  print_beside("search alone", search, vamp_search);
  print_beside("search, shortcuts; ours with fine re-check and times", plan, vamp_plan);
  std::printf("path length, rad: ours %.2f, VAMP %.2f\n",
              length / static_cast<double>(plan.size()),
              vamp_length / static_cast<double>(plan.size()));
}
