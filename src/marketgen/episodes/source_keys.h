// Sources of the figures in rows of data/benchmark.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "robots/robot_row.h"

namespace marketgen::episodes {

// Whether every key of `keys` (by blanks) is among `sources`. Error: catalog.bad_row at
// "FILE:PLACE".
Result<void> check_source_keys(const std::vector<robots::SourceRow>& sources,
                               const std::string& keys,
                               const std::string& file,
                               const std::string& place);

}  // namespace marketgen::episodes
