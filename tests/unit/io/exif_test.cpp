#include "io/exif.h"

#include <gtest/gtest.h>

#include "io/jpeg.h"
#include "support/exif_bytes.h"

namespace marketgen::io {
namespace {

std::string jpeg() {
  return encode_jpeg(Image(16, 8)).value();
}

TEST(Exif, SaysHowTheCameraWasHeldInBothByteOrders) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    EXPECT_EQ(jpeg_orientation(with_orientation(jpeg(), orientation, true)), orientation);
    EXPECT_EQ(jpeg_orientation(with_orientation(jpeg(), orientation, false)), orientation);
  }
}

TEST(Exif, NothingAndNonsenseIsAsItIs) {
  EXPECT_EQ(jpeg_orientation(jpeg()), 1);
  EXPECT_EQ(jpeg_orientation(""), 1);
  EXPECT_EQ(jpeg_orientation("\xff\xd8\xff"), 1);
  EXPECT_EQ(jpeg_orientation(with_orientation(jpeg(), 0, true)), 1);
  EXPECT_EQ(jpeg_orientation(with_orientation(jpeg(), 9, false)), 1);
}

// Cut anywhere, and with any one byte of the segment changed, it is some orientation.
TEST(Exif, DamagedSegmentsAreHarmless) {
  const std::string good = with_orientation(jpeg(), 6, true);
  for (std::size_t size = 0; size < 80; ++size) {
    const int cut = jpeg_orientation(good.substr(0, size));
    EXPECT_TRUE(cut == 1 || cut == 6) << size;
  }
  for (std::size_t at = 0; at < 80; ++at) {
    for (const char other : {'\0', '\x7f', '\xff'}) {
      std::string changed = good;
      changed[at] = other;
      const int orientation = jpeg_orientation(changed);
      EXPECT_GE(orientation, 1);
      EXPECT_LE(orientation, 8);
    }
  }
}

}  // namespace
}  // namespace marketgen::io
