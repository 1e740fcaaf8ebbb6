// A running episode, whatever its track: act, be judged. Each track's world adds its reset and the
// truth that oracles may look at.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "agent/policy.h"
#include "episodes/command_link.h"
#include "episodes/episode_result.h"
#include "episodes/episode_watch.h"
#include "episodes/late_senses.h"
#include "episodes/moved_thing.h"
#include "episodes/realism.h"
#include "episodes/robot_senses.h"
#include "physics/world/robot_controller.h"

namespace marketgen::episodes {

constexpr double control_step_s = 0.05;

class TrackView;  // episodes/track_view.h
#define MARKETGEN_TRACK(name, Type) class Type##World;
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK

template <class, class... Worlds>
struct OneOfWorlds {
  using type = std::variant<const Worlds*...>;
};
// A world of any track, to be visited by what differs from track to track in higher modules:
// std::visit wants an answer for each track of the list.
using AnyWorld = OneOfWorlds<void
#define MARKETGEN_TRACK(name, Type) , Type##World
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
                             >::type;

// Physics 500 Hz, control 20 Hz. A function of its episode, of its realism and of its actions: bit
// for bit, in any process. Not thread-safe; one a thread.
class TrackWorld {
 public:
  virtual ~TrackWorld() = default;
  virtual const EpisodeSpec& spec() const = 0;
  virtual const robots::Robot& robot() const = 0;
  // As the robot's sensors tell it, which is as its realism says.
  agent::Observation observe() const { return senses_.told(late_.told(as_it_is()), steps()); }
  // One control step. Error episode.bad_action: not finite, another number of values, or after the
  // end; the world is then as before. physics.failed.
  virtual Result<agent::Observation> step(const agent::Action& action) = 0;
  virtual bool done() const = 0;  // the agent stopped, or the time is over
  virtual double time_s() const = 0;
  virtual int steps() const = 0;
  virtual std::vector<double> robot_state() const = 0;  // of all degrees of freedom
  // What it was reset with, and the seed of what is drawn for that.
  const Realism& realism() const { return realism_; }
  Seed noise() const { return noise_; }
  // Where everything stood in the picture that a camera of the robot gives now: scenery(), or that
  // of a while ago.
  Scenery pictured() const { return late_.pictured() ? *late_.pictured() : scenery(); }
  // Of all degrees of freedom, the commanded joints as observe() has them: what the robot's own
  // kinematics go by.
  std::vector<double> sensed_state() const;
  // Of the commanded joints: where their drives are told to be, which is where the last action
  // wanted them as far as the limits of the robot's row allow.
  std::vector<double> told() const;
  // Called after every step of physics, until it is replaced: for tests and recordings.
  using PhysicsWatch = std::function<void(const mjModel_&, const mjData_&)>;
  void watch_physics(PhysicsWatch watch) { physics_watch_ = std::move(watch); }
  // Waits for the judgement, and judges. Names, times and failure code are the caller's to add.
  virtual Result<EpisodeResult> finish() = 0;
  virtual std::string state_hash() const = 0;  // 32 hex digits over the physics

  // All goals are met as things stand: those of finish() without its waiting. Errors: assets.*.
  virtual Result<bool> goals_met() = 0;

  // A moment, for a world that was reset to the same episode with the same realism, of this process
  // or another: it then goes on bit for bit as this one does. A twin goes on from it with noise of
  // its own. Error of restore, and the world is as before:
  // physics.bad_command, it is of another episode.
  virtual std::string save() const = 0;
  virtual Result<void> restore(std::string_view moment) = 0;

  // ---- The truth, as it is for the oracle, pictures and tests. ----

  virtual Scenery scenery() const = 0;
  virtual const physics::RobotController& controller() const = 0;
  // MuJoCo's own model and what moves in it.
  virtual const mjModel_& model() const = 0;
  virtual const mjData_& data() const = 0;
  virtual AnyWorld any() const = 0;
  // What scenery() has beside the robot, named: items and baskets, and the products of its place
  // that were moved at some time.
  virtual std::vector<MovedThing> things() const = 0;
  // A product of its place's scene, by the row there, as things() has it; where it stands is left
  // out.
  virtual MovedThing thing_of(std::uint32_t product) const = 0;
  virtual const EpisodeWatch& watch() const = 0;
  // Of doors, drawers and belts of its place: World::joint_positions().
  virtual std::vector<double> joint_positions() const = 0;
  // The frame of robot_state(): the robot's row, in the frame of the store.
  virtual Pose store_from_robot() const = 0;
  // Of the episode that runs; the world must outlive it. Errors: those of Renderer::create.
  virtual Result<std::unique_ptr<TrackView>> open_view() const = 0;

 protected:
  virtual agent::Observation as_it_is() const = 0;
  // Once the robot stands at its beginning. `truth` and `reckoned`: as of RobotSenses.
  void start_senses(const robots::BasePlace& truth, const robots::BasePlace& reckoned);
  // After the `step`-th step of physics of a control step, from 1 on.
  void sense(int step) {
    late_.pass(
        step, [this] { return as_it_is(); }, [this] { return scenery(); });
  }

  PhysicsWatch physics_watch_;
  Realism realism_;
  Seed noise_{0};
  RobotSenses senses_;
  LateSenses late_;
  CommandLink link_;
};

// Degrees of freedom that actions command: all but a base's, and those of fingers.
std::vector<int> commanded_dofs(const robots::Robot& robot);

// Between the pads of each tool; 0 for a cup, and of pads that press on one another.
std::vector<double> tool_openings_m(const robots::Robot& robot, const std::vector<double>& state);

// The action that keeps everything where it is.
agent::Action still_action(const agent::Observation& now);

// Error episode.bad_action, with what is wrong. `done`: the episode is over.
Result<void> check_action(const agent::Action& action,
                          const robots::Robot& robot,
                          std::size_t joints,
                          bool done);

}  // namespace marketgen::episodes
