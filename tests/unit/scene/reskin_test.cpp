// Another look for a finished scene.
#include "scene/reskin.h"

#include <gtest/gtest.h>

#include "plan/style_look.h"
#include "scene_of.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

const StyleRow& style_named(std::string_view name) {
  return *committed_catalog().style(name);
}

TEST(Reskin, MovesNothingAndChangesTheLook) {
  const Scene before = scene_of(shop_of(selling_types()));
  ASSERT_GE(committed_catalog().styles.size(), 10U);
  for (const StyleRow& style : committed_catalog().styles) {
    const auto after = reskin(before, style, committed_catalog());
    ASSERT_TRUE(after.ok()) << style.id << ": " << to_string(after.error());
    EXPECT_EQ(scene_hash(*after), scene_hash(before)) << style.id;
    EXPECT_EQ(after->products.size(), before.products.size()) << style.id;
    EXPECT_EQ(after->layout.look.floor, style.floor);
    EXPECT_EQ(after->layout.look.wall, style.wall);
    EXPECT_EQ(after->layout.look.light_kelvin, style.light_kelvin);
  }
  const Scene changed = reskin(before, style_named("brutalist"), committed_catalog()).value();
  EXPECT_NE(look_hash(changed), look_hash(before));
}

TEST(Reskin, IsWhatTheSceneWouldHaveBeenInThatLook) {
  HandLaidShop shop = shop_of(selling_types());
  const Look old = shop.layout.look;
  const StyleRow& style = style_named("retro-diner");
  const Scene changed = reskin(scene_of(shop), style, committed_catalog()).value();
  shop.layout.look = shop.plan.look = look_of(style);
  for (Fixture& fixture : shop.layout.fixtures) {  // as layout gives shelving its finish
    if (fixture.kind != "gondola" && fixture.kind != "wall_unit") continue;
    if (fixture.material != old.fixture) continue;
    fixture.material = style.fixture;
    if (fixture.color == committed_catalog().material(old.fixture)->color)
      fixture.color = committed_catalog().material(style.fixture)->color;
  }
  EXPECT_EQ(look_hash(changed), look_hash(scene_of(shop)));
}

TEST(Reskin, AndBackAgainIsTheOldLook) {
  HandLaidShop shop = shop_of(selling_types());
  shop.layout.look = shop.plan.look = look_of(style_named("modern"));
  const Scene before = scene_of(shop);
  const Scene there = reskin(before, style_named("victorian"), committed_catalog()).value();
  EXPECT_EQ(look_hash(reskin(there, style_named("modern"), committed_catalog()).value()),
            look_hash(before));
}

TEST(Reskin, ACabinetKeepsItsOwnFinish) {
  HandLaidShop shop = shop_of(selling_types());
  Fixture& first = shop.layout.fixtures.front();
  first.material = "wood-oak";  // not the look's: somebody wished for it
  first.color = "#c69c6d";
  const Scene after = reskin(scene_of(shop), style_named("victorian"), committed_catalog()).value();
  EXPECT_EQ(after.layout.fixtures.front().material, "wood-oak");
}

TEST(Reskin, RefusesASceneWhoseFixturesAreOthers) {
  Scene scene = scene_of(shop_of(selling_types()));
  scene.parts.front().half_size_m[0] += 0.1F;
  const auto after = reskin(scene, style_named("modern"), committed_catalog());
  ASSERT_FALSE(after.ok());
  EXPECT_EQ(after.error().code, "scene.wrong_version");
}

TEST(StyleCalled, NamesTheNearestStyle) {
  const auto found = style_called(committed_catalog(), "victorain", "--skin");
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("\"victorian\""), std::string::npos);
}

}  // namespace
}  // namespace marketgen
