// Posters: every row can be drawn, and looks like something.
#include "assets/print/poster.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace marketgen {
namespace {

TEST(Posters, EveryRowIsDrawnInEveryDesign) {
  for (const assets::Poster& poster : assets::posters()) {
    for (unsigned design = 0; design < 3; ++design) {
      const Result<Image> picture = assets::draw_poster(poster, "#2e7d32", design, 128);
      ASSERT_TRUE(picture.ok()) << poster.headline << ": " << picture.error().message;
      EXPECT_EQ(picture->height, 128);
      EXPECT_EQ(picture->width, 91);
      const auto [darkest, brightest] =
          std::minmax_element(picture->pixels.begin(), picture->pixels.end());
      EXPECT_GT(*brightest - *darkest, 100) << poster.headline;
    }
  }
}

TEST(Posters, ZonesHaveTheirOwnOrThoseOfAnyZone) {
  for (const assets::Poster* poster : assets::posters_for("bakery"))
    EXPECT_EQ(poster->zone_type, "bakery");
  ASSERT_FALSE(assets::posters_for("backroom").empty());
  EXPECT_TRUE(assets::posters_for("backroom").front()->zone_type.empty());
}

TEST(Posters, ABadColourOrSizeIsAnError) {
  EXPECT_FALSE(assets::draw_poster(assets::posters().front(), "green", 0, 128).ok());
  EXPECT_FALSE(assets::draw_poster(assets::posters().front(), "#2e7d32", 0, 10).ok());
}

}  // namespace
}  // namespace marketgen
