// Inverse kinematics on poses that the arm can reach: the tips of random joint values.
#include <algorithm>

#include "base/seed.h"
#include "bench/bench.h"
#include "io/file.h"
#include "robots/arm_ik.h"
#include "robots/numeric_ik.h"
#include "robots/robot_row.h"

namespace marketgen::bench {
namespace {

constexpr int runs = 9;
constexpr int analytic_poses = 1000, numeric_poses = 50;

struct ReachTask {
  robots::ArmJoints
      joints{};  // that made the pose: a redundancy with a solution, and a seed far from none
  Pose tip;
};

std::vector<ReachTask> reach_tasks(const robots::Robot& robot,
                                   const robots::JointGroup& group,
                                   const robots::ArmIk& arm) {
  Stream draw = Seed(7).child("bench_ik", robot.name).stream();
  std::vector<ReachTask> tasks(analytic_poses);
  for (ReachTask& task : tasks) {
    std::vector<double> q = robots::neutral_state(robot);
    for (std::size_t i = 0; i < group.dofs.size(); ++i) {
      task.joints[i] = draw.uniform(arm.lower[i], arm.upper_limit[i]);
      q[static_cast<std::size_t>(group.dofs[i])] = task.joints[i];
    }
    task.tip = robots::frame_pose(robot, q, group.tip);
  }
  return tasks;
}

Figure microseconds(std::string name, double value) {
  return {std::move(name), value * 1e6, "us", runs, std::nullopt, std::nullopt, machine_name()};
}

// Every branch at one value of the redundancy: the time over the solutions found. And the one
// nearest to a seed, over the whole sweep: the time over the poses.
Result<std::vector<Figure>> analytic(const std::filesystem::path& data, const std::string& id) {
  MARKETGEN_TRY(const robots::Robot robot, robots::load_robot(data, id));
  const robots::JointGroup& group = *robot.find_group("arm");
  MARKETGEN_TRY(const robots::ArmIk arm, robots::make_arm_ik(robot, group));
  const std::vector<ReachTask> tasks = reach_tasks(robot, group, arm);
  std::size_t solutions = 0;
  const double all = median_seconds(runs, [&] {
    solutions = 0;
    for (const ReachTask& task : tasks)
      solutions += robots::solve_arm(arm, task.tip, task.joints[6]).size();
  });
  std::size_t reached = 0;
  const double nearest = median_seconds(runs, [&] {
    reached = 0;
    for (const ReachTask& task : tasks)
      reached += robots::nearest_arm_solution(arm, task.tip, {}).ok() ? 1U : 0U;
  });
  if (solutions == 0 || reached == 0)
    return Error{"robot.unreachable", id, "not one of the poses was reached"};
  return std::vector<Figure>{
      microseconds("ik_" + id + "_per_solution_us", all / static_cast<double>(solutions)),
      microseconds("ik_" + id + "_nearest_us", nearest / analytic_poses)};
}

// Base, lift and left arm of the dual-arm robot together, from its neutral state.
Result<std::vector<Figure>> whole_body(const std::filesystem::path& data) {
  MARKETGEN_TRY(const robots::Robot robot, robots::load_robot(data, "realman-rm75"));
  std::vector<int> dofs;
  for (const char* name : {"base", "lift", "left_arm"}) {
    const robots::JointGroup& group = *robot.find_group(name);
    dofs.insert(dofs.end(), group.dofs.begin(), group.dofs.end());
  }
  const int frame = robot.find_group("left_arm")->tip;
  const std::vector<double> seed = robots::neutral_state(robot);
  Stream draw = Seed(7).child("bench_ik_whole_body").stream();
  std::vector<Pose> goals;
  for (int i = 0; i < numeric_poses; ++i) {
    std::vector<double> q = seed;
    for (const int dof : dofs) {
      const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
      q[static_cast<std::size_t>(dof)] =
          draw.uniform(std::max(joint.lower, -1.0), std::min(joint.upper, 1.0));
    }
    goals.push_back(robots::frame_pose(robot, q, frame));
  }
  int reached = 0;
  const double seconds = median_seconds(3, [&] {
    reached = 0;
    for (const Pose& goal : goals)
      reached += robots::solve_numeric(robot, frame, dofs, goal, seed, Seed(1)).ok() ? 1 : 0;
  });
  if (reached == 0) return Error{"robot.unreachable", robot.name, "no pose was reached"};
  Figure time = microseconds("ik_base_lift_arm_us", seconds / numeric_poses);
  time.n = 3;
  return std::vector<Figure>{time,
                             {"ik_base_lift_arm_share_reached",
                              static_cast<double>(reached) / numeric_poses,
                              "share",
                              1,
                              std::nullopt,
                              std::nullopt,
                              machine_name()}};
}

}  // namespace

Figures run_ik(const catalog::Catalog&) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  std::vector<Figure> figures;
  for (const char* id : {"rm65-b-v", "rm75-b", "panda"}) {
    MARKETGEN_TRY(const std::vector<Figure> arm, analytic(data, id));
    figures.insert(figures.end(), arm.begin(), arm.end());
  }
  MARKETGEN_TRY(const std::vector<Figure> body, whole_body(data));
  figures.insert(figures.end(), body.begin(), body.end());
  return figures;
}

}  // namespace marketgen::bench
