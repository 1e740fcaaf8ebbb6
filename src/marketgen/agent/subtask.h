// The parts that a task's work falls into, step by step: the labels that demonstrations carry.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace marketgen::agent {

// What the robot does in a control step. The order is that of `subtask_index` in datasets.
//
// none     nothing; or the policy does not say
// drive    the base to where something is to be done, or away from there
// look     cameras to where something is to be seen
// reach    the empty hand, opened, to what is to be taken
// grasp    the tool shuts, or sucks
// lift     what is held, off or out of where it stood
// place    what is held, to where it belongs, and lets go
// retreat  the empty hand away
// recover  back from a protective stop or a contact, the way it came
enum class Subtask : std::uint8_t {
  none,
  drive,
  look,
  reach,
  grasp,
  lift,
  place,
  retreat,
  recover
};
constexpr std::array<std::string_view, 9> names_of(Subtask) {
  return {"none", "drive", "look", "reach", "grasp", "lift", "place", "retreat", "recover"};
}

}  // namespace marketgen::agent
