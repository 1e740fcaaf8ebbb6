// The oracle of Checkout Unloading: knows where everything is, and uses the same executor as every
// other policy. Its strategy (docs/episodes.md, "The oracle"): grasps from all sides
// against a ghost of the hand, what lies over a target cleared first, what is held measured again
// and put down in a stable way, three tries an item.
#pragma once
#include <memory>

#include "agent/policy.h"
#include "episodes/checkout/checkout_world.h"
#include "oracle/oracle_search.h"

namespace marketgen::oracle {

// `world` is looked at whenever the oracle acts, and must outlive it. Errors: of load_grasp_tool
// and ArmExecutor.
Result<std::unique_ptr<agent::Policy>> make_checkout_oracle(const episodes::CheckoutWorld& world,
                                                            const std::filesystem::path& data,
                                                            Seed seed,
                                                            const OracleSearch& search = {});

}  // namespace marketgen::oracle
