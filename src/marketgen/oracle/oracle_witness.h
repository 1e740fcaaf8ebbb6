// Shows that a basket of Checkout Unloading can be worked off: an order in which its targets, and
// what is in their way, can be taken, each by a grasp that nothing hinders, reached by a way that
// meets nothing, and put down. Everything lies as it was poured; nothing is pushed.
#pragma once
#include <filesystem>

#include "episodes/checkout/sample_checkout.h"

namespace marketgen::oracle {

// Errors, when it is called: those of load_grasp_tool, ArmExecutor::make and grasp_candidates.
episodes::CheckoutCertifier checkout_certifier(const std::filesystem::path& data);

}  // namespace marketgen::oracle
