// What goods in an open container are to MuJoCo: shared by bulk settling and grasps in a basket.
#pragma once
#include "physics/mujoco_guard.h"
#include "physics/settle/bulk_settle.h"

namespace marketgen::physics {

// The container's geoms on the world body, the floor (a plane without end) first.
std::vector<mjsGeom*> add_container(mjsBody* world, const OpenContainer& container);

// Errors: as settle_bulk's for the container.
Result<void> check_container(const OpenContainer& container);

// Half extents of the upright box around the turned pack.
Vec3 turned_half_extents(const catalog::Product& product, const Quaternion& rotation);

}  // namespace marketgen::physics
