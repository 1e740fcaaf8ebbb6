// MuJoCo's own state, byte for byte. mj_getState is not enough: which trees sleep is in none of its
// parts.
#pragma once
#include <mujoco/mujoco.h>

#include <cstddef>
#include <vector>

#include "base/byte_archive.h"

namespace marketgen::physics {

struct MujocoMoment {
  // Members of mjData outside its buffer that carry state from step to step.
  struct Scalars {
    mjtNum time, energy[2];
    int ntree_awake, nbody_awake, nparent_awake, nv_awake;
  };
  std::vector<std::byte> buffer;
  Scalars scalars{};

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.buffer, self.scalars);
  }
};

MujocoMoment moment_of(const mjData& data);
// `data` is of the same model: its buffer is as long. Contacts are made anew by the next step.
void restore_moment(mjData& data, const MujocoMoment& moment);

}  // namespace marketgen::physics
