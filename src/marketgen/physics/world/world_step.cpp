// One step of a World.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/world/world_state.h"

namespace marketgen::physics {
namespace {

constexpr char step_where[] = "World::step";
// Contacts that wake lead to contacts that wake: a row of touching packs takes one pass a pack.
constexpr int max_passes = 8;
constexpr int actor_scan_steps = 10;  // between looks around the actors
// MuJoCo knows no contact between static goods and mocap bodies or drawers: nearer is touching.
constexpr double untouchable_reach_m = 0.002;
constexpr double noticeable_m = 1e-4;  // metres or radians that a drawer or door moves
// A contact point that moves faster than this pushes. A slower one, were it to pass on all of its
// speed, would let a pack slide by v^2 / (2 x friction x g): less than 0.01 mm at a friction of
// 0.2. Downwards, `impact_m_s` is a fall of 0.5 mm.
// What came to rest against its neighbours is nudged by each of them that wakes.
constexpr double push_m_s = 0.005, moved_push_m_s = 0.05, impact_m_s = 0.1;
constexpr double carried_slack_m = 0.001;  // a product that moved less still carries what it did
// Heaped goods settle by millimetres when they are woken. What they touch meanwhile stays as it is,
// or the whole heap would come to life at a touch: 0.2 m/s is a fall of 2 mm.
constexpr double heap_push_m_s = 0.2, heap_slack_m = 0.01;
constexpr double lean_cosine = 0.70710678118654752;  // 45 degrees
constexpr double drop_m = 0.10, drop_m_s = 0.5;
constexpr double hook_holds_weights = 3;  // a stronger pull takes goods off their peg

// Velocity of a point of a dynamic body.
Vec3 velocity_at(const mjModel& m, const mjData& d, int body, Vec3 point) {
  const mjtNum* c = d.cvel + 6 * body;  // about the tree's centre of mass: angular, linear
  const Vec3 center = vec3_of(d.subtree_com + 3 * m.body_rootid[body]);
  return vec3_of(c + 3) + cross(vec3_of(c), point - center);
}

}  // namespace

bool World::State::wake_touched() {
  bool any = false;
  for (int i = 0; i < d().ncon; ++i) {
    const mjContact& contact = d().contact[i];
    for (int side = 0; side < 2; ++side) {
      const GeomOwner& owner = store.owners[static_cast<std::size_t>(contact.geom[side])];
      if (owner.kind != BodyKind::product || owner.pool || body_of[owner.row] >= 0) continue;
      const int other = contact.geom[1 - side];
      bool pushes_it = store.owners[static_cast<std::size_t>(other)].kind == BodyKind::actor;
      if (!pushes_it) {
        const Vec3 v = velocity_at(m(), d(), m().geom_bodyid[other], vec3_of(contact.pos));
        const bool heap = heaped(owner.row);
        const bool visits = store.owners[static_cast<std::size_t>(other)].pool;
        const double across = heap                        ? heap_push_m_s
                              : moved.contains(owner.row) ? moved_push_m_s
                                                          : push_m_s;
        pushes_it = std::sqrt(v.x * v.x + v.y * v.y) > across ||
                    std::abs(v.z) > (heap ? heap_push_m_s : impact_m_s) ||
                    (visits && !heap && contact.dist < -hollow_depth_m);
      }
      if (pushes_it && !refused[owner.row]) any = wake(owner.row) || any;
    }
  }
  return any;
}

Result<double> World::State::distance_m(int geom, int other, double max_m) {
  double apart = max_m;
  MARKETGEN_CHECK(guarded(
      step_where, [&] { apart = mj_geomDistance(&m(), &d(), geom, other, max_m, nullptr); }));
  return apart;
}

Result<void> World::State::wake_within(int geom, double reach_m) {
  const Vec3 center = vec3_of(d().geom_xpos + 3 * geom);
  const double radius = m().geom_rbound[geom];
  const Vec3 half{radius, radius, radius};
  for (const std::uint32_t product : grid.near({center - half, center + half}, reach_m)) {
    const int other = store.product_geom[product];
    MARKETGEN_TRY(const double apart, distance_m(geom, other, reach_m));
    if (apart < reach_m) wake(product);
  }
  return {};
}

Result<void> World::State::wake_near_actors() {
  const bool scan = options.wake_within_m > 0 && steps % actor_scan_steps == 0;
  for (const int geom : actor_geoms) {
    const bool mocap = m().body_mocapid[m().body_rootid[m().geom_bodyid[geom]]] >= 0;
    if (!mocap && !scan) continue;
    MARKETGEN_CHECK(wake_within(
        geom, std::max(mocap ? untouchable_reach_m : 0, scan ? options.wake_within_m : 0)));
  }
  return {};
}

// Goods that stand still do not touch a drawer or a door, lest they hold it: they are woken as soon
// as it has moved noticeably.
Result<void> World::State::wake_near_moving_fixtures() {
  for (const FixtureTree& fixture : fixture_trees) {
    if (d().tree_asleep[fixture.tree] >= 0) continue;
    bool has_moved = false;
    for (const std::uint32_t joint : fixture.joints) {
      const double at = d().qpos[store.joints[joint].qpos];
      if (std::abs(at - looked_at[joint]) <= noticeable_m) continue;
      has_moved = true;
      looked_at[joint] = at;
    }
    if (!has_moved) continue;
    for (const int geom : fixture.geoms)
      MARKETGEN_CHECK(wake_within(geom, untouchable_reach_m));
  }
  return {};
}

void World::State::follow(std::size_t body) {
  LiveBody& here = live[body];
  if (asleep(body)) return fall_asleep(body);
  here.keeps = false;
  const auto product = static_cast<std::uint32_t>(here.product);
  const PoolBody& made = store.pool[body];
  const Pose pose = product_pose(product);
  const Vec3 way = pose.position - here.woke_at.position;
  const Vec3 up{0, 0, 1};
  const double lean = dot(rotate(pose.rotation, up), rotate(here.woke_at.rotation, up));
  if (!here.toppled && lean < lean_cosine) {
    here.toppled = true;
    report(EventKind::toppled, product);
  }
  if (!here.dropped && way.z < -drop_m && d().qvel[made.dof + 2] < -drop_m_s) {
    here.dropped = true;
    report(EventKind::dropped, product);
  }
  const bool heap = heaped(product);
  const bool left = length(way) > (heap ? heap_slack_m : carried_slack_m);
  if (!here.carries.empty() && (left || (!heap && lean < 0.9999))) wake_carried(body);
  if (running_belts.empty()) return;
  const Box3 box = box_at(product, shape_pose(product));
  const bool rides = std::ranges::any_of(
      running_belts, [&](const Box3& belt) { return belt.meets(box, untouchable_reach_m); });
  if (rides) mark_wake(d(), made);
}

void World::State::clear_wakes() {
  for (std::size_t body = 0; body < live.size(); ++body)
    settle_wake(d(), store.pool[body]);
}

Result<void> World::State::check_warnings() const {
  static constexpr std::array fatal_warnings = {mjWARN_INERTIA,
                                                mjWARN_CONTACTFULL,
                                                mjWARN_CNSTRFULL,
                                                mjWARN_BADQPOS,
                                                mjWARN_BADQVEL,
                                                mjWARN_BADQACC};
  for (const int warning : fatal_warnings) {
    const mjWarningStat& stat = d().warning[warning];
    if (stat.number == 0) continue;
    return Error{"physics.failed",
                 step_where,
                 fmt::format("at {:.3f} s: {}; restore a snapshot from before",
                             d().time,
                             mju_warningText(warning, static_cast<size_t>(stat.lastinfo)))};
  }
  return {};
}

// Without MuJoCo's "noslip" what is held creeps through the fingers, by a millimetre in seconds.
// What lies or falls needs no such care: it comes to rest and sleeps. It is a third of the solver's
// work.
bool World::State::in_hand() const {
  const auto tree_of = [&](const ContactSide& actor) {
    return m().body_treeid[m().geom_bodyid[actor.row]];
  };
  return std::ranges::any_of(contacts, [&](const WorldContact& contact) {
    const auto of_hand = [&](const ContactSide& side) {
      return side.kind == BodyKind::actor && hand_geoms[side.row];
    };
    if (contact.a.kind == BodyKind::room || !(of_hand(contact.a) || of_hand(contact.b)))
      return false;
    return contact.a.kind != BodyKind::actor || tree_of(contact.a) != tree_of(contact.b);
  });
}

Result<void> World::State::step_once() {
  mjModel* const model = &m();
  mjData* const now = &d();
  for (const auto& [product, wrench] : pushes) {
    if (!wake(product)) continue;
    push_body(static_cast<std::size_t>(body_of[product]), wrench);
  }
  keep_sealed_awake();
  pull_gaskets();
  MARKETGEN_CHECK(wake_near_actors());
  MARKETGEN_CHECK(wake_near_moving_fixtures());
  m().opt.noslip_iterations = in_hand() ? noslip_iterations : 0;
  MARKETGEN_CHECK(find_contacts());
  for (int pass = 0; pass < max_passes && wake_touched(); ++pass)
    MARKETGEN_CHECK(find_contacts());
  MARKETGEN_CHECK(seal_cups());
  set_frictions();
  MARKETGEN_CHECK(guarded(step_where, [=] { mj_step2(model, now); }));
  ++steps;
  MARKETGEN_CHECK(check_warnings());
  for (const auto& [product, wrench] : pushes) {
    if (body_of[product] < 0) continue;
    const PoolBody& body = store.pool[static_cast<std::size_t>(body_of[product])];
    mju_zero(now->xfrc_applied + 6 * body.body, 6 * body.parts);
  }
  clear_wakes();
  MARKETGEN_CHECK(read_contacts());
  release_hooks();
  look_at_lips();
  for (std::size_t body = 0; body < live.size(); ++body) {
    if (live[body].product >= 0) follow(body);
  }
  wake_pressed();
  if (fault) return *std::exchange(fault, {});
  return {};
}

// Goods come off their peg when they are pulled.
void World::State::release_hooks() {
  for (std::size_t body = 0; body < live.size(); ++body) {
    LiveBody& here = live[body];
    if (!here.hooked) continue;
    const PoolBody& made = store.pool[body];
    double squares = 0;
    for (int row = 0; row < d().ne; ++row) {
      if (d().efc_id[row] == made.hook) squares += d().efc_force[row] * d().efc_force[row];
    }
    const double weight = m().body_subtreemass[made.body] * -m().opt.gravity[2];
    if (std::sqrt(squares) <= hook_holds_weights * weight) continue;
    here.hooked = false;
    d().eq_active[made.hook] = false;
  }
}

}  // namespace marketgen::physics
