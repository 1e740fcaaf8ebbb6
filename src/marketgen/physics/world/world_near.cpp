// What stands near the moving parts of a World, for MuJoCo's search for contacts.
#include <algorithm>
#include <cmath>

#include "geometry/box_extents.h"
#include "physics/soft/soft_body.h"
#include "physics/world/world_state.h"

namespace marketgen::physics {
namespace {

constexpr char near_where[] = "World::step";
constexpr int max_looks = 2;  // the second knows where everything is

}  // namespace

// Of a rigid one round its pieces, which may stand out of its still shape. A soft pack, however it
// bends, stays within its length of where its first half is.
Box3 World::State::body_box(std::size_t body) const {
  const auto product = static_cast<std::uint32_t>(live[body].product);
  const PoolBody& made = store.pool[body];
  const Pose pose = world_from_body(body);
  if (!made.soft()) {
    const Box3& bounds = made_row(product).goods->bounds;
    const Vec3 middle = pose * ((bounds.low + bounds.high) / 2);
    const Vec3 half = box_half_extents(pose.rotation, (bounds.high - bounds.low) / 2);
    return {middle - half, middle + half};
  }
  const double reach = soft_reach_m(m(), made.body);
  const Vec3 all{reach, reach, reach}, middle = pose.position;
  return {middle - all, middle + all};
}

// Where it was at the last mj_kinematics.
Box3 World::State::actor_box(int geom) const {
  Box3 box = box_of_geom(m(), geom, d().geom_xpos + 3 * geom, d().geom_xmat + 9 * geom);
  const double margin = m().geom_margin[geom] + m().geom_gap[geom];
  const Vec3 all{margin, margin, margin};
  return {box.low - all, box.high + all};
}

void World::State::look_round() {
  for (std::size_t body = 0; body < live.size(); ++body) {
    const int geom = store.pool[body].geom;
    if (live[body].product >= 0)
      near.follow(geom, body_box(body));
    else
      near.leave(geom);
  }
  for (const int geom : jointed_geoms)
    near.follow(geom, actor_box(geom));
}

bool World::State::actors_within() const {
  return std::ranges::all_of(jointed_geoms,
                             [&](int geom) { return near.holds(geom, actor_box(geom)); });
}

// Bodies of the pool are where their state says. Where the actors are is known only when
// mj_kinematics has run: should one have come out of where was looked, it is done again.
Result<void> World::State::find_contacts() {
  mjModel* const model = &m();
  mjData* const now = &d();
  for (int look = 0; look < max_looks; ++look) {
    look_round();
    near.write(m());
    const FirstGeoms moving(m(), m().body_geomadr[store.still_body]);
    MARKETGEN_CHECK(guarded(near_where, [=] { mj_step1(model, now); }));
    if (actors_within()) break;
  }
  return {};
}

}  // namespace marketgen::physics
