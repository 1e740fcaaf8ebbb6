// Soft packs in MuJoCo: as bodies of a specification, and as a slot of a World's pool
// (physics/goods/slot.h) that becomes one pack after another.
#pragma once
#include <string>

#include "physics/mujoco_guard.h"
#include "physics/soft/soft_pack.h"

namespace marketgen::physics {

struct SoftElements {
  std::array<mjsBody*, SoftPack::part_count> bodies;
  std::array<mjsGeom*, SoftPack::part_count> geoms;
};

// A free body and what hangs on it, named NAME, NAME-top and NAME-flap, at the origin of `parent`,
// which must be the world body. Shapes do not rub yet, see set_goods_contact().
SoftElements add_soft_body(mjsBody* parent, const SoftPack& pack, const std::string& name);

// One pack in a model of its own, to copy from. Errors: physics.failed.
Result<MujocoModel> soft_model(const SoftPack& pack,
                               const GoodsContact& contact,
                               const std::string& where);

// How far any point of such a tree can be from the origin of its first body, however it bends.
double soft_reach_m(const mjModel& model, int body);

// True when the row's box can stand for the pack: its halves are straight within 4 degrees, and the
// flap hangs within the box.
bool lies_in_its_box(const mjModel& model, const mjData& data, int body);

}  // namespace marketgen::physics
