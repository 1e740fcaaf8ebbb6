#include "collect/collect_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "physics/goods/contact_shape.h"

namespace marketgen::collect {
namespace {

constexpr double room_m = 2.0;  // of the store round the product that is in the world
constexpr double close_s = 0.6, hold_s = 0.6;
constexpr double held_slip_m = 0.010, moved_m = 0.020;

class Run {
 public:
  Run(const scene::Scene& scene,
      const robots::Robot& robot,
      const CollectPlan& plan,
      const CollectWatch& watch,
      double watch_every_s)
      : scene_(scene), robot_(robot), plan_(plan), watch_(watch), watch_every_s_(watch_every_s) {}

  Result<void> start(const std::vector<catalog::FrictionRow>& frictions) {
    place_.world_from_base = plan_.world_from_base;
    place_.state = plan_.state;
    const Vec3 at = start_pose().position;
    physics::WorldOptions options;
    options.region_m = {at.x - room_m, at.y - room_m, at.x + room_m, at.y + room_m};
    options.frictions = frictions;
    options.actor_materials = physics::robot_materials(robot_, place_);
    options.add_actors = [this](mjSpec_& spec) { return physics::add_robot(spec, robot_, place_); };
    MARKETGEN_TRY(physics::World world, physics::World::create(scene_, std::move(options)));
    world_ = std::make_unique<physics::World>(std::move(world));
    MARKETGEN_TRY(controller_, physics::RobotController::start(*world_, robot_));
    reference_.joints = controller_.setpoints();
    reference_.grips.resize(robot_.tools.size());
    return {};
  }

  Result<void> carry_out() {
    const robots::Grasp& grasp = plan_.grasp.grasp;
    MARKETGEN_CHECK(
        follow(plan_.reach.trajectory, CollectPhase::reach, grasp.opening_m, grasp.force_n));
    MARKETGEN_CHECK(wait(close_s, CollectPhase::close, grasp.force_n));
    tip_from_product_ = tip_from_product();
    MARKETGEN_CHECK(follow(plan_.lift, CollectPhase::lift, 0, grasp.force_n));
    MARKETGEN_CHECK(follow(plan_.retreat, CollectPhase::retreat, 0, grasp.force_n));
    MARKETGEN_CHECK(wait(hold_s, CollectPhase::hold, grasp.force_n));
    return watch_ ? watch_(*world_, controller_.actor(), CollectPhase::hold) : Result<void>{};
  }

  CollectResult result() {
    CollectResult result;
    result.slip_m = length(tip_from_product().position - tip_from_product_.position);
    result.raised_m = world_->product_pose(plan_.product).position.z - start_pose().position.z;
    result.time_s = world_->time_s();
    for (const physics::WorldContact& c : world_->contacts()) {
      if (c.a.kind == physics::BodyKind::product && c.a.row == plan_.product &&
          c.b.kind == physics::BodyKind::actor)
        result.squeeze_n += c.normal_n;
    }
    result.held = result.squeeze_n > 0 && result.slip_m < held_slip_m && result.raised_m > 0;
    for (const std::uint32_t row : world_->moved_products()) {
      const Vec3 from = scene::world_from_product(scene_.products[row]).position;
      if (row != plan_.product && length(world_->product_pose(row).position - from) > moved_m)
        ++result.neighbours_moved;
    }
    std::set<std::uint32_t> toppled;
    for (const physics::WorldEvent& event : world_->take_events()) {
      if (event.kind == physics::EventKind::toppled && event.product != plan_.product)
        toppled.insert(event.product);
    }
    result.neighbours_toppled = static_cast<int>(toppled.size());
    return result;
  }

 private:
  Pose start_pose() const { return scene::world_from_product(scene_.products[plan_.product]); }

  Pose tip_from_product() const {
    const int frame = robot_.tools[static_cast<std::size_t>(plan_.tool)].frame;
    const Pose tip = plan_.world_from_base *
                     robots::frame_pose(robot_, controller_.actor().position(*world_), frame);
    return inverse(tip) * world_->product_pose(plan_.product);
  }

  Result<void> step(CollectPhase phase, double opening_m, double force_n) {
    if (watch_ && world_->time_s() >= next_watch_s_) {
      MARKETGEN_CHECK(watch_(*world_, controller_.actor(), phase));
      next_watch_s_ += watch_every_s_;
    }
    reference_.grips[static_cast<std::size_t>(plan_.tool)] = {opening_m, force_n};
    MARKETGEN_CHECK(controller_.command(*world_, reference_));
    MARKETGEN_CHECK(world_->step());
    controller_.feel(*world_);
    return {};
  }

  Result<void> follow(const motion::JointTrajectory& way,
                      CollectPhase phase,
                      double opening_m,
                      double force_n) {
    const robots::JointGroup& group = *robot_.find_group(plan_.group);
    const double from_s = world_->time_s();
    for (double t = 0; t < way.duration_s(); t = world_->time_s() - from_s) {
      const motion::TrajectoryState now = way.at(t + physics::time_step_s);
      for (std::size_t j = 0; j < group.dofs.size(); ++j)
        reference_.joints[static_cast<std::size_t>(group.dofs[j])] = {now.position[j],
                                                                      now.velocity[j]};
      MARKETGEN_CHECK(step(phase, opening_m, force_n));
    }
    for (robots::Setpoint& joint : reference_.joints)
      joint.velocity = 0;
    return {};
  }

  Result<void> wait(double time_s, CollectPhase phase, double force_n) {
    for (int i = 0; i < static_cast<int>(time_s / physics::time_step_s); ++i)
      MARKETGEN_CHECK(step(phase, 0, force_n));
    return {};
  }

  const scene::Scene& scene_;
  const robots::Robot& robot_;
  const CollectPlan& plan_;
  const CollectWatch& watch_;
  double watch_every_s_, next_watch_s_ = 0;
  physics::RobotActorOptions place_;
  std::unique_ptr<physics::World> world_;
  physics::RobotController controller_;
  physics::RobotReference reference_;
  Pose tip_from_product_;  // when the fingers had closed
};

}  // namespace

Result<CollectResult> run_collect(const scene::Scene& scene,
                                  const robots::Robot& robot,
                                  const CollectPlan& plan,
                                  const std::vector<catalog::FrictionRow>& frictions,
                                  const CollectWatch& watch,
                                  double watch_every_s) {
  Run run(scene, robot, plan, watch, watch_every_s);
  MARKETGEN_CHECK(run.start(frictions));
  MARKETGEN_CHECK(run.carry_out());
  return run.result();
}

}  // namespace marketgen::collect
