// Copies of one product differ a little, always in the same way; wear shows where hands and dust
// get.
#include "render/stage/item_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace marketgen::render::raytrace {
namespace {

float hue_of(Vec3f tint) {
  return std::atan2(tint.x - tint.z, tint.y - tint.x);
}

TEST(ItemLook, MostCopiesAreAsNewAndAllAreNearTheirPrint) {
  int as_new = 0, worn = 0;
  Vec3f sum;
  constexpr int count = 20'000;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ItemLook look = look_of_item(i, i / 20, ItemKind::packed);
    as_new += look.wear == 0 ? 1 : 0;
    worn += look.wear > 0.5F ? 1 : 0;
    EXPECT_LE(look.wear, 1);
    for (const float channel : {look.tint.x, look.tint.y, look.tint.z})
      EXPECT_NEAR(channel, 1, 0.115F);
    sum += look.tint;
  }
  EXPECT_NEAR(as_new, 0.5 * count, 0.02 * count);
  EXPECT_GT(worn, 0.03 * count);
  EXPECT_LT(worn, 0.2 * count);
  for (const float channel : {sum.x, sum.y, sum.z})
    EXPECT_NEAR(channel / count, 1, 2e-3F);
}

TEST(ItemLook, PacksComeInBatchesAndFruitOneByOne) {
  std::set<long> batches, fruits;
  for (std::uint32_t i = 0; i < 100; ++i) {
    batches.insert(std::lround(hue_of(look_of_item(i, 4, ItemKind::packed).tint) * 100));
    const ItemLook fruit = look_of_item(i, 4, ItemKind::grown);
    EXPECT_EQ(fruit.wear, 0);
    fruits.insert(std::lround(hue_of(fruit.tint) * 100));
    EXPECT_EQ(look_of_item(i, 4, ItemKind::packed).tint, look_of_item(i, 4, ItemKind::packed).tint);
  }
  EXPECT_LE(batches.size(), 3U + 2U);  // rounding may part one
  EXPECT_GE(batches.size(), 2U);
  EXPECT_GT(fruits.size(), 50U);
}

TEST(ItemLook, WearScuffsFoldsAndDustsTopsAndLeavesPrintReadable) {
  const auto worn = [](float flatness, float up, Vec3f ink, float& roughness) {
    wear_off<float>({1, flatness, 1, up}, ink, roughness);
    return ink;
  };
  const Vec3f dark{0.03F, 0.03F, 0.1F}, white{0.9F, 0.9F, 0.9F};
  float face = 0.3F, fold = 0.3F, top = 0.3F;
  const Vec3f on_face = worn(1, 0, dark, face), on_fold = worn(0.7F, 0, dark, fold),
              on_top = worn(1, 1, dark, top);
  EXPECT_GT(luminance(on_fold), 0.5F);
  EXPECT_GT(luminance(on_top), 3 * luminance(dark));
  EXPECT_NEAR(luminance(on_face), luminance(dark), 1e-5F);
  EXPECT_LT(on_face.z - on_face.x, dark.z - dark.x);  // faded
  EXPECT_GT(face, 0.3F);
  EXPECT_GT(fold, face);
  EXPECT_GT(top, face);
  float roughness = 0.3F;
  EXPECT_NEAR(luminance(worn(1, 0, white, roughness)) / luminance(on_face),
              luminance(white) / luminance(dark),
              0.01F);
}

TEST(ItemLook, TrianglesOfAQuadAreKnockedAlikeAndEightAsEachAlone) {
  EXPECT_EQ(knock_of(77U, 12U), knock_of(77U, 13U));
  EXPECT_NE(knock_of(77U, 12U), knock_of(77U, 14U));
  Int8 ids, primitives;
  for (std::size_t k = 0; k < lane_count; ++k) {
    ids.set(k, static_cast<std::int32_t>(k * 1001));
    primitives.set(k, static_cast<std::int32_t>(k * 7));
  }
  const Float8 knocks = knock_of(ids, primitives);
  for (std::uint32_t k = 0; k < lane_count; ++k)
    EXPECT_EQ(knocks[k], knock_of(k * 1001, k * 7));
}

}  // namespace
}  // namespace marketgen::render::raytrace
