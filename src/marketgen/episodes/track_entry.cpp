#include "episodes/track_entry.h"

#include <array>

namespace marketgen::episodes {

const TrackEntry& entry_of(Track track) {
  static const std::array entries{
#define MARKETGEN_TRACK(name, Type) &name##_entry(),
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
  };
  return *entries[static_cast<std::size_t>(track)];
}

}  // namespace marketgen::episodes
