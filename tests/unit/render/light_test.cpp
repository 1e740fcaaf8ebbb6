// Light with known answers: a lamp over a floor, textures, tone; path_test.cpp has furnaces.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "assets/print/color.h"
#include "render/light/light_grid.h"
#include "render/shading_math.h"
#include "render/stage/texture.h"
#include "render/tone.h"

namespace marketgen::render::raytrace {
namespace {

// Irradiance under the middle of a square lamp of side a at height h (form factor of a parallel
// rectangle to a differential element, e.g. Howell's catalogue C-11): E = L * 4 * F, F over each
// quarter.
TEST(LightGrid, LampOverAFloor) {
  World world;
  const float side = 1, height = 2, radiance = 100;
  world.lights.push_back(make_area_light(
      {-side / 2, side / 2, height}, {side, 0, 0}, {0, -side, 0}, {radiance, radiance, radiance}));
  world.room.include({-3, -3, 0});
  world.room.include({3, 3, 3});
  const LightGrid lights(world);
  double sum = 0;
  constexpr int grid = 64;
  for (int i = 0; i < grid * grid; ++i) {
    const LightSample sample = lights.sample({0, 0, 0},
                                             0.5F,
                                             (static_cast<float>(i % grid) + 0.5F) / grid,
                                             (static_cast<float>(i / grid) + 0.5F) / grid);
    sum += static_cast<double>(sample.irradiance_scale.x * sample.direction.z);
    EXPECT_NEAR(lights.pdf({0, 0, 0}, 0, sample.direction, sample.distance),
                sample.pdf,
                sample.pdf * 1e-3F);
  }
  const double x = side / 2 / height, root = std::sqrt(1 + x * x);
  const double quarter = 1 / (2 * M_PI) * 2 * (x / root) * std::atan(x / root);
  EXPECT_NEAR(sum / (grid * grid), M_PI * radiance * 4 * quarter, radiance * 1e-3);
}

TEST(Texture, MipLevelsKeepTheMeanLight) {
  Image image(64, 64);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = (i / 3 % 2 == 0) ? 255 : 0;  // black and white columns
  const Texture texture(image);
  EXPECT_NEAR(texture.mean().x, 0.5F, 0.01F);  // in linear light, not of sRGB values
  EXPECT_NEAR(texture.sample(0.5F / 64, 0.5F, 0).x, 1, 0.01F);
  EXPECT_NEAR(texture.sample(1.5F / 64, 0.5F, 0).x, 0, 0.01F);
  EXPECT_NEAR(texture.sample(1 + 0.5F / 64, -3.5F, 0).x, 1, 0.01F);  // repeats
}

TEST(Tone, GreysStayGreyAndRise) {
  int before = -1;
  for (const float x : {0.0F, 0.01F, 0.1F, 0.5F, 1.0F, 3.0F, 20.0F}) {
    const Rgb8 color = display_color({x, x, x});
    EXPECT_NEAR(color.r, color.g, 1);
    EXPECT_NEAR(color.g, color.b, 1);
    EXPECT_GE(color.r, before);
    before = color.r;
  }
  EXPECT_EQ(before, 255);
  EXPECT_EQ(display_color({std::nanf(""), 0, 0}).r, display_color({0, 0, 0}).r);
}

TEST(Tone, PaperIsLightGreysAreNaturalAndLampsAreWhite) {
  const auto byte = [](float exposed) { return 255 * film_curve(exposed); };
  EXPECT_NEAR(byte(0.8F), 220, 3);   // white paper
  EXPECT_NEAR(byte(0.18F), 118, 5);  // a grey card: 118 in sRGB
  EXPECT_LT(byte(0.004F), 12);
  EXPECT_LT(byte(2), 250);  // twice as bright as a white sheet: still told from a lamp
  EXPECT_NEAR(byte(12), 255, 0.1);
  EXPECT_EQ(byte(-1), 0);
}

TEST(Tone, PrintKeepsItsColour) {
  for (const auto& [r, g, b] : {std::array{204, 30, 40}, {20, 140, 60}, {20, 70, 170}}) {
    const auto light = [](int code) {
      return assets::linear_from_srgb(static_cast<std::uint8_t>(code));
    };
    const Rgb8 shown = display_color({light(r), light(g), light(b)});
    EXPECT_NEAR(shown.r, r, 14);
    EXPECT_NEAR(shown.g, g, 14);
    EXPECT_NEAR(shown.b, b, 14);
  }
}

TEST(Tone, FilmTableIsTheCurveBetweenItsStepsToo) {
  const FilmTable table = film_table();
  for (float stops = -11; stops < 3.9F; stops += 0.061F) {
    const float at = (stops - FilmTable::first_stop) * FilmTable::steps_per_stop;
    const auto low = static_cast<std::size_t>(at);
    const float between =
        std::lerp(table.values[low], table.values[low + 1], at - static_cast<float>(low));
    EXPECT_NEAR(255 * between, 255 * film_curve(std::exp2(stops)), 1) << stops;
  }
}

TEST(Tone, BlackBodiesGoFromRedToBlue) {
  const Vec3f warm = black_body(3000), day = black_body(6500), cold = black_body(10000);
  EXPECT_GT(warm.x / warm.z, 2);
  EXPECT_NEAR(day.x / day.z, 1, 0.1F);  // D65 is the white of Rec. 709
  EXPECT_LT(cold.x / cold.z, 1);
  EXPECT_NEAR(luminance(warm), 1, 1e-4F);
}

}  // namespace
}  // namespace marketgen::render::raytrace
