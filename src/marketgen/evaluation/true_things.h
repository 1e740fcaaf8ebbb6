// What truly is at a place, in the frame that the policy of a track is told things in.
#pragma once
#include <string>

#include "episodes/track_world.h"
#include "evaluation/decision_record.h"

namespace marketgen::evaluation {

// Beside a product of that SKU that is taken to have its middle there.
TruthThere truth_at(const episodes::TrackWorld& world, const std::string& sku, Vec3 middle);

// The product that a tool holds; empty: none does.
std::string held_sku(const episodes::TrackWorld& world);

}  // namespace marketgen::evaluation
