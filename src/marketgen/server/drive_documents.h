// What a page that drives a robot asks for at first and is sent (what it sends meanwhile:
// web/drive_message.h). docs/viewer.md describes the addresses.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "episodes/motion.h"
#include "episodes/side_effects.h"
#include "server/replay_things.h"

namespace marketgen::server {

// POST drive/begin
struct DriveAsk {
  std::string track, episode, tools;
  std::uint64_t seed = 0;
  static constexpr auto fields = field_list(
      field("track", &DriveAsk::track, "of the episode that is drawn", at_most_bytes(40)),
      field("episode", &DriveAsk::episode, "of the file; empty: one is drawn", at_most_bytes(200)),
      field("tools", &DriveAsk::tools, "a tool set of the track", at_most_bytes(80)),
      field("seed", &DriveAsk::seed, "of the draw", range(0, 4294967295.0)));
};

struct DriveGoal {
  std::string sku, name, name_zh;
  int count = 0;
  static constexpr auto fields =
      field_list(field("sku", &DriveGoal::sku, "product"),
                 field("name", &DriveGoal::name, "of the product"),
                 field("name_zh", &DriveGoal::name_zh, "in Chinese"),
                 field("count", &DriveGoal::count, "how many are asked for"));
};

struct DriveJoint {
  std::string name, dimension;
  static constexpr auto fields =
      field_list(field("name", &DriveJoint::name, "of no arm: lift, head"),
                 field("dimension", &DriveJoint::dimension, "m or rad"));
};

// The episode that is driven.
struct DriveEpisode {
  std::string id, instruction, robot, tools;
  std::string track;
  int place = -1;
  double step_s = 0, limit_s = 0;
  bool has_base = false;
  std::vector<std::string> arms, bodies, cameras;
  std::vector<DriveJoint> joints;
  std::vector<DriveGoal> goals;
  std::vector<ReplayThing> things;
  static constexpr auto fields = field_list(
      field("id", &DriveEpisode::id, "of the episode"),
      field("instruction", &DriveEpisode::instruction, "what is to be done"),
      field("robot", &DriveEpisode::robot, "row in data/robots"),
      field("tools", &DriveEpisode::tools, "its tool set"),
      field("track", &DriveEpisode::track, "what kind of task"),
      field("place", &DriveEpisode::place, "below places; -1: the store itself"),
      field("step_s", &DriveEpisode::step_s, "seconds a control step"),
      field("limit_s", &DriveEpisode::limit_s, "simulated seconds that there are"),
      field("has_base", &DriveEpisode::has_base, "its base drives"),
      field("arms", &DriveEpisode::arms, "tools by their names, in the order of `arm`"),
      field("bodies", &DriveEpisode::bodies, "of robot.bin; the basket, if there is one, last"),
      field("cameras", &DriveEpisode::cameras, "of which there are pictures"),
      field("joints", &DriveEpisode::joints, "in the order of a command's"),
      field("goals", &DriveEpisode::goals, "one by one"),
      field("things", &DriveEpisode::things, "so far: what is pushed is added"));
};

// An episode of the file that can be driven in the store.
struct DriveOffer {
  std::string id, track, instruction;
  static constexpr auto fields =
      field_list(field("id", &DriveOffer::id, "of the episode"),
                 field("track", &DriveOffer::track, "what kind of task"),
                 field("instruction", &DriveOffer::instruction, "what is to be done"));
};

struct DriveTrack {
  std::string track;
  std::vector<std::string> tools;
  static constexpr auto fields =
      field_list(field("track", &DriveTrack::track, "of which episodes are drawn"),
                 field("tools", &DriveTrack::tools, "tool sets, the first is the usual one"));
};

enum class DrivePhase { idle, opening, driving, failed };
constexpr std::array<std::string_view, 4> names_of(DrivePhase) {
  return {"idle", "opening", "driving", "failed"};
}

// GET drive
struct DriveStatus {
  DrivePhase phase = DrivePhase::idle;
  int generation = 0;
  bool taken = false, watched = false;
  std::string error_code, error;
  std::string logs;
  std::vector<DriveTrack> tracks;
  std::vector<DriveOffer> offers;
  std::optional<DriveEpisode> episode;
  static constexpr auto fields = field_list(
      field("phase", &DriveStatus::phase, "idle, opening, driving or failed"),
      field("generation", &DriveStatus::generation, "counts the episodes that were opened"),
      field("taken", &DriveStatus::taken, "somebody drives"),
      field("watched", &DriveStatus::watched, "a program acts: pages look on"),
      field("error_code", &DriveStatus::error_code, "why the last one failed"),
      field("error", &DriveStatus::error, "likewise, in words"),
      field("logs", &DriveStatus::logs, "folder in which logs are kept"),
      field("tracks", &DriveStatus::tracks, "of which episodes are drawn; none: of the file"),
      field("offers", &DriveStatus::offers, "of the file, in this store"),
      field("episode", &DriveStatus::episode, "that is driven"));
};

// How the judgement went.
struct DriveVerdict {
  bool success = false;
  int hits = 0, asked = 0;
  std::string failure;
  static constexpr auto fields =
      field_list(field("success", &DriveVerdict::success, "all goals"),
                 field("hits", &DriveVerdict::hits, "goals that count"),
                 field("asked", &DriveVerdict::asked, "goals that there are"),
                 field("failure", &DriveVerdict::failure, "what kept it from the goals"));
};

// Beside the poses of a message of state.
struct DriveMoment {
  int generation = 0;
  std::uint32_t step = 0;
  double time_s = 0, speed = 0;
  std::uint64_t bodies = 0, things = 0;
  bool runs = false, stopped = false;
  std::vector<double> openings;
  std::vector<int> reached;
  episodes::SideEffects side_effects;
  std::vector<episodes::MotionEvent> events;
  std::optional<DriveVerdict> verdict;
  static constexpr auto fields = field_list(
      field("generation", &DriveMoment::generation, "of which episode, as in the status"),
      field("step", &DriveMoment::step, "control steps since the beginning"),
      field("time_s", &DriveMoment::time_s, "simulated seconds since then"),
      field("speed", &DriveMoment::speed, "simulated seconds a second; 0: not known"),
      field("bodies", &DriveMoment::bodies, "rows of the robot's bodies, then of the things"),
      field("things", &DriveMoment::things, "how many of them there are"),
      field("runs", &DriveMoment::runs, "time goes on"),
      field("stopped", &DriveMoment::stopped, "the robot makes a protective stop"),
      field("openings", &DriveMoment::openings, "of each tool as told: 1 open, -1 closed"),
      field("reached", &DriveMoment::reached, "of each goal, how many lie in place"),
      field("side_effects", &DriveMoment::side_effects, "the ledger so far"),
      field("events", &DriveMoment::events, "the last few"),
      field("verdict", &DriveMoment::verdict, "once it is over"));
};

// Text messages to a page. you: whether it drives, and whether anybody does. saved: the log's file.
// opened: another episode, or the same from its beginning. error: what was not done, and why.
struct DriveNote {
  std::string kind;
  bool drives = false, taken = false;
  std::string file, code, message;
  static constexpr auto fields =
      field_list(field("kind", &DriveNote::kind, "you, saved, opened or error"),
                 field("drives", &DriveNote::drives, "of you: this page does"),
                 field("taken", &DriveNote::taken, "of you: a page does"),
                 field("file", &DriveNote::file, "of saved"),
                 field("code", &DriveNote::code, "of error"),
                 field("message", &DriveNote::message, "of error"));
};

}  // namespace marketgen::server
