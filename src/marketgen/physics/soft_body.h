// Soft packs in MuJoCo: as bodies of a specification, and as a slot of a World's pool that becomes
// one pack after another.
//
// A slot has the same bodies, joints and shapes whichever pack it is; only their numbers differ.
// These are copied from a model of that pack alone, which MuJoCo itself has compiled, so that the
// slot moves bit for bit as if the World had been compiled with the pack in it.
#pragma once
#include <string>

#include "physics/mujoco_guard.h"
#include "physics/soft_pack.h"

namespace marketgen {

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

// Makes the tree of `to` whose first body is `body` the one that soft_model() made. Which geoms
// collide is left as it is.
void copy_soft_tree(mjModel& to, int body, const mjModel& from);

// How far any point of such a tree can be from the origin of its first body, however it bends.
double soft_reach_m(const mjModel& model, int body);

// True when the row's box can stand for the pack: its halves are straight within 4 degrees, and the
// flap hangs within the box.
bool lies_in_its_box(const mjModel& model, const mjData& data, int body);

}  // namespace marketgen
