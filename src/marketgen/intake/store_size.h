// How large a store may be.
#pragma once
#include <string>

#include "base/result.h"

namespace marketgen::intake {

// The limits of Shell::width_mm and depth_mm in market-plan/1.
constexpr double min_store_side_mm = 4000;
constexpr double max_store_side_mm = 200000;

// brief.bad_size unless both sides can be built.
Result<void> check_store_size(double width_mm, double depth_mm, const std::string& where);

// "24", "13.4": metres with at most one decimal, for messages.
std::string metres(double mm);

}  // namespace marketgen::intake
