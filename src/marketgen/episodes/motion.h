// What moved in an episode that was run, to be watched without running it again: market-motion/1.
//
// A FlatBuffer (schemas/market-motion-1.fbs) packed with gzip. The robot is there at every control
// step, step 0 being the beginning. Of all else a row is there where it had moved since its row
// before, by more than `moved_m`, `turned_rad` or, of joints, `joint_moved`: until the next it
// stands still. Frame of everything: the store's, metres, radians, unit quaternions.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/moved_thing.h"

namespace marketgen::episodes {

inline constexpr char motion_file_identifier[] = "MGM1";
inline constexpr double moved_m = 1e-4, turned_rad = 1e-3, joint_moved = 1e-3;
inline constexpr std::size_t pose_numbers = 7;  // x, y, z, then the quaternion w, x, y, z

struct ThingMotion {
  ThingKind kind = ThingKind::item;
  std::uint32_t number = 0;
  std::string sku;
  std::vector<std::uint32_t> steps;
  std::vector<float> poses;
  static constexpr auto fields = field_list(
      field("kind", &ThingMotion::kind, "what it is"),
      field("number", &ThingMotion::number, "of the item, or row of the scene's products"),
      field("sku", &ThingMotion::sku, "product; none of a basket"),
      field("steps", &ThingMotion::steps, "at which it had moved, the first where it was seen"),
      field("poses", &ThingMotion::poses, "7 a step: x, y, z, quaternion w, x, y, z"));
};

struct JointMotion {
  std::uint32_t joint = 0;
  std::vector<std::uint32_t> steps;
  std::vector<float> positions;
  static constexpr auto fields =
      field_list(field("joint", &JointMotion::joint, "row of the scene's joints"),
                 field("steps", &JointMotion::steps, "at which it had moved, the first is 0"),
                 field("positions", &JointMotion::positions, "radians, metres or, of belts, m/s"));
};

// What happened in an episode. held: by a tool. contact: the robot, or what it holds, pressed on
// something. The others are those of the side-effect ledger (episodes/side_effects.h).
enum class MotionEventKind {
  held,
  contact,
  toppled,
  dropped,
  displaced,
  base_collision,
  protective_stop
};
constexpr std::array<std::string_view, 7> names_of(MotionEventKind) {
  return {
      "held", "contact", "toppled", "dropped", "displaced", "base_collision", "protective_stop"};
}
// To what. other: the basket at a counter, or the robot itself.
enum class EventTarget { nothing, item, product, fixture, room, other };
constexpr std::array<std::string_view, 6> names_of(EventTarget) {
  return {"nothing", "item", "product", "fixture", "room", "other"};
}

struct MotionEvent {
  MotionEventKind kind = MotionEventKind::held;
  std::uint32_t step = 0, last_step = 0;
  EventTarget target = EventTarget::nothing;
  std::uint32_t number = 0;
  std::string sku;
  double force_n = 0;
  static constexpr auto fields = field_list(
      field("kind", &MotionEvent::kind, "what happened"),
      field("step", &MotionEvent::step, "control step in which it was first so"),
      field("last_step", &MotionEvent::last_step, "in which it was last so"),
      field("target", &MotionEvent::target, "to what"),
      field("number", &MotionEvent::number, "of an item or product, as things have it"),
      field("sku", &MotionEvent::sku, "of an item or product"),
      field("force_n", &MotionEvent::force_n, "of a contact: the greatest, mean over 10 ms, N"));
};

// `track` and what follows it was added later: in files of before it is empty.
struct Motion {
  std::string schema = "market-motion/1";
  std::string episode, episode_hash, scene_hash, policy, realism, robot;
  double step_s = 0;
  std::vector<double> store_from_robot;
  std::vector<std::string> dofs;
  std::vector<float> states;
  std::vector<ThingMotion> things;
  std::vector<JointMotion> joints;
  std::string track, station, lane, tools, instruction;
  std::vector<MotionEvent> events;
  static constexpr auto fields =
      field_list(field("schema", &Motion::schema, "schema tag", constant("market-motion/1")),
                 field("episode", &Motion::episode, "its id"),
                 field("episode_hash", &Motion::episode_hash, "of market-result/1"),
                 field("scene_hash", &Motion::scene_hash, "of the store"),
                 field("policy", &Motion::policy, "who acted"),
                 field("realism", &Motion::realism, "what it was run with"),
                 field("robot", &Motion::robot, "row in data/robots"),
                 field("step_s", &Motion::step_s, "seconds a control step"),
                 field("store_from_robot",
                       &Motion::store_from_robot,
                       "frame of the robot's states: x, y, z, quaternion w, x, y, z"),
                 field("dofs", &Motion::dofs, "names of its degrees of freedom"),
                 field("states", &Motion::states, "a row of the degrees of freedom for each step"),
                 field("things", &Motion::things, "items, moved products and the basket"),
                 field("joints", &Motion::joints, "of the store, that moved"),
                 field("track", &Motion::track, "of the episode; empty in files of before"),
                 field("station", &Motion::station, "as the episode has it"),
                 field("lane", &Motion::lane, "as the episode has it"),
                 field("tools", &Motion::tools, "as the episode has it"),
                 field("instruction", &Motion::instruction, "what the agent was told"),
                 field("events", &Motion::events, "what happened, by their first step"));

  std::size_t steps() const { return dofs.empty() ? 0 : states.size() / dofs.size(); }
};

std::string pack_motion(const Motion& motion);
// Errors: those of gunzip and read_flatbuffer_into; scene.corrupt when its tables do not fit.
Result<Motion> unpack_motion(std::string_view packed, const std::string& source);
Result<Motion> read_motion(const std::filesystem::path& file);

}  // namespace marketgen::episodes
