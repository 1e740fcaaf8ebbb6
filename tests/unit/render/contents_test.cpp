// Every pack that shows what it holds, drawn and compared with its row.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/print/color.h"
#include "base/parallel.h"
#include "render/contact_sheet.h"
#include "render/tone.h"
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

// What the film curve took for this byte.
float light_of(std::uint8_t byte) {
  static const std::array<float, 256> lights = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      float low = 0, high = 12;
      for (int step = 0; step < 30; ++step) {
        const float middle = (low + high) / 2;
        (render::raytrace::film_curve(middle) * 255 < static_cast<float>(i) ? low : high) = middle;
      }
      made[i] = high;
    }
    return made;
  }();
  return lights[byte];
}

// Whether what is seen can be `color`: dark where it is nearly black, for there gloss has all of
// the tint; otherwise of its tint, which does not depend on how much light falls, within what
// lamps and gloss change. Of what the curve makes of it, too: where gloss is the paler, the curve
// has the deeper colour.
bool is_seen_as(Vec3f seen, Vec3f color) {
  constexpr float dark = 0.25F, tolerance = 0.12F;
  if (sum_of(color) < dark) return sum_of(seen) < 5 * dark;  // white paper: 2.3
  const Vec3f off = seen / std::max(sum_of(seen), 1e-4F) - color / sum_of(color);
  return std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) < tolerance;
}

double share_seen_as(const Image& picture, Vec3f color) {
  int found = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = picture.at(x, y);
      const Vec3f light{light_of(p[0]), light_of(p[1]), light_of(p[2])};
      const Vec3f screen{assets::linear_from_srgb(p[0]),
                         assets::linear_from_srgb(p[1]),
                         assets::linear_from_srgb(p[2])};
      if (is_seen_as(light, color) || is_seen_as(screen, color)) ++found;
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
    const Result<Image> picture = render::draw_product(rows[i], side_px);
    if (!picture.ok()) return -1.0;
    const double ground = share_seen_as(*picture, linear_of(contents.color));
    if (contents.particle_mm <= 0) return ground;
    return std::max(ground, share_seen_as(*picture, linear_of(contents.particle_color)));
  });
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_GT(shares[i], 0.01) << rows[i].sku << " " << rows[i].contents->color;
}

}  // namespace
}  // namespace marketgen
