#include "environments/environment_entry.h"

#include <array>

namespace marketgen::environments {

const EnvironmentEntry& environment_entry_of(episodes::Track track) {
  static const std::array entries{
#define MARKETGEN_TRACK(name, Type) &name##_environment_entry(),
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
  };
  return *entries[static_cast<std::size_t>(track)];
}

}  // namespace marketgen::environments
