#include "layout/layout_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sample_shop.h"

namespace marketgen {
namespace {

layout::Layout small_layout(const catalog::Catalog& catalog) {
  return layout::make_layout(sample::small_shop(), catalog, Seed(1)).value();
}

int colors_in(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    colors.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
  }
  return static_cast<int>(colors.size());
}

TEST(LayoutPicture, TheLongerSideHasTheWantedSize) {
  const catalog::Catalog catalog = sample::catalog();
  const Image image = layout::draw_layout(small_layout(catalog), catalog, 900);
  EXPECT_EQ(std::max(image.width, image.height), 900);
  EXPECT_GT(colors_in(image), 50);
}

TEST(LayoutPicture, IsTheSameEveryTime) {
  const catalog::Catalog catalog = sample::catalog();
  const layout::Layout layout = small_layout(catalog);
  EXPECT_EQ(layout::draw_layout(layout, catalog, 600).pixels,
            layout::draw_layout(layout, catalog, 600).pixels);
}

TEST(LayoutPicture, MarksBrokenRulesInRed) {
  const catalog::Catalog catalog = sample::catalog();
  layout::Layout layout = small_layout(catalog);
  const Image sound = layout::draw_layout(layout, catalog, 800);
  layout.violations.push_back({"AISLE_TOO_NARROW",
                               layout::Severity::hard,
                               layout.aisles.front().id,
                               700,
                               1000,
                               "narrow",
                               {}});
  const Image broken = layout::draw_layout(layout, catalog, 800);
  const auto red = [](const Image& image) {  // the alarm's #c1121f
    int count = 0;
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
      const bool alarm =
          image.pixels[i] > 180 && image.pixels[i + 1] < 40 && image.pixels[i + 2] < 50;
      count += alarm ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(red(sound), 0);
  EXPECT_GT(red(broken), 100);
}

}  // namespace
}  // namespace marketgen
