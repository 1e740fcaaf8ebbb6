// What a page that drives a robot sends, one message at a time. docs/viewer.md describes them.
#pragma once
#include <array>
#include <string_view>

#include "base/fields.h"
#include "robots/teleop_command.h"

namespace marketgen::web {

// What a page asks for beside moving. go: time runs (it does by itself at the first movement).
// done: the driver says that the task is done; the episode is judged. reset: from its beginning.
// save: the log. take: drive, where nobody does.
enum class DriveVerb { move, go, pause, done, reset, save, take };
constexpr std::array<std::string_view, 7> names_of(DriveVerb) {
  return {"move", "go", "pause", "done", "reset", "save", "take"};
}

struct DriveMessage {
  DriveVerb verb = DriveVerb::move;
  robots::TeleopCommand command;
  static constexpr auto fields = field_list(field("verb", &DriveMessage::verb, "what is asked for"),
                                            field("command", &DriveMessage::command, "of move"));
};

}  // namespace marketgen::web
