// What photos of a shop give its plan: readings made by hand, no pictures.
#include "intake/photo_wishes.h"

#include "intake/offline_planner.h"
#include "intake/photos_file.h"
#include "intake_fixture.h"
#include "io/json.h"

namespace marketgen {
namespace {

constexpr double fairly_sure = 0.8, not_sure = 0.3;

photo::AttributeReading reading_of(const std::string& attribute,
                                   const std::string& value,
                                   double confidence = fairly_sure,
                                   const std::string& material = "") {
  return {attribute, value, confidence, material};
}

photo::PhotoReading photo_of(const std::string& file,
                             std::vector<photo::AttributeReading> attributes) {
  photo::PhotoReading photo;
  photo.file = file;
  photo.subject_confidence = 1;
  photo.attributes = std::move(attributes);
  return photo;
}

intake::Brief brief_with(const std::string& prompt, std::vector<photo::PhotoReading> photos) {
  intake::Brief brief;
  brief.prompt = prompt;
  for (const photo::PhotoReading& photo : photos)
    brief.image_files.push_back(photo.file);
  brief.photos = std::move(photos);
  return brief;
}

intake::Planned photographed_plan(const intake::Brief& brief) {
  auto result = intake::plan_from_brief(brief, committed_catalog(), shipped_planner(), Seed(1));
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

// One photo, called "a.jpg".
intake::Planned photographed_plan(const std::string& prompt,
                                  std::vector<photo::AttributeReading> readings) {
  return photographed_plan(brief_with(prompt, {photo_of("a.jpg", std::move(readings))}));
}

const plan::Provenance* provenance_at(const plan::Plan& plan, const std::string& path) {
  const auto entry = std::ranges::find(plan.provenance, path, &plan::Provenance::path);
  return entry == plan.provenance.end() ? nullptr : &*entry;
}

const intake::Conflict* conflict_about(const intake::Planned& planned, const std::string& what) {
  const auto conflict = std::ranges::find(planned.conflicts, what, &intake::Conflict::what);
  return conflict == planned.conflicts.end() ? nullptr : &*conflict;
}

bool is_of_gondolas(const plan::Zone& zone) {
  return zone.fixture.kind == "gondola";
}

std::vector<plan::RunAxis> axes_of(const plan::Plan& plan) {
  std::vector<plan::RunAxis> axes;
  for (const plan::Zone& zone : plan.zones)
    if (is_of_gondolas(zone)) axes.push_back(zone.fixture.axis);
  return axes;
}

const std::vector<photo::AttributeReading> brown_floor{
    reading_of("floor", "wood", fairly_sure, "wood-walnut"), reading_of("floor_color", "brown")};

TEST(PhotoWishes, SureMaterialsLampsAndLightBecomeTheLook) {
  auto readings = brown_floor;
  readings.push_back(reading_of("lamps", "pendant", 0.9));
  readings.push_back(reading_of("light", "warm", 0.6));
  const auto planned = photographed_plan("a supermarket", readings);
  EXPECT_EQ(planned.plan.look.floor, "wood-walnut");
  EXPECT_EQ(planned.plan.look.lamps, catalog::LampFitting::pendant);
  EXPECT_EQ(planned.plan.look.light_kelvin, 3000);
  EXPECT_TRUE(planned.conflicts.empty());
}

TEST(PhotoWishes, AreInTheProvenanceWithTheirConfidence) {
  const auto planned = photographed_plan("a supermarket", {reading_of("lamps", "line", 0.9)});
  const plan::Provenance* lamps = provenance_at(planned.plan, "/look/lamps");
  ASSERT_NE(lamps, nullptr);
  EXPECT_EQ(lamps->source, plan::Source::photo);
  EXPECT_DOUBLE_EQ(lamps->confidence, 0.9);
  EXPECT_EQ(provenance_at(planned.plan, "/look/light_kelvin"), nullptr);
}

TEST(PhotoWishes, AreNoWishesOfThePrompt) {
  const auto alone = photographed_plan("a supermarket", {});
  const auto planned = photographed_plan("a supermarket", brown_floor);
  EXPECT_EQ(planned.requirements.size(), alone.requirements.size());
}

TEST(PhotoWishes, WhatIsNotSureIsNotUsed) {
  const auto planned = photographed_plan("a supermarket",
                                         {reading_of("lamps", "pendant", not_sure),
                                          reading_of("levels", "4", not_sure),
                                          reading_of("shop", "discounter", not_sure)});
  EXPECT_NE(planned.plan.look.lamps, catalog::LampFitting::pendant);
  EXPECT_EQ(planned.plan.profile, "supermarket-eu");
  for (const plan::Provenance& entry : planned.plan.provenance)
    EXPECT_NE(entry.source, plan::Source::photo) << entry.path;
}

TEST(PhotoWishes, WordsWinAndTheLossIsAConflict) {
  const auto planned = photographed_plan("a supermarket with a floor of grey tiles", brown_floor);
  EXPECT_EQ(planned.plan.look.floor, "tile-grey");
  const intake::Conflict* conflict = conflict_about(planned, "floor");
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(conflict->dropped, "a.jpg: floor wood");
  EXPECT_EQ(conflict->why, "words win over a photo");
}

TEST(PhotoWishes, WordsThatSayTheSameAreNoConflict) {
  const auto planned = photographed_plan("a supermarket with an oak floor", brown_floor);
  EXPECT_EQ(planned.plan.look.floor, "wood-oak");
  EXPECT_EQ(conflict_about(planned, "floor"), nullptr);
}

TEST(PhotoWishes, AStyleThatWasAskedForWins) {
  const auto planned =
      photographed_plan("an industrial supermarket", {reading_of("lamps", "pendant")});
  EXPECT_EQ(planned.plan.look.lamps, catalog::LampFitting::line);
  const intake::Conflict* conflict = conflict_about(planned, "lamps");
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(conflict->why, "a style that was asked for wins over a photo");
}

TEST(PhotoWishes, FlagsWin) {
  intake::Brief brief =
      brief_with("a shop", {photo_of("a.jpg", {reading_of("shop", "discounter")})});
  brief.profile = "supermarket-us";
  brief.skin = "industrial";
  brief.photos[0].attributes.push_back(reading_of("light", "cool"));
  const auto planned = photographed_plan(brief);
  EXPECT_EQ(planned.plan.profile, "supermarket-us");
  ASSERT_NE(conflict_about(planned, "shop"), nullptr);
  EXPECT_EQ(conflict_about(planned, "shop")->kept, "--profile supermarket-us");
  ASSERT_NE(conflict_about(planned, "light"), nullptr);
  EXPECT_EQ(conflict_about(planned, "light")->why, "a flag wins over a photo");
}

TEST(PhotoWishes, TheKindOfShopGivesTheProfile) {
  const auto planned =
      photographed_plan("a shop with a bakery", {reading_of("shop", "discounter")});
  EXPECT_EQ(planned.plan.profile, "discounter");
  EXPECT_EQ(provenance_at(planned.plan, "/profile")->source, plan::Source::photo);
  const auto worded =
      photographed_plan("an organic supermarket", {reading_of("shop", "discounter")});
  EXPECT_NE(worded.plan.profile, "discounter");
}

TEST(PhotoWishes, LevelsAreThoseOfAllGondolasThatWordsLeaveOpen) {
  const auto planned =
      photographed_plan("a supermarket. Household gets four levels.", {reading_of("levels", "6")});
  int others = 0;
  for (const plan::Zone& zone : planned.plan.zones) {
    if (!is_of_gondolas(zone)) continue;
    EXPECT_EQ(zone.fixture.levels, zone.type == "household" ? 4 : 6) << zone.id;
    others += zone.type == "household" ? 0 : 1;
  }
  EXPECT_GT(others, 0);
}

TEST(PhotoWishes, AislesAreAsWideAsThePhotoHasThem) {
  const auto narrow = photographed_plan("a supermarket", {reading_of("aisle", "narrow")});
  const auto wide = photographed_plan("a supermarket", {reading_of("aisle", "wide")});
  const auto worded =
      photographed_plan("a supermarket with aisles 1.5 m wide", {reading_of("aisle", "wide")});
  const auto aisle_of = [](const intake::Planned& planned) {
    const auto& zones = planned.plan.zones;
    const auto zone = std::ranges::find_if(zones, is_of_gondolas);
    return zone == zones.end() ? 0 : zone->fixture.aisle_mm.value_or(0);
  };
  EXPECT_EQ(aisle_of(narrow), 1300);
  EXPECT_EQ(aisle_of(wide), 2500);
  EXPECT_EQ(aisle_of(worded), 1500);
  EXPECT_NE(conflict_about(worded, "aisle"), nullptr);
}

TEST(PhotoWishes, NoAisleIsNarrowerThanTheShopMayHaveIt) {
  intake::Brief brief = brief_with("a shop", {photo_of("a.jpg", {reading_of("aisle", "narrow")})});
  brief.profile = "hypermarket-eu";
  const catalog::ProfileRow* profile = committed_catalog().profile("hypermarket-eu");
  ASSERT_NE(profile, nullptr);
  for (const plan::Zone& zone : photographed_plan(brief).plan.zones) {
    if (!is_of_gondolas(zone)) continue;
    EXPECT_GE(*zone.fixture.aisle_mm, profile->minimum_aisle_mm) << zone.id;
  }
}

TEST(PhotoWishes, RunsAcrossTheRoomTurn) {
  const auto away =
      axes_of(photographed_plan("a supermarket", {reading_of("direction", "away")}).plan);
  const auto across =
      axes_of(photographed_plan("a supermarket", {reading_of("direction", "across")}).plan);
  ASSERT_FALSE(away.empty());
  EXPECT_EQ(std::ranges::count(away, plan::RunAxis::x), 0);
  EXPECT_GE(2 * std::ranges::count(across, plan::RunAxis::x),
            static_cast<std::ptrdiff_t>(across.size()));
}

TEST(PhotoWishes, AcrossIsAlongTheFrontWallWhereverThatIs) {
  const auto across = axes_of(photographed_plan("a supermarket with the entrance in the east wall",
                                                {reading_of("direction", "across")})
                                  .plan);
  EXPECT_GT(std::ranges::count(across, plan::RunAxis::y), 0);
}

TEST(PhotoWishes, OfSeveralPhotosTheSurerOnesDecide) {
  const auto planned = photographed_plan(brief_with(
      "an industrial shop",
      {photo_of("a.jpg", {reading_of("lamps", "pendant", 0.6), reading_of("levels", "4", 0.9)}),
       photo_of("b.jpg", {reading_of("lamps", "pendant", 0.8)})}));
  ASSERT_NE(conflict_about(planned, "lamps"), nullptr);
  EXPECT_EQ(conflict_about(planned, "lamps")->dropped, "b.jpg: lamps pendant");
  EXPECT_TRUE(std::ranges::any_of(planned.plan.zones, [](const plan::Zone& zone) {
    return is_of_gondolas(zone) && zone.fixture.levels == 4;
  }));
}

TEST(PhotoWishes, APhotoAloneIsEnough) {
  EXPECT_TRUE(photographed_plan("", brown_floor).understood);
  EXPECT_FALSE(photographed_plan("", {reading_of("levels", "4", not_sure)}).understood);
}

TEST(PhotoWishes, WhatWasReadIsAFileOfTheStore) {
  const auto planned = photographed_plan("a supermarket", brown_floor);
  ASSERT_EQ(planned.files.size(), 1U);
  EXPECT_EQ(planned.files[0].path, "photos.json");
  const auto file = io::read_json<intake::PhotosFile>(planned.files[0].bytes, "photos.json");
  ASSERT_TRUE(file.ok());
  ASSERT_EQ(file->photos.size(), 1U);
  EXPECT_EQ(file->photos[0].find("floor")->value, "wood");
}

// What a language model read of photos that the bank is not sure of.
intake::Brief brief_seen(const std::string& prompt, std::vector<photo::AttributeReading> seen) {
  intake::Brief brief =
      brief_with(prompt, {photo_of("a.jpg", {reading_of("lamps", "panel", not_sure)})});
  brief.seen = {photo_of("a.jpg", std::move(seen))};
  return brief;
}

TEST(PhotoWishes, WhatAModelReadHasItsNameInTheProvenance) {
  const auto planned = photographed_plan(brief_seen(
      "a supermarket", {reading_of("lamps", "pendant", 0.7), reading_of("levels", "4")}));
  EXPECT_EQ(planned.plan.look.lamps, catalog::LampFitting::pendant);
  const plan::Provenance* lamps = provenance_at(planned.plan, "/look/lamps");
  ASSERT_NE(lamps, nullptr);
  EXPECT_EQ(lamps->source, plan::Source::llm);
  EXPECT_DOUBLE_EQ(lamps->confidence, 0.7);
}

TEST(PhotoWishes, FlagsWordsAndStylesWinOverAModelAsOverTheBank) {
  const auto styled =
      photographed_plan(brief_seen("an industrial supermarket", {reading_of("lamps", "pendant")}));
  EXPECT_EQ(styled.plan.look.lamps, catalog::LampFitting::line);
  ASSERT_NE(conflict_about(styled, "lamps"), nullptr);
  EXPECT_EQ(conflict_about(styled, "lamps")->dropped, "a.jpg: lamps pendant");
  intake::Brief flagged = brief_seen("a shop", {reading_of("shop", "organic-eu")});
  EXPECT_EQ(photographed_plan(flagged).plan.profile, "organic-eu");
  flagged.profile = "supermarket-us";
  EXPECT_EQ(photographed_plan(flagged).plan.profile, "supermarket-us");
}

TEST(PhotoWishes, ALineSaysWhatWasRead) {
  const auto photo = photo_of("a.jpg",
                              {reading_of("floor", "wood", 0.83),
                               reading_of("wall", "brick", 0.2),
                               reading_of("lamps", "panel", 0.9),
                               reading_of("levels", "5", 0.49)});
  EXPECT_EQ(intake::words_of(photo), "floor wood 0.83, lamps panel 0.90 (not sure: wall, levels)");
  EXPECT_EQ(intake::not_sure_of(photo), "wall, levels");
}

}  // namespace
}  // namespace marketgen
