#include "episodes/source_keys.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

namespace marketgen::episodes {

Result<void> check_source_keys(const std::vector<robots::SourceRow>& sources,
                               const std::string& keys,
                               const std::string& file,
                               const std::string& place) {
  std::istringstream words(keys);
  for (std::string key; words >> key;) {
    if (std::ranges::count(sources, key, &robots::SourceRow::key) == 0)
      return Error{"catalog.bad_row",
                   fmt::format("{}:{}", file, place),
                   fmt::format("there is no source \"{}\" in its sources", key)};
  }
  return {};
}

}  // namespace marketgen::episodes
