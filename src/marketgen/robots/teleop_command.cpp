#include "robots/teleop_command.h"

#include <algorithm>

namespace marketgen::robots {

bool TeleopCommand::moves() const {
  const auto any = [](const auto& values) {
    return std::ranges::any_of(values, [](double value) { return value != 0; });
  };
  return drive != 0 || turn != 0 || any(move) || any(twist) || any(joints) ||
         grip != TeleopGrip::keep;
}

}  // namespace marketgen::robots
