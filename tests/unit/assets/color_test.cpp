// Colours as written in rows become linear light by the sRGB standard.
#include "assets/print/color.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

TEST(Color, KnownValuesOfTheStandard) {  // IEC 61966-2-1, values from its published tables
  EXPECT_EQ(assets::linear_from_srgb(0), 0.0F);
  EXPECT_EQ(assets::linear_from_srgb(255), 1.0F);
  EXPECT_NEAR(
      assets::linear_from_srgb(10), 0.0030352698, 1e-9);  // the linear part: 10 / 255 / 12.92
  EXPECT_NEAR(assets::linear_from_srgb(128), 0.2158605, 1e-7);
  EXPECT_NEAR(assets::linear_from_srgb(188), 0.5028865, 1e-7);
}

TEST(Color, ReadsHexInEitherCase) {
  const auto color = assets::linear_from_hex("#FF80bc");
  ASSERT_TRUE(color.ok());
  EXPECT_EQ(color->x, 1.0F);
  EXPECT_NEAR(color->y, 0.2158605, 1e-7);
  EXPECT_NEAR(color->z, 0.5028865, 1e-7);
}

TEST(Color, AnythingElseIsAnErrorThatShowsTheForm) {
  for (const char* text :
       {"", "#fff", "2e7d32", "#2e7d3", "#2e7d322", "#2e7d3g", "green", "# e7d32"}) {
    const auto color = assets::linear_from_hex(text);
    ASSERT_FALSE(color.ok()) << text;
    EXPECT_EQ(color.error().code, "assets.bad_row");
    EXPECT_NE(color.error().message.find("#2e7d32"), std::string::npos);
  }
}

}  // namespace
}  // namespace marketgen
