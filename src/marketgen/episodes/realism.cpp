#include "episodes/realism.h"

#include <utility>

#include <fmt/format.h>

#include "episodes/named_dials.h"
#include "episodes/realism_rows.h"

namespace marketgen::episodes {
namespace {

Result<void> check_realism(const Realism& read, const std::string& called) {
  const LatencyDials& late = read.latency;
  for (const auto& [name, dials] : {std::pair{"commands", late.commands},
                                    std::pair{"images", late.images},
                                    std::pair{"readings", late.readings}})
    if (dials.max_s < dials.min_s)
      return Error{
          "catalog.bad_row",
          fmt::format("{}:/latency/{}/max_s", called, name),
          fmt::format("is {}, less than min_s, {}: give the larger one", dials.max_s, dials.min_s)};
  return {};
}

}  // namespace

Result<Realism> load_realism(const std::filesystem::path& data, const std::string& asked) {
  return load_named_dials<Realism>(data, {"realism", realism_rows}, asked, check_realism);
}

}  // namespace marketgen::episodes
