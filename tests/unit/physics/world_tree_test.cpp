// The tree over the world's geoms: nothing lost, boxes hold what is below them, fewer looks.
#include "physics/world_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "physics/body_patch.h"
#include "physics/store_model.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

StoreModel stocked_model() {
  const HandLaidShop shop = shop_of({"canned", "dairy", "beverages", "household"});
  const Scene scene = build_scene(shop.layout, shop.plan, committed_catalog(), Seed(3)).value();
  return store_model(scene, {}).value();
}

std::vector<int> leaves_of(const mjModel& m) {
  std::vector<int> geoms;
  for (int node = 0; node < m.body_bvhnum[0]; ++node) {
    const int geom = m.bvh_nodeid[m.body_bvhadr[0] + node];
    if (geom >= 0) geoms.push_back(geom);
  }
  std::ranges::sort(geoms);
  return geoms;
}

bool boxes_meet(const mjtNum* a, const mjtNum* b) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(a[i] - b[i]) > a[3 + i] + b[3 + i]) return false;
  return true;
}

// Nodes whose box is looked at when each still product is held against the tree.
long looks(const mjModel& m, const std::vector<int>& product_geom) {
  long count = 0;
  const int first = m.body_bvhadr[0];
  std::vector<int> leaf_of(static_cast<std::size_t>(m.ngeom), -1), open;
  for (int node = 0; node < m.body_bvhnum[0]; ++node)
    if (const int geom = m.bvh_nodeid[first + node]; geom >= 0)
      leaf_of[static_cast<std::size_t>(geom)] = node;
  for (const int geom : product_geom) {
    const mjtNum* box = m.bvh_aabb + 6 * (first + leaf_of[static_cast<std::size_t>(geom)]);
    open.assign(1, 0);
    while (!open.empty()) {
      const int node = open.back();
      open.pop_back();
      ++count;
      if (!boxes_meet(box, m.bvh_aabb + 6 * (first + node))) continue;
      for (int k = 0; k < 2; ++k)
        if (const int child = m.bvh_child[2 * (first + node) + k]; child >= 0)
          open.push_back(child);
    }
  }
  return count;
}

TEST(WorldTree, KeepsEveryGeomAndEveryBoxHoldsWhatIsBelow) {
  const StoreModel store = stocked_model();
  mjModel& m = *store.model;
  const std::vector<int> before = leaves_of(m);
  rebuild_world_tree(m);
  EXPECT_EQ(leaves_of(m), before);
  EXPECT_GT(before.size(), 500U);
  const WorldBounds bounds(m);
  const int first = m.body_bvhadr[0];
  for (int node = 0; node < m.body_bvhnum[0]; ++node) {
    const mjtNum* outer = m.bvh_aabb + 6 * (first + node);
    for (int k = 0; k < 2; ++k) {
      const int child = m.bvh_child[2 * (first + node) + k];
      ASSERT_EQ(child < 0, m.bvh_nodeid[first + node] >= 0);
      if (child < 0) continue;
      ASSERT_GT(child, node);
      EXPECT_EQ(m.bvh_depth[first + child], m.bvh_depth[first + node] + 1);
      const mjtNum* inner = m.bvh_aabb + 6 * (first + child);
      for (int i = 0; i < 3; ++i)
        EXPECT_LE(std::abs(outer[i] - inner[i]) + inner[3 + i], outer[3 + i] * (1 + 1e-9) + 1e-9);
    }
  }
}

TEST(WorldTree, LooksAtFewerBoxesThanMuJoCosOwn) {
  const StoreModel store = stocked_model();
  const long its_own = looks(*store.model, store.product_geom);
  rebuild_world_tree(*store.model);
  const WorldBounds bounds(*store.model);
  EXPECT_LT(looks(*store.model, store.product_geom), 0.7 * static_cast<double>(its_own));
}

TEST(WorldTree, ShortenedFilterKeepsOneProduct) {
  const StoreModel store = stocked_model();
  mjModel& m = *store.model;
  const int all = m.body_geomnum[0];
  shorten_world_filter(m, store.product_geom);
  EXPECT_LT(m.body_geomnum[0], all);
  EXPECT_EQ(
      std::ranges::count_if(store.product_geom, [&](int geom) { return geom < m.body_geomnum[0]; }),
      1);
  shorten_world_filter(m, {});  // no goods: as it was
  EXPECT_LT(m.body_geomnum[0], all);
}

}  // namespace
}  // namespace marketgen
