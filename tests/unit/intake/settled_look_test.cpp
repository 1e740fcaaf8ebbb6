// Two readers of the same photos: whose value holds.
#include "intake/settled_look.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace marketgen::intake {
namespace {

using photo::AttributeReading;

std::vector<photo::PhotoReading> photo_with(std::vector<AttributeReading> attributes) {
  photo::PhotoReading photo;
  photo.file = "a.jpg";
  photo.attributes = std::move(attributes);
  return {photo};
}

const AttributeReading& reading_in(const SettledLook& look, std::string_view attribute) {
  const auto found = std::ranges::find(look.readings, attribute, &AttributeReading::attribute);
  if (found == look.readings.end()) fatal("no such reading");
  return *found;
}

TEST(SettledLook, WithoutAModelIsTheBanks) {
  const auto look = settled_look(photo_with({{"lamps", "panel", 0.9, ""}}), {});
  ASSERT_EQ(look.readings.size(), 1U);
  EXPECT_EQ(look.source_of("lamps"), plan::Source::photo);
  EXPECT_TRUE(look.disagreements.empty());
}

TEST(SettledLook, TheModelSaysWhatTheBankIsNotSureOf) {
  const auto look =
      settled_look(photo_with({{"lamps", "panel", 0.3, ""}}),
                   photo_with({{"lamps", "line", 0.7, ""}, {"levels", "5", 0.6, ""}}));
  EXPECT_EQ(reading_in(look, "lamps").value, "line");
  EXPECT_EQ(look.source_of("lamps"), plan::Source::llm);
  EXPECT_EQ(reading_in(look, "levels").value, "5");  // which the bank never read
  EXPECT_TRUE(look.disagreements.empty());
}

TEST(SettledLook, AModelThatIsNotSureSaysNothing) {
  const auto look = settled_look(photo_with({{"lamps", "panel", 0.3, ""}}),
                                 photo_with({{"lamps", "line", 0.49, ""}}));
  EXPECT_EQ(reading_in(look, "lamps").value, "panel");
  EXPECT_EQ(look.source_of("lamps"), plan::Source::photo);
}

TEST(SettledLook, WhereBothAreSureTheBankHoldsAndTheLossIsNamed) {
  const auto look = settled_look(photo_with({{"lamps", "panel", 0.6, ""}}),
                                 photo_with({{"lamps", "line", 0.95, ""}}));
  EXPECT_EQ(reading_in(look, "lamps").value, "panel");
  EXPECT_EQ(look.source_of("lamps"), plan::Source::photo);
  ASSERT_EQ(look.disagreements.size(), 1U);
  EXPECT_EQ(look.disagreements[0],
            "lamps: panel (0.60) by the bank of renderings, which holds; line (0.95) by the "
            "language model");
}

TEST(SettledLook, WhereBothAreSureOfTheSameNothingIsNamed) {
  const auto look = settled_look(photo_with({{"lamps", "panel", 0.6, ""}}),
                                 photo_with({{"lamps", "panel", 0.95, ""}}));
  EXPECT_EQ(look.source_of("lamps"), plan::Source::photo);
  EXPECT_TRUE(look.disagreements.empty());
}

// The bank knows that it is beige and would guess marble; the model knows that it is wood.
const std::vector<photo::PhotoReading> beige_floor = photo_with(
    {{"floor", "stone", 0.3, "marble-pink"}, {"floor_color", "beige", 0.8, "marble-pink"}});

TEST(SettledLook, ASurfaceIsTheModelsMaterialWhereItHasTheBanksColour) {
  const auto look = settled_look(beige_floor,
                                 photo_with({{"floor", "wood", 0.7, "wood-pine"},
                                             {"floor_color", "beige", 0.4, "wood-pine"}}));
  const AttributeReading* surface = photo::surface_of(look.readings, "floor");
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->material, "wood-pine");
  EXPECT_DOUBLE_EQ(surface->confidence, 0.7);
  EXPECT_EQ(look.source_of(surface->attribute), plan::Source::llm);
}

TEST(SettledLook, ASurfaceOfAnotherColourThanTheBanksIsNotTheModels) {
  const auto look = settled_look(
      beige_floor,
      photo_with({{"floor", "wood", 0.7, "wood-dark"}, {"floor_color", "dark", 0.4, "wood-dark"}}));
  const AttributeReading* surface = photo::surface_of(look.readings, "floor");
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->material, "marble-pink");
  EXPECT_EQ(look.source_of("floor"), plan::Source::photo);
  EXPECT_EQ(look.source_of("floor_color"), plan::Source::photo);
  ASSERT_EQ(look.disagreements.size(), 1U);
  EXPECT_TRUE(
      look.disagreements[0].starts_with("floor: wood (0.70) by the language model is left"));
}

TEST(SettledLook, AColourOfAnotherSurfaceThanTheBanksIsNotTheModels) {
  const auto look = settled_look(
      photo_with({{"floor", "stone", 0.9, "marble-pink"}, {"floor_color", "beige", 0.2, ""}}),
      photo_with({{"floor", "wood", 0.2, "wood-dark"}, {"floor_color", "dark", 0.9, "wood-dark"}}));
  EXPECT_EQ(photo::surface_of(look.readings, "floor")->material, "marble-pink");
  EXPECT_TRUE(look.by_model.empty());
  EXPECT_EQ(look.disagreements.size(), 1U);
}

TEST(SettledLook, ASurfaceThatOnlyTheModelIsSureOfIsItsOwn) {
  const auto look = settled_look(
      photo_with({{"floor", "stone", 0.2, "marble-pink"}, {"floor_color", "beige", 0.2, ""}}),
      photo_with({{"floor", "wood", 0.8, "wood-dark"}, {"floor_color", "dark", 0.9, "wood-dark"}}));
  EXPECT_EQ(photo::surface_of(look.readings, "floor")->material, "wood-dark");
  EXPECT_TRUE(look.disagreements.empty());
}

}  // namespace
}  // namespace marketgen::intake
