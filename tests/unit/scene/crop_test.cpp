// A part of a store as a scene of its own: sound, and everything in it stands where it stood.
#include "scene/crop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scene/placements.h"
#include "scene/scene_file.h"
#include "scene_of.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

const scene::Scene& whole_shop() {
  static const scene::Scene scene = scene_of(shop_of({"dairy", "frozen", "snacks", "checkout"}));
  return scene;
}

std::map<std::string, const scene::SceneProduct*> products_by_id(const scene::Scene& scene) {
  std::map<std::string, const scene::SceneProduct*> products;
  for (std::uint32_t i = 0; i < scene.products.size(); ++i)
    products[scene::product_id(scene, i)] = &scene.products[i];
  return products;
}

std::string fixture_of(const std::string& product_id) {
  return product_id.substr(0, std::min(product_id.find("/back/"), product_id.find("/level-")));
}

// Not the first fixture, so that every table begins elsewhere; joints are on the freezer and the
// lane.
std::vector<std::uint32_t> kept_rows() {
  const std::vector<layout::Fixture>& all = whole_shop().layout.fixtures;
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 1; i < all.size(); ++i)
    if (all[i].zone != "dairy") rows.push_back(i);
  return rows;
}

TEST(Crop, IsASoundSceneOfTheFixturesAskedFor) {
  const scene::Scene part = scene::cropped(whole_shop(), kept_rows());
  const auto checked = scene::check_indices(part, "part");
  ASSERT_TRUE(checked.ok()) << to_string(checked.error());
  ASSERT_EQ(part.fixtures.size(), kept_rows().size());
  EXPECT_LT(part.parts.size(), whole_shop().parts.size());
  EXPECT_GT(part.joints.size(), 0U);
  for (std::uint32_t i = 0; i < part.fixtures.size(); ++i) {
    const std::uint32_t row = kept_rows()[i];
    const scene::SceneFixture &now = part.fixtures[i], &before = whole_shop().fixtures[row];
    EXPECT_EQ(part.layout.fixtures[i].id, whole_shop().layout.fixtures[row].id);
    EXPECT_EQ(now.position_m, before.position_m);
    ASSERT_EQ(now.part_count, before.part_count);
    for (std::uint32_t p = 0; p < now.part_count; ++p) {
      const scene::ScenePart& made = part.parts[now.first_part + p];
      const scene::ScenePart& old = whole_shop().parts[before.first_part + p];
      EXPECT_EQ(made.fixture, i);
      EXPECT_EQ(made.position_m, old.position_m);
      ASSERT_EQ(made.joint < 0, old.joint < 0);
      if (made.joint < 0) continue;
      EXPECT_EQ(part.joints[static_cast<std::size_t>(made.joint)].name,
                whole_shop().joints[static_cast<std::size_t>(old.joint)].name);
    }
  }
  EXPECT_TRUE(part.layout.violations.empty());
  EXPECT_EQ(part.layout.shell.width_mm, whole_shop().layout.shell.width_mm);
}

TEST(Crop, ItsProductsAreThoseOfItsFixturesWhereTheyStood) {
  const scene::Scene part = scene::cropped(whole_shop(), kept_rows());
  const auto before = products_by_id(whole_shop()), now = products_by_id(part);
  ASSERT_FALSE(now.empty());
  for (const auto& [id, product] : before) {
    const bool stays = layout::find_fixture(part.layout, fixture_of(id)) != nullptr;
    ASSERT_EQ(now.contains(id), stays) << id;
    if (!stays) continue;
    EXPECT_EQ(now.at(id)->position_m, product->position_m) << id;
    EXPECT_EQ(now.at(id)->rotation_wxyz, product->rotation_wxyz) << id;
    EXPECT_EQ(part.catalog[now.at(id)->sku].sku, whole_shop().catalog[product->sku].sku) << id;
  }
  EXPECT_LT(now.size(), before.size());
  EXPECT_LT(part.catalog.size(), whole_shop().catalog.size());
  ASSERT_FALSE(part.price_labels.empty());
  for (const scene::PriceLabel& label : part.price_labels)
    EXPECT_EQ(label.shelf, part.facings[label.facing].shelf);
}

TEST(Crop, TheWholeIsTheSameScene) {
  scene::Scene whole = whole_shop();
  whole.layout.violations.clear();
  std::vector<std::uint32_t> all(whole.fixtures.size());
  for (std::uint32_t i = 0; i < all.size(); ++i)
    all[i] = i;
  EXPECT_EQ(scene::scene_hash(scene::cropped(whole, all)), scene::scene_hash(whole));
}

// One lies on the shelf, the other in the room's corner.
TEST(Crop, WhatIsOnNoShelfStaysWhereAFixtureDoes) {
  HandMadeScene made;
  made.stock();
  for (const float x : {HandMadeScene::shelf_x_m, 1.0F})
    made.scene.products.push_back(
        {2, scene::no_facing, {x, HandMadeScene::shelf_y_m, HandMadeScene::upper_board_m}});
  const scene::Scene part = scene::cropped(made.scene, {0});
  ASSERT_EQ(part.products.size(), made.scene.products.size() - 1);
  EXPECT_EQ(part.products.back().position_m[0], HandMadeScene::shelf_x_m);
  EXPECT_EQ(part.catalog[part.products.back().sku].sku, "fruit-apple");
  EXPECT_TRUE(scene::cropped(made.scene, {}).products.empty());
}

}  // namespace
}  // namespace marketgen
