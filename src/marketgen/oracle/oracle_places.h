// Where the oracle may put down what it holds: stable ways round, free places, postures.
#pragma once
#include <optional>
#include <vector>

#include "oracle/oracle_scene.h"

namespace marketgen {

struct PlaceChoice {
  Pose station_from_item, station_from_tip;
  Vec3 approach;  // straight down, tip frame
};

struct PlaceQuestion {
  std::size_t item = 0;
  Pose tip_from_item;              // as it is held
  double opening_m = 0;            // of the gripper when it lets go
  AreaRow area;                    // the whole item is to stand in it
  std::vector<AreaRow> kept_free;  // and in none of these
};

// The item is to stand in the unloading area, or else beside it and the basket.
PlaceQuestion place_question(const OracleScene& scene,
                             std::size_t item,
                             const Pose& tip_from_item,
                             double opening_m,
                             bool in_area);

constexpr double release_m = 0.004;  // over what it is put on

// Best first, at most `most`.
std::vector<PlaceChoice> item_places(const OracleScene& scene,
                                     const ArmExecutor& arm,
                                     const PlaceQuestion& question,
                                     std::size_t most);

// What is held, as spheres on the link of the tip.
AttachedObject held_object(const OracleScene& scene, std::size_t item, const Pose& tip_from_item);

}  // namespace marketgen
