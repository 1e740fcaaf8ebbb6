// Compressed textures: decoded as libsquish does, close to the picture, bars as fine as one looks.
#include "render/stage/block_mips.h"

#include <gtest/gtest.h>
#include <squish.h>

#include <array>
#include <cmath>

#include "catalog/catalog.h"
#include "io/file.h"
#include "render/stage/label_library.h"
#include "render/stage/printed_bars.h"
#include "render/stage/texture.h"

namespace marketgen::render::raytrace {
namespace {

// A picture of hash noise in two colours with a ramp: every block mode occurs.
Image busy_picture(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool dark = (x * 7 + y * 13) % 5 < 2;
      image.at(x, y)[0] = static_cast<std::uint8_t>(dark ? 20 : 60 + x * 3 % 190);
      image.at(x, y)[1] = static_cast<std::uint8_t>(dark ? 30 + y % 100 : 200);
      image.at(x, y)[2] = static_cast<std::uint8_t>(x * y % 256);
    }
  }
  return image;
}

TEST(BlockMips, DecodeAsTheOutsideDecoderDoes) {
  const Image picture = busy_picture(37, 22);  // neither side a multiple of four
  const BlockMips mips = blocks_of(picture);
  ASSERT_EQ(mips.blocks().size(), BlockMips::block_count(37, 22));
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 9; ++column) {
      std::array<squish::u8, 64> texels{};
      const std::uint64_t block = mips.blocks()[static_cast<std::size_t>(row * 10 + column)];
      squish::Decompress(texels.data(), &block, squish::kDxt1);
      for (int i = 0; i < 16; ++i) {
        const float u = (static_cast<float>(column * 4 + i % 4) + 0.5F) / 37;
        const float v = (static_cast<float>(row * 4 + i / 4) + 0.5F) / 22;
        alignas(16) std::array<float, 4> mine{};
        _mm_store_ps(mine.data(), mips.sample(u, v, 0));
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(mine[c], texels[static_cast<std::size_t>(i) * 4 + c], 2.5F);
      }
    }
  }
}

TEST(BlockMips, TakeAnEighthOfPlainTexels) {
  const Image picture = busy_picture(256, 128);
  EXPECT_LE(blocks_of(picture).bytes() * 7, Texture(picture).bytes());
}

TEST(BlockMips, EvenColoursAreNearlyExact) {
  Image even(16, 16);
  for (std::size_t i = 0; i < even.pixels.size(); i += 3) {
    even.pixels[i] = 188;
    even.pixels[i + 1] = 80;
    even.pixels[i + 2] = 255;
  }
  const Vec3f color = Texture(blocks_of(even)).sample(0.3F, 0.8F, 1.5F);
  EXPECT_NEAR(color.x, 0.503F, 0.01F);  // sRGB 188 and 80 in linear light
  EXPECT_NEAR(color.y, 0.0802F, 0.01F);
  EXPECT_NEAR(color.z, 1.0F, 0.001F);
}

assets::LabelBars stripes() {  // every other module is a bar
  assets::LabelBars bars{0.25F, 0.5F, 0.75F, 0.9F, 0.1F, false, {}};
  for (int i = 0; i < 95; ++i)
    bars.modules += i % 2 == 0 ? '1' : '0';
  return bars;
}

TEST(PrintedBars, AreSharpNearAndGreyFar) {
  const PrintedBars bars(stripes(), 100, 50);
  const auto middle_of = [](int module) {
    return 0.25F + 0.5F * (static_cast<float>(module) + 0.5F) / 95;
  };
  for (const int module : {0, 1, 40, 41, 94}) {
    const float grey = bars.sample(middle_of(module), 0.6F, -6).value();
    EXPECT_NEAR(grey, module % 2 == 0 ? 0.02F : 0.9F, 1e-4F) << module;
  }
  EXPECT_NEAR(bars.sample(0.5F, 0.6F, 4).value(), 0.46F, 0.03F);
  EXPECT_FALSE(bars.sample(0.2F, 0.6F, 0).has_value());
  EXPECT_FALSE(bars.sample(0.5F, 0.95F, 0).has_value());
  EXPECT_TRUE(bars.sample(1.5F, 0.6F, 0).has_value());  // textures repeat
}

TEST(PrintedBars, OnlyGuardBarsReachTheFoot) {
  const PrintedBars bars(stripes(), 100, 50);
  const float foot = 0.5F + 0.4F * 0.95F;
  EXPECT_NEAR(bars.sample(0.25F + 0.5F * 0.5F / 95, foot, -6).value(), 0.02F, 1e-4F);
  EXPECT_NEAR(bars.sample(0.25F + 0.5F * 20.5F / 95, foot, -6).value(), 0.9F, 1e-4F);
}

TEST(PrintedBars, AnUprightTurnMakesALadder) {
  assets::LabelBars lying = stripes();
  lying.ladder = true;
  const PrintedBars bars(lying, 100, 50);
  const auto row_of = [](int module) {
    return 0.5F + 0.4F * (static_cast<float>(module) + 0.5F) / 95;
  };
  EXPECT_NEAR(bars.sample(0.5F, row_of(10), -6).value(), 0.02F, 1e-4F);
  EXPECT_NEAR(bars.sample(0.5F, row_of(11), -6).value(), 0.9F, 1e-4F);
  EXPECT_NEAR(bars.sample(0.26F, row_of(10), -6).value(), 0.9F, 1e-4F);  // the feet are at the left
}

TEST(LabelLibrary, AProductTakes125KilobytesOnAverage) {
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  double bytes = 0;
  for (const catalog::Product& product : catalog.products) {
    const assets::SheetSize size = assets::sheet_size_of(product).value();
    const double density = label_px_per_mm(size) * 1000;
    const auto side = [&](float metres) {
      return static_cast<int>(std::lround(static_cast<double>(metres) * density));
    };
    bytes +=
        8.0 * static_cast<double>(BlockMips::block_count(side(size.width_m), side(size.height_m)));
  }
  const auto products = static_cast<double>(catalog.products.size());
  EXPECT_LT(bytes, 0.125e6 * products);
  EXPECT_GT(bytes, 0.05e6 * products);  // and not blurred
}

}  // namespace
}  // namespace marketgen::render::raytrace
