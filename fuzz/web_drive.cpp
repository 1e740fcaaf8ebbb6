// Messages of pages that drive: whatever they are, what is taken of one is within its limits.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/json.h"
#include "web/drive_message.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  const auto message = io::read_json<web::DriveMessage>(
      std::string_view(reinterpret_cast<const char*>(data), size), "message");
  if (!message.ok()) return 0;
  const robots::TeleopCommand& command = message->command;
  const auto within = [](double share) { return std::abs(share) <= 1; };  // a NaN is not
  const bool bounded =
      within(command.drive) && within(command.turn) && std::ranges::all_of(command.move, within) &&
      std::ranges::all_of(command.twist, within) && std::ranges::all_of(command.joints, within) &&
      command.joints.size() <= 16 && command.arm >= 0 && command.arm <= 7;
  if (!bounded) std::abort();
  return 0;
}
