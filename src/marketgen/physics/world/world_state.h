// Inside of a World: the model, what differs from it, and the parts of a step.
#pragma once
#include <map>
#include <utility>

#include "physics/goods/body_patch.h"
#include "physics/goods/friction_table.h"
#include "physics/goods/hull_meshes.h"
#include "physics/goods/rigid_goods.h"
#include "physics/soft/soft_body.h"
#include "physics/world/cup_lip.h"
#include "physics/world/near_tree.h"
#include "physics/world/product_grid.h"
#include "physics/world/store_model.h"

namespace marketgen::physics {

// A door, drawer or flap with what hangs on it.
struct FixtureTree {
  int tree = 0;                       // MuJoCo's
  std::vector<std::uint32_t> joints;  // rows of Scene::joints
  std::vector<int> geoms;
};

// A door with a magnetic gasket, and its spring as the model was made with it. Near the frame the
// spring is replaced, before every step, by one that pulls as spring and gasket together do where
// the door is: MuJoCo has no spring that lets go, and a force applied from outside would keep a
// closed door awake for ever.
struct GasketDoor {
  std::uint32_t joint = 0;  // row of Scene::joints
  int id = 0;               // MuJoCo's
  double stiffness = 0, bend = 0, rest = 0;
};

// A body of the pool while it stands in for a product.
struct LiveBody {
  std::int64_t product = -1;           // -1: free
  Pose woke_at;                        // world_from_product
  std::vector<std::uint32_t> carries;  // static products that rest on it, until it moves away
  bool toppled = false, dropped = false, hooked = false;  // toppled, dropped: reported
  bool keeps = false;  // soft packs: asleep, and reported, but may not rest yet

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.product, self.woke_at, self.carries, self.toppled, self.dropped, self.hooked);
    archive(self.keeps);
  }
};

// A row of WorldOptions::cups in the model.
struct ModelCup {
  int body = 0;
  CupShape shape;
  LipPoints lip{};
  FrictionTable::Material material = FrictionTable::unknown;
};

// What a cup does.
struct LiveCup {
  struct Hold {
    int body = 0;  // of the model: of a soft pack the part under that point
    Vec3 on_body;

    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.body, self.on_body);
    }
  };
  bool sucks = false, broken = false;  // broken: by load; until it has come off what it held
  std::int64_t product = -1;           // sealed on; -1: none
  std::array<Hold, LipPoints{}.size()> holds{};
  LipLoad load = {};

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.sucks, self.broken, self.product, self.holds, self.load);
  }
};

// A soft pack of the catalog, made when one of them first wakes.
struct SoftGoods {
  SoftPack pack;
  MujocoModel model;
};

// A product that moves and is so deep in the still shape of another is where that is more than its
// pack: beside the neck of a bottle, in the curve of a handle.
constexpr double hollow_depth_m = 0.003;

// A row of the catalog as a rigid body, made when one of its products first wakes.
struct RigidRow {
  std::shared_ptr<const RigidGoods> goods;
  int first_mesh = 0;  // of its hulls in the World's model
};

struct World::State {
  State(const scene::Scene& scene_in,
        WorldOptions options_in,
        StoreModel store_in,
        MujocoData data_in);

  // ---- world_wake.cpp: products between static and moving ----

  // Makes a product movable; false when the pool is in use or the product absent.
  bool wake(std::uint32_t product);
  void fall_asleep(std::size_t body);  // of the pool: static from now on, if it may
  void report_rest(std::size_t body);
  void wake_carried(std::size_t body);
  std::vector<std::uint32_t> resting_on(std::uint32_t product, const Box3& box) const;
  bool heaped(std::uint32_t product) const;  // rolls, or lies in a heap
  bool loose(std::uint32_t product) const;   // heaped, or has been moved
  void hook(std::size_t body, std::uint32_t product);

  // ---- world_bodies.cpp: what a product is while it moves ----

  GoodsUse use_of(std::uint32_t product) const {
    return loose_rows[product] ? GoodsUse::bulk : GoodsUse::stocked;
  }
  const RigidRow& made_row(std::uint32_t product) const;  // that rigid_row() has made
  double mass_factor(std::uint32_t sku) const {
    return options.mass_factors.empty() ? 1 : options.mass_factors[sku];
  }
  // Null for a rigid product, and when `fault` is set.
  const SoftGoods* soft_goods(std::uint32_t product);
  const RigidRow* rigid_row(std::uint32_t product);  // null when `fault` is set
  // Of the pool; -1: none. Rigid ones stand in for soft ones.
  int free_body(bool soft) const;
  bool make_ready(std::uint32_t product, bool soft);  // to be dressed so; false when `fault` is set
  void dress(std::size_t body, std::uint32_t product, const Pose& world_from_product);
  Pose product_from_body(std::size_t body) const;  // of its product; of a soft pack's base
  Pose world_from_body(std::size_t body) const;
  bool may_rest(std::size_t body) const;  // asleep, and its still shape can take over
  void wake_kept();                       // those that sleep and may not rest
  void push_body(std::size_t body, const Wrench& wrench);

  // ---- world.cpp: commands ----

  Result<void> obey(const WorldCommand& command);
  Result<void> obey_product(const WorldCommand& command);
  Result<void> run(std::uint32_t count);
  Result<void> force_joint(std::uint32_t joint, double force);
  Result<void> start_belt(std::uint32_t joint, double speed);
  void run_belt(std::uint32_t joint, double speed_m_s);
  Result<void> put_mocap(std::uint32_t body, Pose pose);
  std::vector<std::uint32_t> resting_on_belt(const Box3& belt) const;

  // ---- world_step.cpp ----

  Result<void> step_once();
  bool in_hand() const;  // an actor touched something but the room and itself in the last step
  bool wake_touched();   // after the contacts are known; true when any woke
  Result<void> wake_near_actors();
  Result<void> wake_near_moving_fixtures();
  Result<double> distance_m(int geom, int other, double max_m);
  Result<void> wake_within(int geom, double reach_m);  // products as near as that to a geom
  void follow(std::size_t body);  // reports what happened to it, rests it when it sleeps
  void release_hooks();
  void clear_wakes();
  Result<void> check_warnings() const;

  // ---- world_gaskets.cpp ----

  void find_gaskets();
  void pull_gaskets();

  // ---- world_cups.cpp ----

  void find_cups();
  Result<void> suck(std::uint32_t cup, bool on);
  void keep_sealed_awake();
  Result<void> seal_cups();  // after the contacts are known
  Result<bool> seal(std::size_t cup);
  std::optional<UnderLip> under_lip(std::size_t cup) const;  // of one product
  std::uint32_t product_of(int geom) const;
  void hold(std::size_t cup);  // by its points, as it is sealed
  void release(std::size_t cup);
  void look_at_lips();  // after a step
  Pose world_from_lip(std::size_t cup) const;

  // ---- world_near.cpp: what the near tree holds ----

  Result<void> find_contacts();  // mj_step1, with all that can touch in the near tree
  void look_round();
  bool actors_within() const;  // still where look_round() has looked
  Box3 body_box(std::size_t body) const;
  Box3 actor_box(int geom) const;

  // ---- world_contacts.cpp ----

  void set_frictions();
  Result<void> read_contacts();
  void wake_pressed();  // static products on which something leans that was not there before
  ContactSide side_of(int geom) const;

  // ---- world_snapshot.cpp ----

  void stand(std::uint32_t product, const ShapePose& pose);
  void stand_as_built();

  // ---- shared ----

  const scene::Scene& scene;
  WorldOptions options;
  StoreModel store;
  MujocoData data;
  NearTree near;     // for MuJoCo: what stands still near what moves
  ProductGrid grid;  // of static products
  FrictionTable frictions;
  std::vector<FrictionTable::Material> sku_material, geom_material;
  std::vector<Pose> shape_from_product;      // by SKU
  std::vector<bool> loose_rows;              // by product: of WorldOptions::loose
  std::vector<bool> hand_geoms;              // by geom: of an actor, and no mere thing
  std::vector<int> actor_geoms;              // that collide and whose body can move
  std::vector<int> jointed_geoms;            // of these, those of bodies with joints: no mocap
  std::vector<std::vector<int>> belt_geoms;  // by joint
  std::vector<FixtureTree> fixture_trees;
  std::vector<GasketDoor> gaskets;
  std::vector<ModelCup> cups;  // as WorldOptions::cups

  std::vector<int> body_of;                  // by product: in the pool, -1 static
  std::vector<LiveBody> live;                // by pool body
  std::map<std::uint32_t, ShapePose> moved;  // products ever woken, with where they first stood
  std::vector<bool> refused;                 // by product: reported
  std::vector<double> belt_speed;            // by joint
  std::vector<double> looked_at;  // by joint: where it was when its goods were looked for
  std::vector<Box3> running_belts;
  std::vector<std::pair<std::uint32_t, Wrench>> pushes;
  std::vector<LiveCup> live_cups;  // by cup
  std::vector<WorldContact> contacts;
  std::vector<WorldEvent> events;
  std::vector<WorldCommand> commands;
  std::int64_t steps = 0, woken = 0, refusals = 0, stiffened = 0;
  std::map<std::uint32_t, std::optional<SoftGoods>> soft;        // by row of the catalog, as needed
  std::map<std::pair<std::uint32_t, GoodsUse>, RigidRow> rigid;  // the same, by what it is to be
  HullMeshes hulls;                                              // theirs
  std::optional<Error> fault;  // of a row that was needed; the command under way reports it
  bool failed = false;

  mjModel& m() { return *store.model; }
  const mjModel& m() const { return *store.model; }
  mjData& d() { return *data; }
  const mjData& d() const { return *data; }
  bool asleep(std::size_t body) const { return data->tree_asleep[store.pool[body].tree] >= 0; }
  std::uint32_t sku_of(std::uint32_t product) const { return scene.products[product].sku; }
  ShapePose shape_pose(std::uint32_t product) const;  // of its still shape, also while it moves
  Pose product_pose(std::uint32_t product) const;
  Box3 box_at(std::uint32_t product, const ShapePose& pose) const;
  void report(EventKind kind, std::uint32_t product);
  void update_running_belts();
  void find_fixture_trees();
  void find_hands();
};

Pose pose_of(const ShapePose& shape);
ShapePose shape_pose_of(const Pose& pose);

}  // namespace marketgen::physics
