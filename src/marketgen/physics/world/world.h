// A stocked store that moves: any product can be touched at any moment, and a step costs what is
// moving, not what is on the shelves.
//
// All products are static shapes of one MuJoCo model. One that is touched is woken: its static
// shape is switched off and a free body from a pool takes its place, in the same step. When it has
// come to rest its body goes back to the pool and its static shape stands where it now lies. What
// rests on a product is woken as soon as that product has moved away.
//
// Bags and pouches wake as soft packs (physics/soft/soft_pack.h), from a pool of their own. One
// that rests bent, or with an actor at it, keeps its body, asleep, as long as that is so.
//
// Store frame, SI units. Rows are those of the Scene's tables. A World is a function of its scene,
// its options and its commands: bit for bit, in any thread and any process. Not thread-safe; use
// one World a thread. The Scene must outlive it.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/rows.h"
#include "scene/scene.h"

struct mjSpec_;
struct mjModel_;
struct mjData_;

namespace marketgen::physics {

// A suction cup of an actor. It seals on goods as physics/world/cup_lip.h says.
struct WorldCup {
  std::string body;  // of the specification, that carries it; one cup a body
  Pose body_from_lip;
  double radius_m = 0, seal_depth_m = 0, pull_n = 0;
  std::string material = "rubber";  // of its lip
};

struct WorldOptions {
  // x0, y0, x1, y1: only what stands there is in the model; other products are absent. Empty: all.
  std::optional<std::array<double, 4>> region_m = {};
  int pool = 128;  // products that can be awake at once, 1..1024
  // Products that lie loose among others, in a basket or on a counter, in any order: bodies of
  // GoodsUse::bulk, always rigid, which they keep while they rest. They stand still until they are
  // first touched or placed.
  std::vector<std::uint32_t> loose = {};
  int soft_pool = 12;        // bags and pouches that can be awake as soft packs, 0..256
  double wake_within_m = 0;  // wakes products this near to an actor before it touches them, 0..0.5
  bool articulated = true;   // doors, drawers, flaps and keys move; otherwise they stand at 0
  std::vector<catalog::FrictionRow> frictions =
      {};  // catalog.frictions; a pair without a row rubs as MuJoCo has it
  // By row of the scene's catalogue, what its packs' masses are multiplied by: they then weigh
  // something else than their row says. Empty: 1.
  std::vector<double> mass_factors = {};
  bool keep_commands = true;  // for commands(); a long run of a robot holds hundreds of megabytes
  // Adds robots, tools, tables: anything that is neither fixture nor product. Called once. Bodies
  // that it adds are "actors": a product that one of them touches is woken.
  // An actor whose bodies have no drive (a basket) is a thing, not a hand: what lies in it is not
  // held.
  std::function<Result<void>(mjSpec_& spec)> add_actors = {};
  std::map<std::string, std::string> actor_materials =
      {};                           // geom name -> contact material ("rubber")
  std::vector<WorldCup> cups = {};  // on bodies that add_actors adds
  // Bodies that add_actors adds and that keep clear of goods by themselves: none is woken for them.
  std::set<std::string> bystanders = {};
};

struct Wrench {
  Vec3 force_n, torque_n_m;  // store frame, at the centre of mass
};

// What one World was told, in order; replay() tells it to another.
enum class CommandKind { step, control, joint_force, belt_speed, mocap, push, wake, place, suck };
struct WorldCommand {
  CommandKind kind = CommandKind::step;
  std::uint32_t index = 0;        // actuator, joint, mocap body, product or cup; step: how many
  std::array<double, 7> value{};  // as far as the kind needs it
};

enum class EventKind {
  woke,         // became movable
  fell_asleep,  // came to rest; stands where product_pose() says
  displaced,    // came to rest more than 2 cm from where it woke
  toppled,      // leans by more than 45 degrees from how it stood
  dropped,      // has fallen by more than 10 cm, faster than 0.5 m/s
  refused       // should have woken, but the pool is in use: it stays fixed
};
constexpr std::array<std::string_view, 6> names_of(EventKind) {
  return {"woke", "fell_asleep", "displaced", "toppled", "dropped", "refused"};
}
struct WorldEvent {
  EventKind kind = EventKind::woke;
  std::uint32_t product = 0;
  double time_s = 0;
};

// One side of a contact.
enum class BodyKind { room, fixture, product, actor };
struct ContactSide {
  BodyKind kind = BodyKind::room;
  std::uint32_t row = 0;  // in parts for a fixture, in products; MuJoCo's geom id for an actor
};
struct WorldContact {  // a's kind is not behind b's
  ContactSide a, b;
  Vec3 position, normal;  // normal from a to b, unit
  double depth_m = 0;     // negative while apart
  double normal_n = 0, tangential_n = 0;
  Vec3 force_n;         // on b, store frame
  double friction = 0;  // sliding
};

struct ProductMotion {
  Pose pose;                         // world_from_product
  Vec3 velocity_m_s, angular_rad_s;  // of the centre of mass, store frame
};

struct WorldCounts {
  int products = 0, awake = 0, in_pool = 0;  // in the model; moving; bodies in use
  int soft_in_pool = 0;                      // of those in use, soft packs
  // Since the start. Stiffened: soft packs that woke as rigid boxes, all soft bodies being in use.
  std::int64_t woken = 0, refused = 0, stiffened = 0;
};

struct WorldSnapshot;

class World {
 public:
  // Errors: physics.failed (MuJoCo refuses the model), physics.bad_command (options: numbers out of
  // their ranges, another number of mass factors than of rows), assets.*,
  // catalog.bad_row (a product without mass or size), and those of add_actors.
  static Result<World> create(const scene::Scene& scene, WorldOptions options);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  // ---- Commands. Error physics.bad_command: no such thing, or a number that is not finite. The
  // world is then as before. ----

  // Steps of 2 ms. Error physics.failed: the state has become infinite; restore a snapshot.
  Result<void> step(int count = 1);
  Result<void> set_control(int actuator, double value);
  Result<void> set_joint_force(std::uint32_t joint,
                               double force);  // row in joints; N or N m; stays
  Result<void> set_belt_speed(std::uint32_t joint, double speed_m_s);  // within its limits
  Result<void> move_mocap(std::string_view body, const Pose& pose);
  // During the next call of step, which finds the product awake. A wrench of 0 keeps it so.
  Result<void> push(std::uint32_t product, const Wrench& wrench);
  Result<void> wake(std::uint32_t product);
  Result<void> place(std::uint32_t product, const Pose& world_from_product);  // at rest, awake
  // From now on a cup seals on the product that its lip comes to lie on, or, off, lets go. While it
  // is sealed the product stays awake. An overloaded lip breaks, and seals again only when it has
  // come off, or was told off and on.
  Result<void> suck(std::uint32_t cup, bool on);
  Result<void> apply(const WorldCommand& command);

  // ---- State. A row that does not exist is a programming fault. ----

  double time_s() const;
  bool has(std::uint32_t product) const;  // in the model
  bool awake(std::uint32_t product) const;
  Pose product_pose(std::uint32_t product) const;
  ProductMotion product_motion(std::uint32_t product) const;
  std::vector<std::uint32_t> moved_products() const;  // woken at some time; sorted
  double joint_position(std::uint32_t joint) const;   // belts: their speed
  std::vector<double> joint_positions() const;        // of all rows of the scene's joints
  double joint_velocity(std::uint32_t joint) const;
  const std::vector<WorldContact>& contacts() const;  // of the last step, with what was awake
  WorldCounts counts() const;
  std::vector<WorldEvent> take_events();  // since the last call, in order

  // ---- For robots. ----

  Result<int> actuator(std::string_view name) const;
  // Between two of MuJoCo's geoms, by GJK; less than 0 in one another, max_m where it is more.
  // Precondition: there are such geoms. Error physics.failed.
  Result<double> distance_m(int geom, int other, double max_m) const;
  Result<std::uint32_t> cup(std::string_view body) const;  // its row in WorldOptions::cups
  bool sucks(std::uint32_t cup) const;                     // it is on, sealed or not
  std::optional<std::uint32_t> sealed_product(std::uint32_t cup) const;
  const mjModel_& model() const;
  const mjData_& data() const;

  // ---- Repeating. ----

  // Continuing from a snapshot gives the same bits as continuing without one.
  WorldSnapshot snapshot() const;
  // Error physics.bad_command: the snapshot is of another scene or of other options.
  Result<void> restore(const WorldSnapshot& snapshot);
  const std::vector<WorldCommand>& commands() const;  // since create, or as the snapshot had them
  std::string state_hash() const;                     // 32 hex digits over every bit of the state

 private:
  struct State;
  explicit World(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
  friend struct WorldSnapshot;
};

// A moment of a World. Cheap to copy; may be restored by any World made alike, in another process
// too: as bytes it goes there.
struct WorldSnapshot {
  struct Content;
  std::shared_ptr<const Content> content;

  std::string bytes() const;  // of one that World::snapshot() made
  // Error physics.bad_command: they end too soon. Bytes that were changed otherwise must not come
  // here: whoever keeps them checks that.
  static Result<WorldSnapshot> of_bytes(std::string_view bytes);
};

// Tells `world` all of `commands`. Errors: those of the commands.
Result<void> replay(World& world, std::span<const WorldCommand> commands);

}  // namespace marketgen::physics
