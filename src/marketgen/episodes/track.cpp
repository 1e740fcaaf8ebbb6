#include "episodes/track.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/fields.h"
#include "base/text.h"

namespace marketgen::episodes {

Result<Track> track_named(std::string_view name) {
  if (const auto track = value_named<Track>(name)) return *track;
  return Error{"episode.unknown_track",
               std::string(name),
               fmt::format("there is no such track{}; there are: {}",
                           did_you_mean(name, names_of(Track{})),
                           fmt::join(names_of(Track{}), ", "))};
}

}  // namespace marketgen::episodes
