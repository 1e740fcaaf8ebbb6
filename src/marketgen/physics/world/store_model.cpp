#include "physics/world/store_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/shapes/contact_pieces.h"
#include "physics/goods/goods_body.h"
#include "physics/goods/spec_geoms.h"
#include "physics/soft/soft_body.h"
#include "physics/world/cup_lip.h"
#include "physics/world/fixture_bodies.h"
#include "physics/world/shell_pieces.h"
#include "physics/world/still_geoms.h"
#include "scene/placements.h"

namespace marketgen::physics {
namespace {

constexpr char world_where[] = "world";
// Address space of MuJoCo's arena, touched as needed: contacts and their equations.
constexpr mjtSize arena_bytes = 64 << 20;
// Slower than this for ten steps is at rest: measured, asleep after 21 to 32 resting steps.
constexpr double bubble_sleep_below_m_s = 1e-3;
// MuJoCo's 0.9 is by the weight of the flap, which is little: the pack would hang 2 mm lower.
constexpr double flap_hook_impedance = 0.999;
constexpr double pool_depth_m = -100;  // where bodies of the pool wait until first used
// Of a body of the pool until it is first used.
const assets::ContactShape blank_piece{assets::CollisionShape::box, {}, {0.05, 0.05, 0.05}};
constexpr double max_friction = 2;  // as in a FrictionRow

using Region = std::array<double, 4>;

bool touches(const Region& r, Vec3 center, Vec3 half) {
  return center.x + half.x >= r[0] && center.x - half.x <= r[2] && center.y + half.y >= r[1] &&
         center.y - half.y <= r[3];
}

Error bad_option(const std::string& name, const std::string& message) {
  return {"physics.bad_command", "WorldOptions." + name, message};
}

class StoreBuilder {
 public:
  StoreBuilder(const scene::Scene& scene, const WorldOptions& options)
      : scene_(scene),
        options_(options),
        spec_(mj_makeSpec(), mj_deleteSpec),
        world_(mjs_findBody(spec_.get(), "world")) {
    set_contact_options(*spec_, bubble_sleep_below_m_s);
    spec_->option.disableflags |= mjDSBL_AUTORESET;
    spec_->memory = arena_bytes;
    spec_->compiler.degree = false;  // limits of hinges are in radians, ours and the actors'
  }

  void add_room() {
    for (const ShellPiece& piece : shell_pieces(scene_.layout.shell)) {
      const assets::ContactShape box{assets::CollisionShape::box, piece.pose, piece.half_size};
      if (near(box)) furnish(still_.add(box));
    }
    fixtures_ = add_fixtures(
        world_,
        still_,
        scene_,
        [&](std::uint32_t row) {
          const scene::ScenePart& part = scene_.parts[row];
          return near(scene::world_from_fixture(scene_, part.fixture) * contact_shape_of(part));
        },
        options_.articulated);
  }

  Result<void> add_goods(StoreModel& made) {
    for (const catalog::Product& product : scene_.catalog) {
      MARKETGEN_TRY(StandingGoods goods, standing_goods(product));
      if (!options_.mass_factors.empty()) goods.mass_kg *= options_.mass_factors[made.goods.size()];
      made.goods.push_back(goods);
    }
    for (const std::uint32_t row : options_.loose) {
      MARKETGEN_TRY(const SharedGoodsBody body,
                    goods_body(scene_.catalog[scene_.products[row].sku], GoodsUse::bulk));
      pieces_a_body_ = std::max(pieces_a_body_, static_cast<int>(body->body.pieces.size()));
    }
    product_geoms_.resize(scene_.products.size(), nullptr);
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      const scene::SceneProduct& item = scene_.products[row];
      const StandingGoods& goods = made.goods[item.sku];
      const assets::ContactShape shape = scene::world_from_product(item) * goods.shape;
      if (!near(shape)) continue;
      mjsGeom* geom = still_.add(shape);
      set_goods_contact(geom, goods.contact);
      geom->contype = still_goods_contact_type;
      geom->conaffinity = goods_affinity;
      product_geoms_[row] = geom;
    }
    return {};
  }

  void add_pool() {
    for (int i = 0; i < options_.pool; ++i) {
      const std::string name = fmt::format("pool-{}", i);
      mjsBody* body = mjs_addBody(world_, nullptr);
      mjs_setName(body->element, name.c_str());
      mjs_addFreeJoint(body);
      body->mass = body->inertia[0] = body->inertia[1] = body->inertia[2] = 1;
      body->explicitinertial = true;
      std::vector<mjsGeom*> geoms;
      for (int piece = 0; piece < pieces_a_body_; ++piece)
        geoms.push_back(blanks_.add(blank_piece));
      add_slot(name, body, std::move(geoms), 1);
    }
    for (int i = 0; i < options_.soft_pool; ++i) {
      const std::string name = fmt::format("soft-{}", i);
      const SoftElements made = add_soft_body(world_, plain_soft_pack(), name);
      add_slot(name, made.bodies[0], {made.geoms.begin(), made.geoms.end()}, SoftPack::part_count);
    }
  }

  Result<void> add_actors() {
    Result<void> added;
    if (options_.add_actors)
      MARKETGEN_CHECK(
          guarded("WorldOptions.add_actors", [&] { added = options_.add_actors(*spec_); }));
    MARKETGEN_CHECK(added);
    return add_cups();
  }

  Result<void> finish(StoreModel& made) {
    mjsBody* const blank = mjs_addBody(world_, nullptr);
    blank->explicitinertial = true;
    MARKETGEN_CHECK(blanks_.attach_to(blank, *spec_, "blank"));
    mjsBody* const still = add_still_body();
    MARKETGEN_CHECK(still_.attach_to(still, *spec_, "still"));
    MARKETGEN_TRY(made.model, compile(*spec_, world_where));
    hand_out_blanks(*made.model, mjs_getId(blank->element));
    made.still_body = mjs_getId(still->element);
    made.owners.assign(static_cast<std::size_t>(made.model->ngeom), {BodyKind::actor, 0});
    const int first_pool_body = mjs_getId(pool_.front().body->element);
    for (std::size_t geom = 0; geom < made.owners.size(); ++geom) {
      made.owners[geom].row = static_cast<std::uint32_t>(geom);
      const int body = made.model->geom_bodyid[geom];
      if (body < first_pool_body || body == made.still_body)
        made.owners[geom] = {BodyKind::room, 0};
    }
    name_owners(made);
    for (const PoolElements& elements : pool_)
      made.pool.push_back(pool_body(*made.model, elements));
    for (const FixtureJointElement& element : fixtures_.joints)
      made.joints.push_back(joint_address(*made.model, element.joint));
    return {};
  }

 private:
  Result<void> add_cups() {
    for (const WorldCup& cup : options_.cups) {
      if (mjs_findBody(spec_.get(), cup.body.c_str()) == nullptr)
        return bad_option("cups", fmt::format("add_actors has added no body \"{}\"", cup.body));
      add_lip(*spec_, cup.body, cup.body_from_lip, cup.radius_m);
    }
    return {};
  }

  struct PoolElements {
    mjsBody* body;
    std::vector<mjsGeom*> geoms;
    mjsEquality* hook;
    int parts;
  };

  // Asleep, in a row far below the floor, on no hook.
  void add_slot(const std::string& name, mjsBody* body, std::vector<mjsGeom*> geoms, int parts) {
    body->pos[0] = static_cast<double>(pool_.size()), body->pos[2] = pool_depth_m;
    body->sleep = mjSLEEP_INIT;
    for (mjsGeom* geom : geoms)
      geom->conaffinity = goods_affinity;
    mjsEquality* hook = mjs_addEquality(spec_.get(), nullptr);
    hook->type = mjEQ_CONNECT;
    hook->objtype = mjOBJ_BODY;
    hook->active = false;
    mjs_setString(hook->name1, name.c_str());
    std::fill(hook->data, hook->data + mjNEQDATA, 0.0);
    if (parts > 1) hook->solimp[0] = hook->solimp[1] = flap_hook_impedance;
    pool_.push_back({body, std::move(geoms), hook, parts});
  }

  // Added last, so that it comes last; its frame is the store's.
  mjsBody* add_still_body() {
    mjsBody* body = mjs_addBody(world_, nullptr);
    body->explicitinertial = true;
    furnish(add_floor(body));
    return body;
  }

  bool near(const assets::ContactShape& shape) const {
    return !options_.region_m ||
           touches(*options_.region_m, shape.pose.position, assets::half_extents(shape));
  }

  void furnish(mjsGeom* geom) {
    geom->contype = furniture_contact_type;
    geom->conaffinity = furniture_affinity;
  }

  // Geoms of bodies that move take 50 us each to add, those of one that stands still 10: so the
  // pool's are made there, with the nodes of its tree of boxes, and go to the pool's bodies when
  // all is compiled.
  void hand_out_blanks(mjModel& m, int blank) const {
    int node = m.body_bvhadr[blank];
    for (const PoolElements& elements : pool_) {
      if (elements.parts > 1) continue;
      const int body = mjs_getId(elements.body->element);
      m.body_geomadr[body] = mjs_getId(elements.geoms.front()->element);
      m.body_geomnum[body] = pieces_a_body_;
      m.body_bvhadr[body] = node;
      m.body_bvhnum[body] = 2 * pieces_a_body_ - 1;
      node += 2 * pieces_a_body_ - 1;
      std::fill_n(m.geom_bodyid + m.body_geomadr[body], pieces_a_body_, body);
    }
    m.body_geomnum[blank] = m.body_bvhnum[blank] = 0;
  }

  void name_owners(StoreModel& made) const {
    const auto owner = [&](const mjsGeom* geom) -> GeomOwner& {
      return made.owners[static_cast<std::size_t>(mjs_getId(geom->element))];
    };
    for (const FixtureGeom& fixture : fixtures_.geoms)
      owner(fixture.geom) = {BodyKind::fixture, fixture.part};
    made.product_geom.assign(scene_.products.size(), -1);
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      if (product_geoms_[row] == nullptr) continue;
      owner(product_geoms_[row]) = {BodyKind::product, row};
      made.product_geom[row] = mjs_getId(product_geoms_[row]->element);
    }
    for (std::uint32_t i = 0; i < pool_.size(); ++i) {
      for (const mjsGeom* geom : pool_[i].geoms)
        owner(geom) = {BodyKind::product, i, true};
    }
  }

  static PoolBody pool_body(const mjModel& model, const PoolElements& elements) {
    PoolBody made;
    made.body = mjs_getId(elements.body->element);
    made.geom = mjs_getId(elements.geoms.front()->element);
    made.parts = elements.parts;
    made.geoms = static_cast<int>(elements.geoms.size());
    made.hook = mjs_getId(elements.hook->element);
    made.tree = model.body_treeid[made.body];
    made.dof = model.body_dofadr[made.body];
    made.qpos = model.jnt_qposadr[model.body_jntadr[made.body]];
    return made;
  }

  static JointAddress joint_address(const mjModel& model, const mjsJoint* joint) {
    if (joint == nullptr) return {};
    const int id = mjs_getId(joint->element);
    return {model.jnt_qposadr[id], model.jnt_dofadr[id]};
  }

  const scene::Scene& scene_;
  const WorldOptions& options_;
  StillGeoms still_, blanks_;  // outlive spec_
  MujocoSpec spec_;
  mjsBody* world_;
  FixtureElements fixtures_;
  std::vector<mjsGeom*> product_geoms_;
  std::vector<PoolElements> pool_;
  int pieces_a_body_ = assets::PieceLimits{}.max_pieces;  // of the pool: what any product may need
};

Result<void> check_masses(const scene::Scene& scene, const std::vector<double>& factors) {
  if (!factors.empty() && factors.size() != scene.catalog.size())
    return bad_option(
        "mass_factors",
        fmt::format(
            "{} of them for {} rows of the catalogue", factors.size(), scene.catalog.size()));
  for (const double factor : factors)
    if (!(factor > 0 && std::isfinite(factor)))
      return bad_option("mass_factors",
                        fmt::format("{}; expected finite, positive numbers", factor));
  return {};
}

Result<void> check_options(const scene::Scene& scene, const WorldOptions& options) {
  for (const std::uint32_t row : options.loose) {
    if (row >= scene.products.size())
      return bad_option("loose",
                        fmt::format("no product {}; the scene has {}", row, scene.products.size()));
  }
  if (options.pool < 1 || options.pool > max_pool)
    return bad_option("pool",
                      fmt::format("{} bodies; 1 to {} are possible", options.pool, max_pool));
  if (options.soft_pool < 0 || options.soft_pool > max_soft_pool)
    return bad_option(
        "soft_pool",
        fmt::format("{} bodies; 0 to {} are possible", options.soft_pool, max_soft_pool));
  if (!(options.wake_within_m >= 0 && options.wake_within_m <= 0.5))
    return bad_option("wake_within_m",
                      fmt::format("{} m; 0 to 0.5 are possible", options.wake_within_m));
  for (const catalog::FrictionRow& row : options.frictions) {
    if (!(row.sliding > 0 && row.sliding <= max_friction))
      return bad_option("frictions",
                        fmt::format("{} on {}: {}; more than 0 and at most {} are possible",
                                    row.a,
                                    row.b,
                                    row.sliding,
                                    max_friction));
  }
  MARKETGEN_CHECK(check_masses(scene, options.mass_factors));
  for (const WorldCup& cup : options.cups) {
    const bool sized = cup.radius_m > 0 && cup.seal_depth_m >= 0 && cup.pull_n >= 0;
    if (!sized || !std::isfinite(cup.radius_m + cup.seal_depth_m + cup.pull_n))
      return bad_option("cups", fmt::format("\"{}\": expected finite, positive sizes", cup.body));
  }
  if (!options.region_m) return {};
  const auto& [x0, y0, x1, y1] = *options.region_m;
  if (!(x0 < x1 && y0 < y1) || !std::isfinite(x1 - x0) || !std::isfinite(y1 - y0))
    return bad_option("region_m", "expected x0 < x1 and y0 < y1, in metres");
  return {};
}

}  // namespace

Result<StoreModel> store_model(const scene::Scene& scene, const WorldOptions& options) {
  MARKETGEN_CHECK(check_options(scene, options));
  StoreModel made;
  StoreBuilder builder(scene, options);
  MARKETGEN_CHECK(builder.add_goods(made));
  builder.add_room();
  builder.add_pool();
  MARKETGEN_CHECK(builder.add_actors());
  MARKETGEN_CHECK(builder.finish(made));
  return made;
}

bool hangs_on_hook(const scene::Scene& scene, std::uint32_t product) {
  const std::uint32_t facing = scene.products[product].facing;
  return facing != scene::no_facing &&
         scene.shelves[scene.facings[facing].shelf].use == assets::ShelfUse::hang;
}

}  // namespace marketgen::physics
