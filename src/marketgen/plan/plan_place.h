// Places in a plan, for errors.
#pragma once
#include <string>

#include "base/result.h"

namespace marketgen::plan {

// The same error at "FILE:/pointer" when it is at a place in the plan alone
// ("/overrides/0/fixture"): later stages know the plan, not the file that it was read from.
Error in_plan_file(Error error, const std::string& file);

}  // namespace marketgen::plan
