// Recorded motion for marketgen/motion.py, and logs of drives for marketgen/recording: texts and
// numbers as Python has them, arrays as bytes.
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "binding.h"
#include "episodes/drive_log.h"
#include "episodes/motion.h"

namespace marketgen::python {
namespace {

template <class T>
nb::bytes bytes_of(const std::vector<T>& values) {
  return nb::bytes(values.data(), values.size() * sizeof(T));
}

nb::dict dict_of(const episodes::ThingMotion& thing) {
  nb::dict made;
  made["kind"] = std::string(name_of(thing.kind));
  made["number"] = thing.number;
  made["sku"] = thing.sku;
  made["steps"] = bytes_of(thing.steps);
  made["poses"] = bytes_of(thing.poses);
  return made;
}

nb::dict dict_of(const episodes::JointMotion& joint) {
  nb::dict made;
  made["joint"] = joint.joint;
  made["steps"] = bytes_of(joint.steps);
  made["positions"] = bytes_of(joint.positions);
  return made;
}

nb::dict dict_of(const episodes::MotionEvent& event) {
  nb::dict made;
  made["kind"] = std::string(name_of(event.kind));
  made["step"] = event.step;
  made["last_step"] = event.last_step;
  made["target"] = std::string(name_of(event.target));
  made["number"] = event.number;
  made["sku"] = event.sku;
  made["force_n"] = event.force_n;
  return made;
}

nb::dict read_motion(const std::string& file) {
  const episodes::Motion motion =
      value_or_raise(without_interpreter([&] { return episodes::read_motion(file); }));
  nb::dict made;
  made["episode"] = motion.episode;
  made["episode_hash"] = motion.episode_hash;
  made["scene_hash"] = motion.scene_hash;
  made["policy"] = motion.policy;
  made["realism"] = motion.realism;
  made["robot"] = motion.robot;
  made["step_s"] = motion.step_s;
  made["store_from_robot"] = motion.store_from_robot;
  made["dofs"] = motion.dofs;
  made["states"] = bytes_of(motion.states);
  made["track"] = motion.track;
  made["station"] = motion.station;
  made["lane"] = motion.lane;
  made["tools"] = motion.tools;
  made["instruction"] = motion.instruction;
  nb::list things, joints, events;
  for (const episodes::ThingMotion& thing : motion.things)
    things.append(dict_of(thing));
  for (const episodes::JointMotion& joint : motion.joints)
    joints.append(dict_of(joint));
  made["things"] = things;
  for (const episodes::MotionEvent& event : motion.events)
    events.append(dict_of(event));
  made["joints"] = joints;
  made["events"] = events;
  return made;
}

// What a person drove. "episodes": an episodes file with that one, as text.
nb::dict read_drive(const std::string& file) {
  const episodes::DriveFile drive =
      value_or_raise(without_interpreter([&] { return episodes::read_drive(file); }));
  const episodes::EpisodeSpec& spec = drive.episode.episodes.front();
  nb::dict made;
  made["episode"] = spec.id;
  made["episodes"] = episodes::write_episodes(drive.episode);
  made["control_mode"] = drive.log.control_mode;
  made["realism"] = drive.log.realism;
  made["action_names"] = drive.log.action_names;
  made["actions"] = bytes_of(drive.log.actions);
  made["over"] = drive.log.over;
  made["success"] = drive.log.success;
  made["state_hash"] = drive.log.state_hash;
  return made;
}

}  // namespace

void add_motions(nb::module_& module) {
  module.def("read_motion", &read_motion);
  module.def("read_drive", &read_drive);
}

}  // namespace marketgen::python
