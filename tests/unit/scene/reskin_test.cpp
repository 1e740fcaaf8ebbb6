// Another look for a finished scene.
#include "scene/reskin.h"

#include <gtest/gtest.h>

#include "plan/style_look.h"
#include "scene_of.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

const catalog::StyleRow& style_named(std::string_view name) {
  return *committed_catalog().style(name);
}

TEST(Reskin, MovesNothingAndChangesTheLook) {
  const scene::Scene before = scene_of(shop_of(selling_types()));
  ASSERT_GE(committed_catalog().styles.size(), 10U);
  for (const catalog::StyleRow& style : committed_catalog().styles) {
    const auto after = scene::reskin(before, style, committed_catalog());
    ASSERT_TRUE(after.ok()) << style.id << ": " << to_string(after.error());
    EXPECT_EQ(scene::scene_hash(*after), scene::scene_hash(before)) << style.id;
    EXPECT_EQ(after->products.size(), before.products.size()) << style.id;
    EXPECT_EQ(after->layout.look.floor, style.floor);
    EXPECT_EQ(after->layout.look.wall, style.wall);
    EXPECT_EQ(after->layout.look.light_kelvin, style.light_kelvin);
  }
  const scene::Scene changed =
      scene::reskin(before, style_named("brutalist"), committed_catalog()).value();
  EXPECT_NE(scene::look_hash(changed), scene::look_hash(before));
}

TEST(Reskin, IsWhatTheSceneWouldHaveBeenInThatLook) {
  HandLaidShop shop = shop_of(selling_types());
  const plan::Look old = shop.layout.look;
  const catalog::StyleRow& style = style_named("retro-diner");
  const scene::Scene changed = scene::reskin(scene_of(shop), style, committed_catalog()).value();
  shop.layout.look = shop.plan.look = plan::look_of(style);
  for (layout::Fixture& fixture : shop.layout.fixtures) {  // as layout gives shelving its finish
    if (fixture.kind != "gondola" && fixture.kind != "wall_unit") continue;
    if (fixture.material != old.fixture) continue;
    fixture.material = style.fixture;
    if (fixture.color == committed_catalog().material(old.fixture)->color)
      fixture.color = committed_catalog().material(style.fixture)->color;
  }
  EXPECT_EQ(scene::look_hash(changed), scene::look_hash(scene_of(shop)));
}

TEST(Reskin, AndBackAgainIsTheOldLook) {
  HandLaidShop shop = shop_of(selling_types());
  shop.layout.look = shop.plan.look = plan::look_of(style_named("modern"));
  const scene::Scene before = scene_of(shop);
  const scene::Scene there =
      scene::reskin(before, style_named("victorian"), committed_catalog()).value();
  EXPECT_EQ(
      scene::look_hash(scene::reskin(there, style_named("modern"), committed_catalog()).value()),
      scene::look_hash(before));
}

TEST(Reskin, ACabinetKeepsItsOwnFinish) {
  HandLaidShop shop = shop_of(selling_types());
  layout::Fixture& first = shop.layout.fixtures.front();
  first.material = "wood-oak";  // not the look's: somebody wished for it
  first.color = "#c69c6d";
  const scene::Scene after =
      scene::reskin(scene_of(shop), style_named("victorian"), committed_catalog()).value();
  EXPECT_EQ(after.layout.fixtures.front().material, "wood-oak");
}

TEST(Reskin, RefusesASceneWhoseFixturesAreOthers) {
  scene::Scene scene = scene_of(shop_of(selling_types()));
  scene.parts.front().half_size_m[0] += 0.1F;
  const auto after = scene::reskin(scene, style_named("modern"), committed_catalog());
  ASSERT_FALSE(after.ok());
  EXPECT_EQ(after.error().code, "scene.wrong_version");
}

TEST(StyleCalled, NamesTheNearestStyle) {
  const auto found = plan::style_called(committed_catalog(), "victorain", "--skin");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("\"victorian\""), std::string::npos);
}

}  // namespace
}  // namespace marketgen
