// An episode as reinforcement learning has it: observations and actions as rows of numbers, a
// reward, an end. Both tracks behind one interface; Python's environments are made of these.
//
// A function of its episode and its actions, bit for bit, when every environment is stepped through
// step_all() and reset_all(). Not thread-safe; one a thread.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "environments/control_mode.h"
#include "environments/episode_ground.h"
#include "episodes/track_world.h"
#include "evaluation/run_episode.h"
#include "render/render.h"

namespace marketgen {

// sparse: at the end, the share of the goals. dense: after each step, from 0 to 1, nearer is more;
// 1 when all goals are met.
enum class RewardMode { sparse, dense };
constexpr std::array<std::string_view, 2> names_of(RewardMode) {
  return {"sparse", "dense"};
}

struct EnvironmentOptions {
  ControlMode control = ControlMode::pd_joint_delta_pos;
  RewardMode reward = RewardMode::sparse;
  std::string tools = {};  // in aisles: a tool set of the station, the first when empty
};

// Numbers of an observation that belong together, row-major.
struct ObservationPart {
  std::string group, name;  // "agent", "qpos"
  std::vector<int> shape;
};

struct StepOutcome {
  double reward = 0;
  bool terminated = false;  // the agent stopped
  bool truncated = false;   // the time is over
};

class Environment {
 public:
  // Errors: of the station and its robot.
  static Result<std::unique_ptr<Environment>> create(std::shared_ptr<EpisodeGround> ground,
                                                     Track track,
                                                     const EnvironmentOptions& options);
  virtual ~Environment() = default;

  const std::vector<ActionNumber>& action_numbers() const { return actions_->numbers(); }
  // In this order: agent.qpos (joints, then openings), agent.qvel, extra.tcp_pose (x, y, z, qw, qx,
  // qy, qz in the frame of the robot's base, a row a tool); of a base that drives extra.base_pose
  // (x, y, heading by its own reckoning); of a robot with a cup agent.sealed (1 for each tool that
  // has sealed).
  const std::vector<ObservationPart>& observation_parts() const { return parts_; }
  std::size_t observation_size() const { return size_; }
  virtual std::vector<std::string> cameras() const = 0;

  // Errors: those of EpisodeGround::check and of the track's world; episode.unknown_track.
  Result<void> reset(const EpisodeSpec& spec);
  // Error episode.bad_action: step() would refuse it.
  Result<void> check(std::span<const double> action) const;
  // Errors: as check(), and the environment is as before; physics.failed.
  Result<StepOutcome> step(std::span<const double> action);
  // The result as evaluate() keeps it; an episode that still runs is ended and judged as it stands.
  // `end.in_time` is not read.
  EpisodeResult judged(EpisodeEnd end);
  // Of a running or ended episode; `into` has observation_size() places.
  void observe(std::span<float> into) const;

  // As things stand, from one of cameras(), or "film_camera". Errors: camera.unknown, those of the
  // renderer.
  virtual Result<Frame> picture(const std::string& camera,
                                int width,
                                int height,
                                const RenderOptions& options) = 0;
  virtual Result<Camera> camera(const std::string& camera, int width, int height) = 0;
  // What the agent knows of the place beforehand, as JSON: market-layout/1 of a store; "" of a
  // counter.
  virtual std::string map() const { return ""; }

  EpisodeGround& ground() { return *ground_; }
  const EnvironmentOptions& options() const { return options_; }
  Track track() const { return track_; }
  bool running() const { return world_ != nullptr && !world_->done(); }
  // Of the episode to which it was reset, which must have been done.
  const TrackWorld& world() const { return *world_; }
  const std::optional<EpisodeResult>& result() const { return result_; }  // of one that has ended

 protected:
  Environment(std::shared_ptr<EpisodeGround> ground, Track track, const EnvironmentOptions& options)
      : ground_(std::move(ground)), track_(track), options_(options) {}
  // Once, before anything else.
  void set_robot(const Robot& robot);
  virtual Result<TrackWorld*> begin(const EpisodeSpec& spec) = 0;
  // How near the goals are, mean over them, 0 to 1.
  virtual double nearness() const = 0;

 private:
  double reward() const;
  Result<void> finish();

  std::shared_ptr<EpisodeGround> ground_;
  Track track_;
  EnvironmentOptions options_;
  std::optional<ActionMap> actions_;
  std::vector<ObservationPart> parts_;
  std::size_t size_ = 0;
  TrackWorld* world_ = nullptr;
  std::vector<double> target_;  // of the joints, where the last step left them
  bool in_time_ = true;         // it ended before the time was over
  std::optional<EpisodeResult> result_;
};

}  // namespace marketgen
