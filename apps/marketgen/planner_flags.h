// Who plans, as a flag of commands: offline, or a language model with its limits.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

#include "planners/make_planner.h"

namespace marketgen::app {

// --planner, --planner-url, --record and the limits of a language model.
void add_planner_flags(CLI::App& command,
                       std::string& planner,
                       planners::PlannerAccess& access,
                       std::string& record);

}  // namespace marketgen::app
