#include "physics/mujoco_moment.h"

#include <cstring>

namespace marketgen::physics {

MujocoMoment moment_of(const mjData& d) {
  MujocoMoment moment;
  const auto* bytes = static_cast<const std::byte*>(d.buffer);
  moment.buffer.assign(bytes, bytes + d.nbuffer);
  moment.scalars = {d.time,
                    {d.energy[0], d.energy[1]},
                    d.ntree_awake,
                    d.nbody_awake,
                    d.nparent_awake,
                    d.nv_awake};
  return moment;
}

void restore_moment(mjData& d, const MujocoMoment& moment) {
  std::memcpy(d.buffer, moment.buffer.data(), moment.buffer.size());
  const MujocoMoment::Scalars& s = moment.scalars;
  d.time = s.time;
  d.energy[0] = s.energy[0], d.energy[1] = s.energy[1];
  d.ntree_awake = s.ntree_awake, d.nbody_awake = s.nbody_awake;
  d.nparent_awake = s.nparent_awake, d.nv_awake = s.nv_awake;
  d.ncon = d.nefc = d.ne = d.nf = d.nl = d.nisland = 0;
  for (mjWarningStat& warning : d.warning)
    warning = {};
}

}  // namespace marketgen::physics
