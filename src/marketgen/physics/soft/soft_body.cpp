#include "physics/soft/soft_body.h"

#include <algorithm>
#include <cmath>

#include "physics/goods/spec_geoms.h"

namespace marketgen::physics {
namespace {

constexpr std::array<const char*, SoftPack::part_count> part_suffix = {"", "-top", "-flap"};
// On a shelf that is tilted by 8 degrees bags bend by 0.054.
constexpr double straight_rad = 0.07;

void write3(double* to, Vec3 v) {
  to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

void add_hinge(mjsBody* body, const SoftHinge& hinge) {
  mjsJoint* joint = mjs_addJoint(body, nullptr);
  joint->type = mjJNT_HINGE;
  write3(joint->axis, hinge.axis);
  joint->stiffness[0] = hinge.stiffness_n_m;
  joint->damping[0] = hinge.damping_n_m_s;
  joint->limited = mjLIMITED_TRUE;
  joint->range[0] = -hinge.limit_rad, joint->range[1] = hinge.limit_rad;
}

}  // namespace

SoftElements add_soft_body(mjsBody* parent, const SoftPack& pack, const std::string& name) {
  SoftElements made{};
  Vec3 frame;  // of the body, in the pack's frame: the middle, then the hinges
  for (std::size_t i = 0; i < pack.parts.size(); ++i) {
    const SoftPart& part = pack.parts[i];
    mjsBody* body = mjs_addBody(i == 0 ? parent : made.bodies[i - 1], nullptr);
    mjs_setName(body->element, (name + part_suffix[i]).c_str());
    if (i == 0) {
      mjs_addFreeJoint(body)->align = mjALIGNFREE_FALSE;
    } else {
      const SoftHinge& hinge = pack.hinges[i - 1];
      write3(body->pos, hinge.at - frame);
      frame = hinge.at;
      add_hinge(body, hinge);
    }
    made.bodies[i] = body;
    made.geoms[i] =
        add_shape(body, {assets::CollisionShape::box, {part.center - frame, {}}, part.half_size});
    made.geoms[i]->mass = part.mass_kg;
  }
  return made;
}

Result<MujocoModel> soft_model(const SoftPack& pack,
                               const GoodsContact& contact,
                               const std::string& where) {
  const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  spec->compiler.degree = false;
  for (mjsGeom* geom : add_soft_body(mjs_findBody(spec.get(), "world"), pack, "pack").geoms)
    set_goods_contact(geom, contact);
  return compile(*spec, where);
}

double soft_reach_m(const mjModel& m, int body) {
  double to_hinge = 0, reach = 0;
  for (int part = body; part < body + SoftPack::part_count; ++part) {
    const int geom = m.body_geomadr[part];
    if (part > body) to_hinge += mju_norm3(m.body_pos + 3 * part);
    reach = std::max(reach, to_hinge + mju_norm3(m.geom_pos + 3 * geom) + m.geom_rbound[geom]);
  }
  return reach;
}

bool lies_in_its_box(const mjModel& m, const mjData& d, int body) {
  const auto angle = [&](int part) { return std::abs(d.qpos[m.jnt_qposadr[m.body_jntadr[part]]]); };
  const int top = body + 1, flap = body + 2;
  const double flap_length =
      2 * mju_norm3(m.geom_pos + 3 * m.body_geomadr[flap]);  // from its hinge
  const mjtNum* half = m.geom_size + 3 * m.body_geomadr[top];
  return angle(top) < straight_rad &&
         flap_length * std::sin(angle(flap)) < std::min({half[0], half[1], half[2]});
}

}  // namespace marketgen::physics
