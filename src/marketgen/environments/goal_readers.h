// What reads a goal's words for `classical`.
#pragma once
#include <memory>
#include <vector>

#include "catalog/catalog.h"
#include "environments/policy_name.h"
#include "episodes/episode_spec.h"
#include "perception/goal_reader.h"

namespace marketgen::environments {

// The truth where the name says so, else the catalogue's words; none for goals that are told by
// SKU. `stock`: what the store sells.
std::unique_ptr<perception::GoalReader> goal_reader(const PolicyName& name,
                                                    const episodes::EpisodeSpec& spec,
                                                    const std::vector<catalog::Product>& stock,
                                                    const catalog::Catalog& catalog);

}  // namespace marketgen::environments
