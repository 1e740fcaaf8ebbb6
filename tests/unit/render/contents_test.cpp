// Every pack that shows what it holds, drawn and compared with its row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assets/print/color.h"
#include "base/parallel.h"
#include "render/contact_sheet.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr int side_px = 72;

Vec3f linear_of(const std::string& hex) {
  return assets::linear_from_hex(hex).value();
}
float sum_of(Vec3f c) {
  return c.x + c.y + c.z;
}

// Whether what is seen can be `color`: dark where it is nearly black, for there gloss has all of
// the tint; otherwise of its tint, which does not depend on how much light falls, within what
// lamps, gloss and the camera's curve change.
bool is_seen_as(Vec3f seen, Vec3f color) {
  constexpr float dark = 0.25F, tolerance = 0.1F;
  if (sum_of(color) < dark) return sum_of(seen) < 3 * dark;
  const Vec3f off = seen / std::max(sum_of(seen), 1e-4F) - color / sum_of(color);
  return std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) < tolerance;
}

double share_seen_as(const Image& picture, Vec3f color) {
  int found = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = picture.at(x, y);
      const Vec3f seen{assets::linear_from_srgb(p[0]),
                       assets::linear_from_srgb(p[1]),
                       assets::linear_from_srgb(p[2])};
      if (is_seen_as(seen, color)) ++found;
    }
  }
  return static_cast<double>(found) / (picture.width * picture.height);
}

TEST(Contents, PicturesOfAllPacksShowTheirRowsColour) {
  std::vector<catalog::Product> rows;
  for (const catalog::Product& row : committed_catalog().products) {
    const bool hidden = row.archetype == "crate" || row.archetype == "bottle_six_pack";
    if (row.contents && row.contents->opacity == catalog::Opacity::opaque && !hidden)
      rows.push_back(row);
  }
  ASSERT_GE(rows.size(), 250U);
  const std::vector<double> shares = parallel_map(rows.size(), [&](std::size_t i) {
    const catalog::Contents& contents = *rows[i].contents;
    const Vec3f color =
        linear_of(contents.particle_mm > 0 ? contents.particle_color : contents.color);
    const Result<Image> picture = render::draw_product(rows[i], side_px);
    return picture.ok() ? share_seen_as(*picture, color) : -1.0;
  });
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_GT(shares[i], 0.01) << rows[i].sku << " " << rows[i].contents->color;
}

}  // namespace
}  // namespace marketgen
