// What a policy may see and do: the one interface behind which every agent stands.
//
// A policy is asked once every control step (20 Hz). It sees observations only; what it must not
// know (poses, ids, goals) is not in them. World frame of a track as its rows say; SI units.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agent/decision.h"
#include "agent/model_use.h"
#include "agent/part_use.h"
#include "agent/subtask.h"
#include "base/result.h"
#include "motion/base_follower.h"
#include "robots/wheel_drive.h"

namespace marketgen::agent {

// A robot as it is. Joints are those that an action commands: every one but wheels and fingers, in
// the order of the robot's degrees of freedom; rad or m, and a second.
struct Observation {
  double time_s = 0;
  std::vector<double> position, velocity;
  std::vector<double> openings_m;    // between the pads, one a tool; of a cup 0 or cup_off_m
  std::vector<std::uint8_t> sealed;  // one a tool: 1 when a cup has sealed, by its vacuum sensor
  // What presses on each arm that feels contacts (robots::Robot::contact_limits), by the torques of
  // its joints: all contacts of its links with anything else, added as vectors, mean over 10 ms.
  std::vector<double> external_force_n;
  robots::BasePlace base;  // as its wheels' encoders reckon it; zeros of a robot without wheels
  bool stopped = false;    // a protective stop: it takes no command yet
  // What the laser scanner of a base that drives tells of people, in the base's frame (X ahead):
  // those within 4 m whom no fixture hides. Empty where nobody is about.
  std::vector<motion::MovingDisc> people;
};

// Opening of a cup that does not suck.
constexpr double cup_off_m = 0.05;

// Of a gripper, 0 presses with `force_n`, or as hard as the tool can. A cup sucks at 0, with all it
// has, and lets go at anything over 0; what it has lost it takes again only after that, or when its
// lip has come off and lies on something anew.
struct ToolCommand {
  double opening_m = 0;  // between the pads
  double force_n = 20;   // most, on each pad
};

// Until the next control step. Joints go to these targets as far as the limits of the robot's row
// allow, and go on to them in later steps as long as they are told to.
struct Action {
  std::vector<double> position;          // of the joints, as in Observation
  std::vector<ToolCommand> tools;        // one a tool
  double drive_m_s = 0, turn_rad_s = 0;  // of the base, at the end of the step
  bool stop = false;                     // the agent says that it has done: no more steps
};

// So many of this product of the catalogue, whichever of them. Told by its SKU or, with
// instructions in words, by a text alone; the other one is empty then.
struct TaskGoal {
  std::string sku;
  int count = 1;
  std::string text = {};
};

// What the agent is told before it begins.
struct Task {
  std::string instruction;
  double limit_s = 0;
  std::vector<TaskGoal> goals = {};  // what the instruction names
};

class Policy {
 public:
  virtual ~Policy() = default;
  // Once, before the first act().
  virtual Result<void> begin(const Task& task, const Observation& first) = 0;
  virtual Result<Action> act(const Observation& now) = 0;
  // One word for what kept it from its goals: a name of FailureCode; "None" when nothing did.
  virtual std::string failure() const { return "None"; }
  // What it asked of a model outside of the program so far; nothing of one that asks none.
  virtual std::optional<ModelUse> model_use() const { return std::nullopt; }
  // The same of parts of it that run in servers of their own.
  virtual std::optional<PartsUse> parts_use() const { return std::nullopt; }
  // What its last action was for.
  virtual Subtask subtask() const { return Subtask::none; }
  // What it decided so far, once it is told to keep that; null of one that tells nothing.
  virtual DecisionLog* decisions() { return nullptr; }
};

}  // namespace marketgen::agent
