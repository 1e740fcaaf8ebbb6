#include "drawing/picture.h"

#include <gtest/gtest.h>

#include <array>

#include "drawing/shrunk_png.h"
#include "io/jpeg.h"
#include "io/picture_file.h"
#include "io/png.h"
#include "support/exif_bytes.h"

namespace marketgen::drawing {
namespace {

constexpr int width = 64, height = 48;

// Red, green, blue and white quarters, from the top left.
Image quarters() {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool right = x >= width / 2, low = y >= height / 2;
      image.at(x, y)[0] = right == low ? 220 : 0;
      image.at(x, y)[1] = right ? 220 : 0;
      image.at(x, y)[2] = low ? 220 : 0;
    }
  }
  return image;
}

// Letters of the four corners, row by row.
std::string corners_of(const Image& image) {
  std::string letters;
  for (const int y : {3, image.height - 4}) {
    for (const int x : {3, image.width - 4}) {
      const std::uint8_t* p = image.at(x, y);
      letters += p[0] > 110 ? (p[1] > 110 ? 'W' : 'R') : p[1] > 110 ? 'G' : 'B';
    }
  }
  return letters;
}

// What each orientation means is Pillow's exif_transpose's word for it.
TEST(Picture, APhotoStandsAsTheCameraWasHeld) {
  const std::array<std::string, 8> seen = {
      "RGBW", "GRWB", "WBGR", "BWRG", "RBGW", "BRWG", "WGBR", "GWRB"};
  const std::string jpeg = io::encode_jpeg(quarters()).value();
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const auto image = io::decoded_picture(with_orientation(jpeg, orientation, true), "photo");
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    EXPECT_EQ(corners_of(image.value()), seen[orientation - 1]) << orientation;
    EXPECT_EQ(image->width, orientation >= 5 ? height : width);
  }
}

TEST(Picture, OthersStandAsTheyAre) {
  EXPECT_EQ(corners_of(io::decoded_picture(io::encode_jpeg(quarters()).value(), "a").value()),
            "RGBW");
  EXPECT_EQ(corners_of(io::decoded_picture(io::encode_png(quarters()).value(), "b").value()),
            "RGBW");
  EXPECT_EQ(io::decoded_picture("", "c").error().code, "image.bad_file");
}

TEST(Picture, ShrunkItStandsUprightAndHasNothingElseOfItsFile) {
  const std::string jpeg = with_orientation(io::encode_jpeg(quarters()).value(), 6, true);
  const auto png = shrunk_png(jpeg, "photo", 32);
  ASSERT_TRUE(png.ok()) << to_string(png.error());
  EXPECT_EQ(png->width, 24);
  EXPECT_EQ(png->height, 32);
  EXPECT_EQ(png->bytes.find("Exif"), std::string::npos);
  const auto image = io::decode_png(png->bytes, "shrunk");
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(corners_of(*image), "BRWG");
}

TEST(Picture, SmallOnesKeepTheirSizeAndWhatIsSeeThroughIsWhite) {
  Image image(10, 8, 4);  // all zeros
  const auto png = shrunk_png(io::encode_png(image).value(), "drawing", 1024);
  ASSERT_TRUE(png.ok());
  EXPECT_EQ(png->width, 10);
  const Image white = io::decode_png(png->bytes, "shrunk").value();
  EXPECT_EQ(white.channels, 3);
  EXPECT_EQ(white.at(5, 5)[0], 255);
  EXPECT_EQ(shrunk_png("no picture", "x", 1024).error().code, "image.bad_file");
}

}  // namespace
}  // namespace marketgen::drawing
