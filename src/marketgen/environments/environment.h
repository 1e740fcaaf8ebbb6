// An episode as reinforcement learning has it: observations and actions as rows of numbers, a
// reward, an end. All tracks behind one interface; Python's environments are made of these.
//
// A function of its episode and its actions, bit for bit, when every environment is stepped through
// step_all() and reset_all(). Not thread-safe; one a thread.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "environments/control_mode.h"
#include "environments/episode_ground.h"
#include "environments/episode_run.h"
#include "environments/goal_progress.h"
#include "environments/observation_parts.h"
#include "episodes/aisle/door_stage.h"
#include "episodes/aisle/way_to_stand.h"
#include "episodes/realism.h"
#include "episodes/stage.h"
#include "episodes/track_world.h"
#include "render/render.h"

namespace marketgen::environments {

// sparse: at the end, the share of the goals. dense: after each step, from 0 to 1, nearer is more;
// 1 when all goals are met. shaped: by how much the step has raised goal_progress(), so that the
// sum over an episode is how far it has come.
enum class RewardMode { sparse, dense, shaped };
constexpr std::array<std::string_view, 3> names_of(RewardMode) {
  return {"sparse", "dense", "shaped"};
}

struct EnvironmentOptions {
  ControlMode control = ControlMode::pd_joint_delta_pos;
  RewardMode reward = RewardMode::sparse;
  std::string tools = {};    // a tool set of the station, the first when empty
  std::string station = {};  // at a counter: a row of data/benchmark, that of the track when empty
  // Of the track's task. Episodes of a stage are those of draw_stage().
  episodes::Stage stage = episodes::Stage::whole;
  bool stop = true;  // an action ends with `stop`; without it the goals' being met is the end
  bool privileged = false;  // observations have the truth, too
  int item_rows = 0;        // of that; 0: as many as any episode of the ground needs
  episodes::Realism realism = {};
};

struct StepOutcome {
  double reward = 0;
  bool terminated = false;  // the agent stopped; without `stop`: the goals are met
  bool truncated = false;   // the time is over
};

class Environment {
 public:
  // Errors: of the station and its robot.
  static Result<std::unique_ptr<Environment>> create(std::shared_ptr<EpisodeGround> ground,
                                                     episodes::Track track,
                                                     const EnvironmentOptions& options);
  virtual ~Environment() = default;

  const std::vector<ActionNumber>& action_numbers() const { return actions_->numbers(); }
  // robot_parts(), then, where asked for, privileged_parts().
  const std::vector<ObservationPart>& observation_parts() const { return parts_; }
  std::size_t observation_size() const { return size_; }
  virtual std::vector<std::string> cameras() const = 0;
  virtual std::vector<std::string> usual_cameras() const {
    return cameras();
  }  // when none is named

  // Errors: those of EpisodeGround::check and of the track's world; episode.unknown_track.
  Result<void> reset(const episodes::EpisodeSpec& spec);
  // Error episode.bad_action: step() would refuse it.
  Result<void> check(std::span<const double> action) const;
  // Errors: as check(), and the environment is as before; physics.failed.
  Result<StepOutcome> step(std::span<const double> action);
  // Of the tools at the last step since reset() or restore(); none before there was one, and in
  // modes of joints.
  const std::vector<ToolCut>& tool_cuts() const { return cuts_; }
  // Of each tool in the frame of the robot's base, as the robot reads its joints.
  std::vector<Pose> tool_poses() const { return actions_->tool_poses(world().sensed_state()); }
  // The robot makes a protective stop and takes no command yet.
  bool robot_stopped() const { return run_ && world().observe().stopped; }
  // The result as evaluate() keeps it; an episode that still runs is ended and judged as it stands.
  // `end.in_time` is not read.
  episodes::EpisodeResult judged(episodes::EpisodeEnd end);
  // Of a running or ended episode; `into` has observation_size() places.
  void observe(std::span<float> into) const;

  // What step() takes to act so from where it is, as near as its numbers can say it. Errors: of
  // ActionMap::values.
  Result<std::vector<double>> numbers_of(const agent::Action& wanted) const {
    return actions_->values(wanted, target_);
  }

  // As things stand, from one of cameras(), or the film's (episodes/track_view.h). Errors:
  // camera.unknown, those of the renderer.
  virtual Result<render::Frame> picture(const std::string& camera,
                                        int width,
                                        int height,
                                        const render::RenderOptions& options) = 0;
  // Its place is in the frame that the observations' base_pose is in: of the station or the store.
  // One that a driving robot carries is where it would be if the robot stood at base_pose.
  virtual Result<render::Camera> camera(const std::string& camera, int width, int height) = 0;
  // By the numbers of pictures: the SKU of each product that they can show.
  virtual Result<std::vector<std::pair<std::uint32_t, std::string>>> products() = 0;
  // What the agent knows of the place beforehand, as JSON: market-layout/1 of a store, with
  // fixtures where its realism's map has them; "" of a counter. Errors: those of
  // AisleWorld::mapped.
  virtual Result<std::string> map() const { return std::string(); }

  // ---- The truth, of a running or ended episode: no policy may look. ----

  // At a counter all that the episode has, in its order; in aisles, for each goal, as many of its
  // product as are asked for: those in the basket, then those next to the robot. Errors: assets.*.
  virtual Result<std::vector<EnvironmentItem>> items() = 0;
  virtual EnvironmentPlace place() const = 0;
  // In aisles, of an episode with a witness. Errors: those of way_to_stand(); usage.bad_flag at a
  // counter.
  virtual Result<episodes::WayToStand> way_to_stand() const;
  // The door that the episode's witness opens, of Stage::open. Errors: those of door_seen();
  // usage.bad_flag at a counter.
  virtual Result<episodes::DoorSeen> door() const;
  // MuJoCo's own model and what moves in it (its qpos, qvel, act, ...: mjSTATE_INTEGRATION).
  const mjModel_& model() const { return world().model(); }
  const mjData_& data() const { return world().data(); }

  // A moment, for an environment with the same episode and the same actions, of this process or
  // another one of this version: it then goes on bit for bit as this one does. Error of restore,
  // and nothing has changed: physics.bad_command, they are no such bytes.
  std::string save() const;
  Result<void> restore(std::string_view moment);

  EpisodeGround& ground() { return *ground_; }
  const EnvironmentOptions& options() const { return options_; }
  episodes::Track track() const { return track_; }
  std::uint64_t resets() const { return resets_; }  // how many there were
  // goal_progress() after the last step, 1 once all is judged done; of RewardMode::shaped.
  double progress() const { return progress_; }
  bool running() const { return run_ && run_->running(); }
  // Of the episode to which it was reset, which must have been done.
  const episodes::TrackWorld& world() const { return run_->world(); }
  // Of an episode that has ended.
  std::optional<episodes::EpisodeResult> result() const {
    return run_ ? run_->result() : std::nullopt;
  }

 protected:
  Environment(std::shared_ptr<EpisodeGround> ground,
              episodes::Track track,
              const EnvironmentOptions& options)
      : ground_(std::move(ground)), track_(track), options_(options) {}
  // Once, before anything else.
  void set_robot(const robots::Robot& robot, const ObservationBounds& bounds);
  // A world that was reset to it, and lives until the next call.
  virtual Result<episodes::TrackWorld*> begin(const episodes::EpisodeSpec& spec) = 0;
  // How near the goals are, mean over them, 0 to 1.
  virtual double nearness() const = 0;
  virtual ProgressScale progress_scale() const = 0;
  // Most that an episode may have, so that observations have one shape.
  int item_rows() const { return item_rows_; }

 private:
  double reward() const;
  double progress_now() const;
  bool succeeded() const;
  Result<void> finish();
  Result<void> check_room(const episodes::EpisodeSpec& spec) const;
  Result<void> look();

  std::shared_ptr<EpisodeGround> ground_;
  episodes::Track track_;
  EnvironmentOptions options_;
  std::optional<ActionMap> actions_;
  std::vector<ObservationPart> parts_;
  std::size_t size_ = 0;
  std::vector<double> low_, high_;  // of the numbers
  std::optional<EpisodeRun> run_;   // since the last reset
  std::uint64_t resets_ = 0;
  std::vector<double> target_;  // of the joints, where the last step left them
  std::vector<ToolCut> cuts_;   // of the last step
  int item_rows_ = 0;
  std::vector<EnvironmentItem> seen_items_;  // after the last step, where they are asked for
  double progress_ = 0;                      // likewise
};

}  // namespace marketgen::environments
