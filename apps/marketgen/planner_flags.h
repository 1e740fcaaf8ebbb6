// Who plans, as a flag of commands: offline, or a language model with its limits.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

#include "planners/make_planner.h"

namespace marketgen::app {

// --planner and --planner-url.
void add_planner_choice(CLI::App& command, std::string& planner, planners::PlannerAccess& access);
// The limits of a language model: for each store that it plans.
void add_planner_limits(CLI::App& command, planners::PlannerAccess& access);
// --planner, --planner-url, --record and the limits of a language model.
void add_planner_flags(CLI::App& command,
                       std::string& planner,
                       planners::PlannerAccess& access,
                       std::string& record);

}  // namespace marketgen::app
