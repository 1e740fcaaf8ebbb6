#include "episodes/aisle/people_in_world.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "episodes/episode_watch.h"
#include "physics/goods/spec_geoms.h"

namespace marketgen::episodes {
namespace {

constexpr double shoulders_share = 0.82;  // of stature (Drillis and Contini 1966)
constexpr double head_half_m = 0.12;

std::string body_name(std::size_t person) {
  return fmt::format("{}{}", EpisodeWatch::person_prefix, person);
}

Pose between(const Pose& from, const Pose& to, double share) {
  return {from.position + (to.position - from.position) * share, to.rotation};
}

double speed_of_geom(const physics::World& world, int geom) {
  mjtNum turning_moving[6];
  mj_objectVelocity(&world.model(), &world.data(), mjOBJ_GEOM, geom, turning_moving, 0);
  return mju_norm3(turning_moving + 3);
}

}  // namespace

void PeopleInWorld::add_to(mjSpec_& made) const {
  mjsBody* world = mjs_findBody(&made, "world");
  for (std::size_t i = 0; i < around_.count(); ++i) {
    mjsBody* body = mjs_addBody(world, nullptr);
    mjs_setName(body->element, body_name(i).c_str());
    body->mocap = true;
    const Pose pose = around_.store_from_person(i);
    physics::set_pose(body->pos, body->quat, pose);
    const double stature = around_.stature_m(i), half = stature * shoulders_share / 2;
    physics::add_shape(
        body, {assets::CollisionShape::cylinder, {{0, 0, half}, {}}, {person_radius_m, half, 0}});
    physics::add_shape(body,
                       {assets::CollisionShape::ellipsoid,
                        {{0, 0, stature - head_half_m}, {}},
                        {head_radius_m, head_radius_m, head_half_m}});
  }
}

void PeopleInWorld::start(const physics::World& world, const robots::Robot& robot) {
  const mjModel& m = world.model();
  if (around_.count() == 0) return;
  person_geoms_.resize(around_.count());
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const char* body = mj_id2name(&m, mjOBJ_BODY, m.geom_bodyid[geom]);
    if (body == nullptr) continue;
    if (std::ranges::find(robot.links, body, &robots::Link::name) != robot.links.end())
      robot_geoms_.push_back(geom);
    for (std::size_t i = 0; i < around_.count(); ++i)
      if (body_name(i) == body) person_geoms_[i].push_back(geom);
  }
  for (std::size_t i = 0; i < around_.count(); ++i)
    from_.push_back(around_.store_from_person(i));
}

// About the box of each of its geoms, seen from above.
std::vector<FloorDisc> PeopleInWorld::robot_discs(const physics::World& world) const {
  const mjModel& m = world.model();
  const mjData& d = world.data();
  std::vector<FloorDisc> discs;
  for (const int geom : robot_geoms_) {
    const mjtNum *box = m.geom_aabb + 6 * geom, *turned = d.geom_xmat + 9 * geom;
    FloorDisc disc{{d.geom_xpos[3 * geom], d.geom_xpos[3 * geom + 1]}, 0};
    double half[2] = {0, 0};
    for (int k = 0; k < 3; ++k) {
      disc.at = disc.at + Vec2{turned[k], turned[3 + k]} * box[k];
      half[0] += std::abs(turned[k]) * box[3 + k];
      half[1] += std::abs(turned[3 + k]) * box[3 + k];
    }
    disc.radius_m = std::min(std::hypot(half[0], half[1]), m.geom_rbound[geom]);
    discs.push_back(disc);
  }
  return discs;
}

void PeopleInWorld::pass(const physics::World& world, double dt_s) {
  if (around_.count() == 0) return;
  for (std::size_t i = 0; i < around_.count(); ++i)
    from_[i] = around_.store_from_person(i);
  around_.pass(dt_s, robot_discs(world));
}

Result<void> PeopleInWorld::move(physics::World& world, double share) const {
  for (std::size_t i = 0; i < around_.count(); ++i)
    MARKETGEN_CHECK(
        world.move_mocap(body_name(i), between(from_[i], around_.store_from_person(i), share)));
  return {};
}

std::set<std::string> PeopleInWorld::bodies() const {
  std::set<std::string> names;
  for (std::size_t i = 0; i < around_.count(); ++i)
    names.insert(body_name(i));
  return names;
}

Result<void> PeopleInWorld::measure(const physics::World& world, double dt_s) {
  const mjModel& m = world.model();
  const mjData& d = world.data();
  double nearest = max_measured_m;
  bool is_near = false;
  for (const std::vector<int>& person : person_geoms_) {
    for (const int theirs : person) {
      for (const int ours : robot_geoms_) {
        double apart[3];
        mju_sub3(apart, d.geom_xpos + 3 * theirs, d.geom_xpos + 3 * ours);
        const double least = mju_norm3(apart) - m.geom_rbound[theirs] - m.geom_rbound[ours];
        const double asked = std::max(nearest, near_person_m);
        if (least >= asked) continue;
        MARKETGEN_TRY(const double gap, world.distance_m(theirs, ours, asked));
        nearest = std::min(nearest, gap);
        is_near = is_near || (gap < near_person_m && speed_of_geom(world, ours) > near_person_m_s);
      }
    }
  }
  nearest = std::max(nearest, 0.0);  // in one another: in touch
  min_distance_m_ = std::min(min_distance_m_, nearest);
  if (is_near) near_s_ += dt_s;
  return {};
}

std::vector<motion::MovingDisc> PeopleInWorld::scanned(const Pose& world_from_base,
                                                       Vec3 axle) const {
  const Pose base_from_world = inverse(world_from_base);
  std::vector<motion::MovingDisc> seen;
  for (std::size_t i = 0; i < around_.count(); ++i) {
    const Vec3 at = around_.store_from_person(i).position;
    const double apart = std::hypot(at.x - axle.x, at.y - axle.y);
    if (apart > scanner_range_m || !around_.sees({axle.x, axle.y}, i)) continue;
    const Vec3 there = base_from_world * at;
    seen.push_back({{there.x, there.y}, person_radius_m, around_.speed_m_s(i)});
  }
  return seen;
}

}  // namespace marketgen::episodes
