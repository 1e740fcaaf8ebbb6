// A store whose goods stand a little other than the planogram says.
#pragma once
#include <memory>

#include "episodes/aisle/aisle_store.h"
#include "episodes/perturbation.h"

namespace marketgen::episodes {

// Packs that stand by themselves on boards are moved by what is drawn for each, as far as they stay
// on their board and meet no other one. What is stacked, hangs, lies in a heap or behind a door
// stays.
std::shared_ptr<const AisleStore> perturbed_store(const AisleStore& store,
                                                  const Perturbation& perturbation);

}  // namespace marketgen::episodes
