// Episodes of a track's stages, drawn from the episodes of a ground: for learners.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "environments/episode_ground.h"
#include "episodes/stage.h"

namespace marketgen::environments {

// Of one of the ground's episodes, which the seed picks as EpisodeGround::draw does; Stage::place
// of its products, Stage::open of a door of one of its stores. An episode that cannot be begun so
// is passed over. Errors: those of EpisodeGround::draw, aisle_stage, DoorStages::draw and
// sample_one_item; usage.bad_flag for Stage::whole.
Result<episodes::EpisodeSpec> draw_stage(EpisodeGround& ground,
                                         episodes::Stage stage,
                                         const std::string& tools,
                                         std::uint64_t seed);

// How the robot begins an episode of Stage::pick or Stage::open: every degree of freedom, planned
// once for each product or door and place. Errors: those of hand_before_product, load_grasp_tool
// and DoorStages::hand_before_bar.
Result<std::vector<double>> start_of_pick(EpisodeGround& ground, const episodes::EpisodeSpec& spec);
Result<std::vector<double>> start_of_open(EpisodeGround& ground, const episodes::EpisodeSpec& spec);

}  // namespace marketgen::environments
