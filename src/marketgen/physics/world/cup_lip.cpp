#include "physics/world/cup_lip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/goods/contact_shape.h"

namespace marketgen::physics {
namespace {

constexpr double ray_start_m = 0.02;  // behind the lip
constexpr int patience_steps = 3;     // for which a lip may be overloaded

Vec3 vector_at(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

std::string point_name(const std::string& body, std::size_t point) {
  return fmt::format("{}/lip{}", body, point);
}

// To the convex mesh of a geom, from its faces: where the ray has come in by all that face it,
// before it goes out by one.
double ray_to_hull(
    const mjModel& m, const mjData& d, int geom, const mjtNum from[3], const mjtNum way[3]) {
  const int mesh = m.geom_dataid[geom];
  mjtNum start[3], along[3], apart[3];
  mju_sub3(apart, from, d.geom_xpos + 3 * geom);
  mju_mulMatTVec3(start, d.geom_xmat + 9 * geom, apart);
  mju_mulMatTVec3(along, d.geom_xmat + 9 * geom, way);
  double in = -1e9, out = 1e9;
  for (int i = m.mesh_polyadr[mesh]; i < m.mesh_polyadr[mesh] + m.mesh_polynum[mesh]; ++i) {
    const Vec3 normal = vector_at(m.mesh_polynormal + 3 * i);
    const int corner = m.mesh_vertadr[mesh] + m.mesh_polyvert[m.mesh_polyvertadr[i]];
    const float* p = m.mesh_vert + 3 * corner;
    const double height = dot(normal, Vec3{p[0], p[1], p[2]} - vector_at(start));
    const double rate = dot(normal, vector_at(along));
    if (rate == 0 && height < 0) return -1;
    if (rate < 0) in = std::max(in, height / rate);
    if (rate > 0) out = std::min(out, height / rate);
  }
  if (in > out) return -1;
  return in >= 0 ? in : out;
}

// Along a unit vector; negative when it does not meet the geom.
double ray_to(
    const mjModel& m, const mjData& d, int geom, const mjtNum from[3], const mjtNum way[3]) {
  if (m.geom_type[geom] == mjGEOM_MESH) return ray_to_hull(m, d, geom, from, way);
  return mju_rayGeom(d.geom_xpos + 3 * geom,
                     d.geom_xmat + 9 * geom,
                     m.geom_size + 3 * geom,
                     from,
                     way,
                     m.geom_type[geom],
                     nullptr);
}

struct Met {
  int geom = -1;
  double at = 0;
};

Met first_met(const mjModel& m,
              const mjData& d,
              std::span<const int> geoms,
              const mjtNum from[3],
              const mjtNum way[3]) {
  Met first;
  for (const int geom : geoms) {
    const double at = ray_to(m, d, geom, from, way);
    if (at >= 0 && (first.geom < 0 || at < first.at)) first = {geom, at};
  }
  return first;
}

}  // namespace

void add_lip(mjSpec& spec,
             const std::string& body,
             const Pose& body_from_lip,
             double radius_m,
             const std::string& other) {
  for (std::size_t i = 0; i < LipPoints{}.size(); ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / 3;
    const Vec3 at = body_from_lip * Vec3{radius_m * std::cos(turn), radius_m * std::sin(turn), 0};
    mjsEquality* point = mjs_addEquality(&spec, nullptr);
    mjs_setName(point->element, point_name(body, i).c_str());
    point->type = mjEQ_CONNECT;
    point->objtype = mjOBJ_BODY;
    point->active = false;
    mjs_setString(point->name1, body.c_str());
    if (!other.empty()) mjs_setString(point->name2, other.c_str());
    std::fill(point->data, point->data + mjNEQDATA, 0.0);
    point->data[0] = at.x, point->data[1] = at.y, point->data[2] = at.z;
    point->solref[0] = contact_time_s;
  }
}

LipPoints lip_points(const mjModel& model, const std::string& body) {
  LipPoints points{};
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = mj_name2id(&model, mjOBJ_EQUALITY, point_name(body, i).c_str());
  return points;
}

int UnderLip::at_point(std::size_t point) const {
  return geoms[(point * edge_rays + 1) / 3];
}

std::optional<UnderLip> look_under_lip(const mjModel& model,
                                       const mjData& data,
                                       const Pose& world_from_lip,
                                       const CupShape& cup,
                                       std::span<const int> geoms) {
  const Vec3 ahead = rotate(world_from_lip.rotation, {0, 0, 1});
  const mjtNum way[3] = {ahead.x, ahead.y, ahead.z};
  double least = 1e9, most = -1e9;
  UnderLip under;
  for (int i = 0; i <= UnderLip::edge_rays; ++i) {
    const double turn = 2 * std::numbers::pi * i / UnderLip::edge_rays;
    const double radius = i == UnderLip::edge_rays ? 0 : cup.radius_m;
    const Vec3 from =
        world_from_lip * Vec3{radius * std::cos(turn), radius * std::sin(turn), -ray_start_m};
    const mjtNum start[3] = {from.x, from.y, from.z};
    const Met met = first_met(model, data, geoms, start, way);
    if (met.geom < 0) return std::nullopt;
    under.geoms[static_cast<std::size_t>(i)] = met.geom;
    least = std::min(least, met.at - ray_start_m);
    most = std::max(most, met.at - ray_start_m);
  }
  if (most - least > cup.seal_depth_m) return std::nullopt;
  if (least < -bellows_stroke_m || most > bellows_stroke_m) return std::nullopt;
  return under;
}

Vec3 place_of_point(const mjModel& model, int point) {
  return vector_at(model.eq_data + mjNEQDATA * point);
}

void hold_point(mjModel& model, mjData& data, int point, int body, Vec3 on_body) {
  mjtNum* anchors = model.eq_data + mjNEQDATA * point;
  anchors[3] = on_body.x, anchors[4] = on_body.y, anchors[5] = on_body.z;
  model.eq_obj2id[point] = body;
  data.eq_active[point] = true;
}

void let_go(mjData& data, const LipPoints& lip) {
  for (const int point : lip)
    data.eq_active[point] = false;
}

bool LipLoad::breaks(
    const mjData& d, const LipPoints& lip, Vec3 ahead, double pull_n, double friction) {
  double max_pull = 0, pull = 0;
  Vec3 shear{};
  for (const int point : lip) {
    for (int row = 0; row < d.nefc; ++row) {
      if (d.efc_type[row] != mjCNSTR_EQUALITY || d.efc_id[row] != point) continue;
      const Vec3 on_cup = vector_at(d.efc_force + row);  // world axes
      const double along = dot(on_cup, ahead);
      max_pull = std::max(max_pull, along);
      pull += along;
      shear += on_cup - ahead * along;
      break;  // its other two rows follow
    }
  }
  const bool over =
      max_pull > pull_n / 3 || length(shear) > friction * std::max(0.0, pull_n - pull);
  steps_ = over ? steps_ + 1 : 0;
  return steps_ >= patience_steps;
}

}  // namespace marketgen::physics
