// Episodes of the stages of In-Aisle Item Collection. They go by the witness of an episode's
// certificate, so that there is a way to do them. Store frame, SI units.
#pragma once
#include <optional>
#include <vector>

#include "base/seed.h"
#include "episodes/aisle/aisle_store.h"
#include "episodes/stage.h"
#include "robots/grasp_tool.h"

namespace marketgen::episodes {

// One of the goals of `whole`, drawn with its witness. Stage::drive begins where a way of 1 to 4 m
// leads to the witness's place, heading anywhere; Stage::pick there, 2 cm and 2 degrees off at
// most. Errors episode.impossible: it has no witness, nothing is free, or what Stage::pick is to
// take stands behind doors.
Result<EpisodeSpec> aisle_stage(const AisleStore& store,
                                const EpisodeSpec& whole,
                                Stage stage,
                                Seed seed);

// A place off `stand` by no more than `most` along each axis, where the robot as it drives stands
// free; none when there is none.
std::optional<FloorPlaceRow> a_little_off(const AisleStore& store,
                                          const FloorPlaceRow& stand,
                                          Stream& draw,
                                          const FloorPlaceRow& most);

// The first pick of its witness. Error episode.impossible: there is none.
Result<WitnessPick> witness_of(const EpisodeSpec& spec);

// The row of the product that the witness takes. Errors: that of witness_of; episode.impossible, it
// is no product of the front row here.
Result<std::uint32_t> witnessed_product(const AisleStore& store, const EpisodeSpec& spec);

// Every degree of freedom with the open hand 12 cm before its grasp, on the line by which the
// witness takes the product, and the lift as high as that needs. `tool`: what the station picks
// with. Errors: those of witnessed_product, studied_grasps and plan_collect.
Result<std::vector<double>> hand_before_product(const AisleStore& store,
                                                const EpisodeSpec& spec,
                                                const robots::GraspTool& tool,
                                                const std::vector<catalog::FrictionRow>& frictions);

}  // namespace marketgen::episodes
