// Convex hulls that come into a compiled MuJoCo model while it runs.
//
// A store has 2,000 rows of goods and few of them are ever touched: to find the pieces of all of
// them would take a minute, to compile their hulls seconds. So a World is compiled without, and
// those of a row come in when one of its products is first touched.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "physics/mujoco_guard.h"

namespace marketgen::physics {

// Holds the model's tables of meshes from the first add() on: it must live as long as the model is
// used. mj_copyData, mj_saveModel and names of all but meshes go on as before. mj_rayMesh does not
// know the meshes: they have no tree of boxes.
class HullMeshes {
 public:
  explicit HullMeshes(mjModel& model) : model_(model) {}
  HullMeshes(const HullMeshes&) = delete;
  HullMeshes& operator=(const HullMeshes&) = delete;

  // The meshes of `from` behind the model's own; the row of the first. Nothing that moves depends
  // on which row a mesh has.
  int add(const mjModel& from);

 private:
  static constexpr std::size_t tables = 36;

  mjModel& model_;
  std::array<std::vector<std::byte>, tables> kept_;
};

}  // namespace marketgen::physics
