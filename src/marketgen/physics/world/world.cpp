#include "physics/world/world.h"

#include <fmt/format.h>
#include <immintrin.h>

#include <algorithm>
#include <cmath>

#include "physics/world/fixture_bodies.h"
#include "physics/world/world_state.h"
#include "scene/articulation.h"

namespace marketgen::physics {
namespace {

// Steps round as one thread of ours would, whoever calls: with denormals flushed, like the workers
// of base/parallel.h.
class RoundingMode {
 public:
  RoundingMode() : saved_(_mm_getcsr()) { _mm_setcsr(flushing_to_zero); }
  ~RoundingMode() { _mm_setcsr(saved_); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;

 private:
  static constexpr unsigned flushing_to_zero = 0x9FC0;  // FTZ, DAZ, exceptions masked, to nearest
  unsigned saved_;
};

constexpr int max_steps = 100'000'000;  // in one call: 55 simulated hours

Error bad_command(const std::string& where, const std::string& message) {
  return {"physics.bad_command", "World::" + where, message};
}

template <std::size_t size>
bool finite(const std::array<double, size>& values) {
  return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
}

std::array<double, 7> values_of(const Pose& pose) {
  const Vec3& p = pose.position;
  const Quaternion& q = pose.rotation;
  return {p.x, p.y, p.z, q.w, q.x, q.y, q.z};
}

std::array<double, 7> values_of(const Wrench& wrench) {
  const Vec3 &f = wrench.force_n, &t = wrench.torque_n_m;
  return {f.x, f.y, f.z, t.x, t.y, t.z, 0};
}

// False when the rotation is no rotation at all.
bool unit(Pose& pose) {
  Quaternion& q = pose.rotation;
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 1e-6)) return false;
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  return true;
}

// Within the box around the store, from the floor to the ceiling; 1 mm over.
bool inside(const plan::Shell& shell, Vec3 at) {
  constexpr double over_m = 0.001;
  const auto within = [&](double value, int max_mm) {
    return value >= -over_m && value <= max_mm / 1000.0 + over_m;
  };
  return within(at.x, shell.width_mm) && within(at.y, shell.depth_mm) &&
         within(at.z, shell.ceiling_mm);
}

Pose pose_from(const std::array<double, 7>& v) {
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5], v[6]}};
}

}  // namespace

World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const scene::Scene& scene, WorldOptions options) {
  const RoundingMode rounding;
  MARKETGEN_TRY(StoreModel model, store_model(scene, options));
  MARKETGEN_TRY(MujocoData data, make_data(*model.model, "world"));
  mjModel* const m = model.model.get();
  mjData* const d = data.get();
  MARKETGEN_CHECK(guarded("world", [=] { mj_kinematics(m, d); }));
  return World(
      std::make_unique<State>(scene, std::move(options), std::move(model), std::move(data)));
}

// ---- Commands ----

Result<void> World::apply(const WorldCommand& command) {
  const RoundingMode rounding;
  State& s = *state_;
  if (!finite(command.value)) {
    return bad_command("apply",
                       fmt::format("a value of command {} for {} is not finite",
                                   static_cast<int>(command.kind),
                                   command.index));
  }
  MARKETGEN_CHECK(s.obey(command));
  if (s.options.keep_commands) s.commands.push_back(command);
  return {};
}

Result<void> World::State::obey(const WorldCommand& command) {
  const std::uint32_t index = command.index;
  const double value = command.value[0];
  switch (command.kind) {
    case CommandKind::step:
      return run(index);
    case CommandKind::control:
      if (index >= static_cast<std::uint32_t>(m().nu))
        return bad_command("set_control", fmt::format("there are {} actuators", m().nu));
      d().ctrl[index] = value;
      return {};
    case CommandKind::joint_force:
      return force_joint(index, value);
    case CommandKind::belt_speed:
      return start_belt(index, value);
    case CommandKind::mocap:
      return put_mocap(index, pose_from(command.value));
    case CommandKind::suck:
      return suck(index, value != 0);
    case CommandKind::push:
    case CommandKind::wake:
    case CommandKind::place:
      return obey_product(command);
  }
  return bad_command("apply", "there is no such command");
}

Result<void> World::State::obey_product(const WorldCommand& command) {
  const std::uint32_t product = command.index;
  const auto& v = command.value;
  if (product >= scene.products.size() || store.product_geom[product] < 0) {
    return bad_command("apply",
                       fmt::format("no product {} in the model; the scene has {}{}",
                                   product,
                                   scene.products.size(),
                                   options.region_m ? ", the model those of its region" : ""));
  }
  Pose pose = pose_from(v);
  if (command.kind == CommandKind::place && !unit(pose))
    return bad_command("place", "the rotation is no unit quaternion");
  if (command.kind == CommandKind::place && !inside(scene.layout.shell, pose.position)) {
    return bad_command("place",
                       fmt::format("({}, {}, {}) m lies outside the store",
                                   pose.position.x,
                                   pose.position.y,
                                   pose.position.z));
  }
  if (command.kind == CommandKind::push) {
    pushes.push_back({product, {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}});
    return {};
  }
  if (!wake(product)) {
    if (fault) return *std::exchange(fault, {});
    return bad_command(
        command.kind == CommandKind::wake ? "wake" : "place",
        fmt::format("all {} bodies of the pool are moving; ask for more in WorldOptions.pool",
                    options.pool));
  }
  if (command.kind == CommandKind::wake) return {};
  const auto body = static_cast<std::size_t>(body_of[product]);
  wake_carried(body);
  wake_kept();
  live[body].hooked = false;
  d().eq_active[store.pool[body].hook] = false;
  live[body].woke_at = pose;
  for (std::size_t cup = 0; cup < cups.size(); ++cup)
    if (live_cups[cup].product == product) release(cup);
  dress(body, product, pose);
  return {};
}

Result<void> World::State::run(std::uint32_t count) {
  if (count > max_steps) return bad_command("step", fmt::format("0 to {} steps", max_steps));
  if (failed) {
    return Error{"physics.failed",
                 "World::step",
                 "this world has failed before; restore a snapshot or create it anew"};
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (Result<void> done = step_once(); !done.ok()) {
      failed = true;
      return done;
    }
  }
  if (count > 0) pushes.clear();
  return {};
}

Result<void> World::State::force_joint(std::uint32_t joint, double force) {
  if (joint >= store.joints.size() || store.joints[joint].dof < 0) {
    return bad_command("set_joint_force",
                       fmt::format("joint {} is none of the scene's {}, or does not move in this "
                                   "world",
                                   joint,
                                   store.joints.size()));
  }
  d().qfrc_applied[store.joints[joint].dof] = force == 0 ? 0.0 : force;  // -0 would keep it awake
  return {};
}

Result<void> World::State::start_belt(std::uint32_t joint, double speed) {
  if (joint >= belt_geoms.size() || scene.joints[joint].kind != assets::JointKind::belt)
    return bad_command("set_belt_speed", fmt::format("joint {} is no belt", joint));
  const scene::SceneJoint& belt = scene.joints[joint];
  if (speed < belt.lower || speed > belt.upper) {
    return bad_command(
        "set_belt_speed",
        fmt::format("{} m/s; this belt runs from {} to {} m/s", speed, belt.lower, belt.upper));
  }
  run_belt(joint, speed);
  for (const Box3& box : running_belts) {
    for (const std::uint32_t product : resting_on_belt(box))
      wake(product);
  }
  wake_kept();
  return {};
}

std::vector<std::uint32_t> World::State::resting_on_belt(const Box3& belt) const {
  constexpr double touching_m = 0.003, sunk_m = 0.005;
  std::vector<std::uint32_t> found;
  for (const std::uint32_t product : grid.near(belt, touching_m)) {
    if (grid.box(product).low.z >= belt.high.z - sunk_m) found.push_back(product);
  }
  return found;
}

void World::State::run_belt(std::uint32_t joint, double speed_m_s) {
  belt_speed[joint] = speed_m_s;
  const Pose world_from_joint = scene::world_from_fixture(scene, scene.joints[joint].fixture) *
                                scene::fixture_from_joint(scene.joints[joint]);
  const Vec3 way = rotate(world_from_joint.rotation, {0, 0, 1}) * speed_m_s;
  for (const int geom : belt_geoms[joint]) {
    const Vec3 local = rotate(inverse(pose_of(geom_pose(m(), geom)).rotation), way);
    mjtNum* velocity = m().geom_surfacevel + 6 * geom;
    velocity[0] = local.x, velocity[1] = local.y, velocity[2] = local.z;
    m().flg_surfacevel = true;
  }
  update_running_belts();
}

Result<void> World::State::put_mocap(std::uint32_t body, Pose pose) {
  if (body >= static_cast<std::uint32_t>(m().nmocap))
    return bad_command("move_mocap", fmt::format("there are {} mocap bodies", m().nmocap));
  if (!unit(pose)) return bad_command("move_mocap", "the rotation is no unit quaternion");
  const ShapePose to = shape_pose_of(pose);
  mju_copy(d().mocap_pos + 3 * body, to.position, 3);
  mju_copy(d().mocap_quat + 4 * body, to.rotation, 4);
  return {};
}

Result<void> World::step(int count) {
  if (count < 0) return bad_command("step", fmt::format("{} steps", count));
  return apply({CommandKind::step, static_cast<std::uint32_t>(count), {}});
}
Result<void> World::set_control(int actuator, double value) {
  return apply({CommandKind::control, static_cast<std::uint32_t>(actuator), {value}});
}
Result<void> World::set_joint_force(std::uint32_t joint, double force) {
  return apply({CommandKind::joint_force, joint, {force}});
}
Result<void> World::set_belt_speed(std::uint32_t joint, double speed_m_s) {
  return apply({CommandKind::belt_speed, joint, {speed_m_s}});
}
Result<void> World::move_mocap(std::string_view body, const Pose& pose) {
  const int id = mj_name2id(&model(), mjOBJ_BODY, std::string(body).c_str());
  const int mocap = id < 0 ? -1 : model().body_mocapid[id];
  if (mocap < 0) return bad_command("move_mocap", fmt::format("no mocap body \"{}\"", body));
  return apply({CommandKind::mocap, static_cast<std::uint32_t>(mocap), values_of(pose)});
}
Result<void> World::push(std::uint32_t product, const Wrench& wrench) {
  return apply({CommandKind::push, product, values_of(wrench)});
}
Result<void> World::wake(std::uint32_t product) {
  return apply({CommandKind::wake, product, {}});
}
Result<void> World::place(std::uint32_t product, const Pose& world_from_product) {
  return apply({CommandKind::place, product, values_of(world_from_product)});
}

Result<void> World::suck(std::uint32_t cup, bool on) {
  return apply({CommandKind::suck, cup, {on ? 1.0 : 0.0}});
}

Result<void> replay(World& world, std::span<const WorldCommand> commands) {
  for (const WorldCommand& command : commands)
    MARKETGEN_CHECK(world.apply(command));
  return {};
}

// ---- State ----

double World::time_s() const {
  return static_cast<double>(state_->steps) * time_step_s;
}
bool World::has(std::uint32_t product) const {
  return state_->store.product_geom.at(product) >= 0;
}
bool World::awake(std::uint32_t product) const {
  return state_->body_of.at(product) >= 0;
}
Pose World::product_pose(std::uint32_t product) const {
  return state_->product_pose(product);
}

ProductMotion World::product_motion(std::uint32_t product) const {
  const State& s = *state_;
  ProductMotion motion{s.product_pose(product), {}, {}};
  if (s.body_of[product] < 0) return motion;
  const auto body = static_cast<std::size_t>(s.body_of[product]);
  const mjtNum* v = s.d().qvel + s.store.pool[body].dof;
  const Quaternion turned = s.world_from_body(body).rotation;
  motion.velocity_m_s = {v[0], v[1], v[2]};
  motion.angular_rad_s = rotate(turned, {v[3], v[4], v[5]});  // MuJoCo's is the body's own
  return motion;
}

std::vector<std::uint32_t> World::moved_products() const {
  std::vector<std::uint32_t> rows;
  for (const auto& [product, first] : state_->moved)
    rows.push_back(product);
  return rows;
}

double World::joint_position(std::uint32_t joint) const {
  const State& s = *state_;
  if (s.scene.joints[joint].kind == assets::JointKind::belt) return s.belt_speed[joint];
  const int at = s.store.joints[joint].qpos;
  return at < 0 ? 0 : s.d().qpos[at];
}

std::vector<double> World::joint_positions() const {
  std::vector<double> positions;
  for (std::uint32_t joint = 0; joint < state_->scene.joints.size(); ++joint)
    positions.push_back(joint_position(joint));
  return positions;
}

double World::joint_velocity(std::uint32_t joint) const {
  const int at = state_->store.joints[joint].dof;
  return at < 0 ? 0 : state_->d().qvel[at];
}

const std::vector<WorldContact>& World::contacts() const {
  return state_->contacts;
}

WorldCounts World::counts() const {
  const State& s = *state_;
  WorldCounts counts;
  counts.products = static_cast<int>(
      std::ranges::count_if(s.store.product_geom, [](int geom) { return geom >= 0; }));
  for (std::size_t body = 0; body < s.live.size(); ++body) {
    if (s.live[body].product < 0) continue;
    ++counts.in_pool;
    if (s.store.pool[body].soft()) ++counts.soft_in_pool;
    if (!s.asleep(body)) ++counts.awake;
  }
  counts.woken = s.woken, counts.refused = s.refusals, counts.stiffened = s.stiffened;
  return counts;
}

std::vector<WorldEvent> World::take_events() {
  return std::exchange(state_->events, {});
}
const std::vector<WorldCommand>& World::commands() const {
  return state_->commands;
}

Result<int> World::actuator(std::string_view name) const {
  const int id = mj_name2id(&model(), mjOBJ_ACTUATOR, std::string(name).c_str());
  if (id >= 0) return id;
  return bad_command("actuator", fmt::format("no actuator \"{}\"", name));
}
Result<double> World::distance_m(int geom, int other, double max_m) const {
  return state_->distance_m(geom, other, max_m);
}
const mjModel_& World::model() const {
  return state_->m();
}
const mjData_& World::data() const {
  return state_->d();
}

}  // namespace marketgen::physics
