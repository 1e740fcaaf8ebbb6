// Planning the Panda's arm into and between the boards of a stocked shelf: the problems of
// tests/support/shelf_problems.h, one thread.
#include <algorithm>
#include <chrono>

#include "bench/bench.h"
#include "io/file.h"
#include "robots/robot_row.h"
#include "tests/support/shelf_problems.h"

namespace marketgen::bench {
namespace {

constexpr int shelf_problems = 200, calls = 5;

double share_of(std::vector<double> sorted, double share) {
  std::sort(sorted.begin(), sorted.end());
  const auto at = static_cast<std::size_t>(share * static_cast<double>(sorted.size()));
  return sorted[std::min(at, sorted.size() - 1)];
}

struct PlanTimes {
  std::vector<double> milliseconds;
  int asked = 0;
};

// A problem counts when its scene has a free start and a free goal. Its time is the least of five
// calls, so that other programs on the machine do not count; making the checker, once for a scene,
// does not either.
Result<PlanTimes> plan_shelves(const motion::ArmModel& model, const std::vector<double>& ready) {
  PlanTimes times;
  for (std::uint64_t index = 0; times.asked < shelf_problems; ++index) {
    const ShelfProblem problem = shelf_problem(model, ready, index);
    if (problem.goal.empty()) continue;
    ++times.asked;
    MARKETGEN_TRY(const motion::CollisionWorld world,
                  motion::CollisionWorld::make(problem.obstacles));
    MARKETGEN_TRY(const motion::ArmChecker checker,
                  motion::ArmChecker::make(model, ready, {}, world));
    double least = -1;
    for (int call = 0; call < calls; ++call) {
      const auto from = std::chrono::steady_clock::now();
      const auto plan = motion::plan_arm(checker, problem.start, {problem.goal}, Seed(1));
      const std::chrono::duration<double, std::milli> spent =
          std::chrono::steady_clock::now() - from;
      if (plan.ok() && (least < 0 || spent.count() < least)) least = spent.count();
    }
    if (least >= 0) times.milliseconds.push_back(least);
  }
  return times;
}

Figure figure(std::string name, double value, std::string unit) {
  return {std::move(name),
          value,
          std::move(unit),
          shelf_problems,
          std::nullopt,
          std::nullopt,
          machine_name()};
}

}  // namespace

Figures run_arm_planning(const catalog::Catalog&) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(const robots::Robot robot, robots::load_robot(data, "panda"));
  std::vector<double> ready =
      robots::with_posture(*robot.find_posture("ready"), robots::neutral_state(robot));
  ready[static_cast<std::size_t>(robot.find_dof("finger_joint1"))] = 0.04;
  ready = robots::with_followers(robot, std::move(ready));
  MARKETGEN_TRY(const motion::ArmModel model, motion::make_arm_model(robot, "arm"));
  MARKETGEN_TRY(const PlanTimes times, plan_shelves(model, ready));
  if (times.milliseconds.empty())
    return Error{"motion.no_path", "arm_planning", "not one of the problems was solved"};
  const double solved = static_cast<double>(times.milliseconds.size()) / times.asked;
  return std::vector<Figure>{
      figure("arm_planning_solved", solved, "share"),
      figure("arm_planning_median_ms", share_of(times.milliseconds, 0.5), "ms"),
      figure("arm_planning_p95_ms", share_of(times.milliseconds, 0.95), "ms")};
}

}  // namespace marketgen::bench
