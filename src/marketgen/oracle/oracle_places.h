// Where the oracle may put down what it holds.
#pragma once
#include <vector>

#include "oracle/oracle_scene.h"
#include "skills/place_search.h"

namespace marketgen::oracle {

// The item as a hand holds it, which opens so far when it lets go.
skills::HeldPack held_pack(const OracleScene& scene,
                           std::size_t item,
                           const Pose& tip_from_item,
                           double opening_m);

// Past everything that stands outside the basket now but the item. It is to stand in the unloading
// area, or else beside it and the basket.
skills::PlaceQuestion place_question(const OracleScene& scene, std::size_t item, bool in_area);

// Whether there is room for the item where it belongs, and a posture that puts it down there.
bool has_place(const OracleScene& scene,
               const skills::ArmExecutor& arm,
               std::size_t item,
               const Pose& station_from_tip,
               double opening_m);

}  // namespace marketgen::oracle
