// Tens of thousands of geoms of one body, in linear time.
//
// mjs_addGeom numbers every element of its specification anew: adding 28,000 geoms to one takes 7
// s. Here they are added to small specifications, which are then attached: 0.3 s.
#pragma once
#include <string>
#include <vector>

#include "physics/goods/contact_shape.h"
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

// Must outlive the specification that it is attached to.
class StillGeoms {
 public:
  mjsGeom* add(const assets::ContactShape& shape);  // as add_shape(); valid as long as this
  // Makes them geoms of `body`, a body of `spec`, in their order. Once, after the last add().
  // `name`: no other has it. Errors: physics.failed.
  Result<void> attach_to(mjsBody* body, mjSpec& spec, const std::string& name);

 private:
  struct Batch {
    MujocoSpec spec{nullptr, mj_deleteSpec};
    mjsBody* body = nullptr;
    mjsFrame* frame = nullptr;
    int geoms = 0;
  };
  std::vector<Batch> batches_;
};

}  // namespace marketgen::physics
