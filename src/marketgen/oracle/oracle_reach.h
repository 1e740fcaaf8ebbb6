// How the oracle's hand comes to a grasp, and whether what it takes can be put down.
#pragma once
#include <vector>

#include "oracle/oracle_grasps.h"
#include "oracle/oracle_places.h"

namespace marketgen {

// The tip's pose and the same turned half round, the one that the arm reaches sooner first.
std::vector<Pose> either_way_round(const ArmExecutor& arm, const Pose& station_from_tip);

// The way there: so long that the fingers come from over the basket's rim.
ReachRequest reach_request(const OracleScene& scene,
                           const Pose& station_from_tip,
                           double opening_m);

// Whether postures bring the tip to both ends of that way, and the open tool goes it without
// meeting the basket.
bool is_reached(const OracleScene& scene, const ArmExecutor& arm, const ReachRequest& request);

// Whether there is room for the item where it belongs, and a posture that puts it down there.
bool has_place(const OracleScene& scene,
               const ArmExecutor& arm,
               std::size_t item,
               const Pose& station_from_tip,
               double opening_m);

}  // namespace marketgen
