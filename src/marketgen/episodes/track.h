// The tracks of the benchmark, by name: one a line of episodes/tracks.inc.
#pragma once
#include <array>
#include <string_view>

#include "base/result.h"

namespace marketgen::episodes {

enum class Track {
#define MARKETGEN_TRACK(name, Type) name,
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
};

inline constexpr std::array all_tracks{
#define MARKETGEN_TRACK(name, Type) Track::name,
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
};

constexpr std::array<std::string_view, all_tracks.size()> names_of(Track) {
  return {
#define MARKETGEN_TRACK(name, Type) #name,
#include "episodes/tracks.inc"
#undef MARKETGEN_TRACK
  };
}

// Error: episode.unknown_track, with those there are.
Result<Track> track_named(std::string_view name);

}  // namespace marketgen::episodes
