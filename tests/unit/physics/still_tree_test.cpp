// What stands still in a tree, and what of it MuJoCo is shown: nothing that can touch is left out.
#include "physics/world/still_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "physics/goods/hull_meshes.h"
#include "physics/goods/rigid_goods.h"
#include "physics/world/near_tree.h"
#include "physics/world/store_model.h"
#include "physics/world/world_state.h"
#include "scene/placements.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

const scene::Scene& stocked_scene() {
  static const HandLaidShop shop = shop_of({"canned", "dairy", "beverages", "household"});
  static const scene::Scene scene =
      scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(3)).value();
  return scene;
}

physics::Box3 box_of_product(const physics::StoreModel& store, std::uint32_t product) {
  const mjModel& m = *store.model;
  const int geom = store.product_geom[product];
  mjtNum turned[9];
  mju_quat2Mat(turned, m.geom_quat + 4 * geom);
  return physics::box_of_geom(m, geom, m.geom_pos + 3 * geom, turned);
}

std::vector<int> found_one_by_one(const physics::StoreModel& store,
                                  const physics::StillTree& tree,
                                  const physics::Box3& box) {
  const mjModel& m = *store.model;
  const int first = m.body_geomadr[store.still_body];
  std::vector<int> found;
  for (int geom = first; geom < first + m.body_geomnum[store.still_body]; ++geom)
    if (m.geom_type[geom] != mjGEOM_PLANE && tree.box(geom).meets(box, 0)) found.push_back(geom);
  return found;
}

TEST(StillTree, FindsWhatLookingAtEveryBoxFinds) {
  const physics::StoreModel store = physics::store_model(stocked_scene(), {}).value();
  const physics::StillTree tree(*store.model, store.still_body);
  std::size_t most = 0;
  for (std::uint32_t product = 0; product < store.product_geom.size(); product += 37) {
    const physics::Box3 box = box_of_product(store, product);
    std::vector<int> found = tree.near(box);
    std::ranges::sort(found);
    EXPECT_EQ(found, found_one_by_one(store, tree, box));
    most = std::max(most, found.size());
  }
  EXPECT_GT(most, 1U);
}

TEST(StillTree, FindsWhatWasMovedWhereItIsNow) {
  const physics::StoreModel store = physics::store_model(stocked_scene(), {}).value();
  physics::StillTree tree(*store.model, store.still_body);
  const int geom = store.product_geom[5];
  const physics::Box3 before = box_of_product(store, 5);
  store.model->geom_pos[3 * geom + 2] += 7;  // above the ceiling
  tree.refit(*store.model, geom);
  const auto finds = [&](const physics::Box3& box) {
    return std::ranges::count(tree.near(box), geom);
  };
  EXPECT_EQ(finds(before), 0);
  EXPECT_EQ(finds(box_of_product(store, 5)), 1);
}

using Contact = std::tuple<int, int, double, double, double, double>;

std::vector<Contact> contacts_of(const physics::StoreModel& store, mjData& d) {
  mj_kinematics(store.model.get(), &d);
  mj_comPos(store.model.get(), &d);
  mj_collision(store.model.get(), &d);
  std::vector<Contact> found;
  for (int i = 0; i < d.ncon; ++i) {
    const mjContact& c = d.contact[i];
    found.emplace_back(c.geom[0], c.geom[1], c.dist, c.pos[0], c.pos[1], c.pos[2]);
  }
  return found;
}

// Every fifth product stands in its place as a body of the pool, so that it touches its neighbours
// as they stood.
TEST(NearTree, ContactsAreThoseOfTheWholeTreeInTheSameOrder) {
  const physics::StoreModel store = physics::store_model(stocked_scene(), {}).value();
  mjModel& m = *store.model;
  m.opt.enableflags &= ~mjENBL_SLEEP;
  const physics::MujocoData data = physics::make_data(m, "test").value();
  physics::HullMeshes hulls(m);
  physics::NearTree near(m, store.still_body);
  const std::size_t step = store.product_geom.size() / 100;
  for (std::size_t body = 0; body < 100; ++body) {
    const auto product = static_cast<std::uint32_t>(body * step);
    const scene::SceneProduct& item = stocked_scene().products[product];
    const auto goods =
        physics::rigid_goods(stocked_scene().catalog[item.sku], physics::GoodsUse::stocked).value();
    const Pose pose =
        Pose{{0.004, 0, -0.001}, {}} * scene::world_from_product(item) * goods->product_from_body;
    const int first_mesh = goods->model->nmesh > 0 ? hulls.add(*goods->model) : 0;
    physics::dress_body(
        m, *data, store.pool[body], *goods->model, first_mesh, physics::shape_pose_of(pose));
    near.follow(store.pool[body].geom, box_of_product(store, product));
  }
  for (std::size_t body = 100; body < store.pool.size(); ++body)
    physics::collide_body(m, store.pool[body], false);
  const std::vector<Contact> whole = contacts_of(store, *data);
  const int all_nodes = m.body_bvhnum[store.still_body];
  near.write(m);
  EXPECT_LT(m.body_bvhnum[store.still_body], all_nodes / 2);
  EXPECT_EQ(contacts_of(store, *data), whole);
  physics::shorten_bit_filter(m, store.still_body);
  const physics::FirstGeoms moving(m, m.body_geomadr[store.still_body]);
  EXPECT_EQ(contacts_of(store, *data), whole);
  EXPECT_GT(whole.size(), 300U);
}

TEST(NearTree, HoldsWhereItHasLookedAndLooksAgainFurtherAway) {
  const physics::StoreModel store = physics::store_model(stocked_scene(), {}).value();
  mjModel& m = *store.model;
  physics::NearTree near(m, store.still_body);
  const int mover = store.pool[0].geom;
  const physics::Box3 here = box_of_product(store, 0);
  const auto moved = [&](double by) {
    return physics::Box3{here.low + Vec3{by, 0, 0}, here.high + Vec3{by, 0, 0}};
  };
  EXPECT_FALSE(near.holds(mover, here));
  near.follow(mover, here);
  EXPECT_TRUE(near.holds(mover, here));
  EXPECT_TRUE(near.holds(mover, moved(0.005)));
  EXPECT_FALSE(near.holds(mover, moved(0.05)));
  near.follow(mover, moved(0.05));
  EXPECT_TRUE(near.holds(mover, moved(0.09)));  // as fast as that, it looks further
  near.refit(m, store.product_geom[0]);         // something stands there now
  EXPECT_FALSE(near.holds(mover, moved(0.05)));
}

}  // namespace
}  // namespace marketgen
