// The oracle of In-Aisle Item Collection: knows where everything is. It drives to the nearest goal,
// takes it off its shelf with the arm on that side, lets it down into its basket, and goes on;
// three tries an item.
#pragma once
#include <memory>

#include "agent/policy.h"
#include "episodes/aisle/aisle_world.h"
#include "oracle/oracle_search.h"

namespace marketgen::oracle {

// `world` is looked at whenever the oracle acts, and must outlive it; it was reset. Errors: those
// of load_grasp_tool.
Result<std::unique_ptr<agent::Policy>> make_aisle_oracle(const episodes::AisleWorld& world,
                                                         const std::filesystem::path& data,
                                                         Seed seed,
                                                         const OracleSearch& search = {});

}  // namespace marketgen::oracle
