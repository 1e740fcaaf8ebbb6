#include "evaluation/motion_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "episodes/track_world.h"
#include "geometry/rotation_axes.h"
#include "io/file.h"

namespace marketgen::evaluation {
namespace {

using PoseNumbers = std::array<float, episodes::pose_numbers>;

template <class Number>
std::array<Number, episodes::pose_numbers> numbers_of(const Pose& pose) {
  const Vec3& p = pose.position;
  const Quaternion& q = pose.rotation;
  return {static_cast<Number>(p.x),
          static_cast<Number>(p.y),
          static_cast<Number>(p.z),
          static_cast<Number>(q.w),
          static_cast<Number>(q.x),
          static_cast<Number>(q.y),
          static_cast<Number>(q.z)};
}

// Between the last that is written and the next.
bool has_moved(const float* before, const PoseNumbers& now) {
  const Vec3 apart{before[0] - now[0], before[1] - now[1], before[2] - now[2]};
  const double turned =
      turn_between({before[3], before[4], before[5], before[6]}, {now[3], now[4], now[5], now[6]});
  return length(apart) > episodes::moved_m || turned > episodes::turned_rad;
}

}  // namespace

std::filesystem::path motion_file(const std::filesystem::path& results,
                                  const std::string& episode) {
  return results / "motion" / (episode + ".bin.gz");
}

Result<void> MotionRecorder::begin(const episodes::TrackWorld& world) {
  world_ = &world;
  motion_ = {};
  places_.clear();
  joint_places_.clear();
  motion_.robot = world.spec().robot;
  motion_.step_s = episodes::control_step_s;
  const auto frame = numbers_of<double>(world.store_from_robot());
  motion_.store_from_robot.assign(frame.begin(), frame.end());
  for (std::size_t dof = 0; dof < world.robot().dof_count(); ++dof)
    motion_.dofs.push_back(world.robot().joint_of_dof(dof).name);
  const episodes::EpisodeSpec& spec = world.spec();
  motion_.track = name_of(spec.track);
  motion_.station = spec.station.value_or("");
  motion_.lane = spec.lane.value_or("");
  motion_.tools = spec.tools;
  motion_.instruction = spec.instruction;
  joints_ = world.joint_positions();
  events_.begin(world);
  look();
  return {};
}

Result<void> MotionRecorder::step() {
  look();
  return {};
}

void MotionRecorder::look() {
  const auto step = static_cast<std::uint32_t>(motion_.steps());
  for (const double value : world_->robot_state())
    motion_.states.push_back(static_cast<float>(value));
  for (const episodes::MovedThing& thing : world_->things())
    see(thing, step);
  see_joints(step);
  if (step > 0) events_.look(step);
}

void MotionRecorder::see(const episodes::MovedThing& thing, std::uint32_t step) {
  const auto [place, is_new] =
      places_.try_emplace({thing.kind, thing.number}, motion_.things.size());
  if (is_new) motion_.things.push_back({thing.kind, thing.number, thing.sku, {}, {}});
  episodes::ThingMotion& motion = motion_.things[place->second];
  const PoseNumbers now = numbers_of<float>(thing.store_from_thing);
  if (!is_new && !has_moved(&*(motion.poses.end() - episodes::pose_numbers), now)) return;
  motion.steps.push_back(step);
  motion.poses.insert(motion.poses.end(), now.begin(), now.end());
}

void MotionRecorder::see_joints(std::uint32_t step) {
  const std::vector<double> now = world_->joint_positions();
  for (std::uint32_t joint = 0; joint < now.size(); ++joint) {
    if (std::abs(now[joint] - joints_[joint]) <= episodes::joint_moved) continue;
    const auto [place, is_new] = joint_places_.try_emplace(joint, motion_.joints.size());
    if (is_new) motion_.joints.push_back({joint, {0}, {static_cast<float>(joints_[joint])}});
    episodes::JointMotion& motion = motion_.joints[place->second];
    motion.steps.push_back(step);
    motion.positions.push_back(static_cast<float>(now[joint]));
    joints_[joint] = now[joint];
  }
}

std::string MotionRecorder::packed(const episodes::EpisodeResult& result,
                                   const std::string& episode_hash) {
  motion_.episode = result.episode;
  motion_.episode_hash = episode_hash;
  motion_.scene_hash = result.scene_hash;
  motion_.policy = result.policy;
  motion_.realism = result.realism;
  motion_.events = events_.events();
  return episodes::pack_motion(motion_);
}

}  // namespace marketgen::evaluation
