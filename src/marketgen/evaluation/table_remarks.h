// What is said beside tables and rankings of runs, the same in each: what they lack, and where
// published figures in them are from.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "robots/robot_row.h"

namespace marketgen::evaluation {

constexpr std::string_view ranking_realism = "standard";  // at which rankings are meant to be

// Where no run is of a policy that knows nothing of what is asked for (environments::is_floor).
std::string no_floor_remark();

// Of runs at that realism; empty: there is nothing to be said.
std::string realism_remark(std::string_view realism);

// Both, as far as they are true.
std::vector<std::string> table_remarks(bool has_floor, std::string_view realism);

// Those that rows name; `keys`: of each row its keys, by blanks.
std::vector<robots::SourceRow> cited_sources(const std::vector<robots::SourceRow>& sources,
                                             const std::vector<std::string>& keys);

}  // namespace marketgen::evaluation
