// Path tracing with known answers: furnaces, Fresnel, Snell, a lamp over a floor; the same picture
// for any number of threads; the filter.
#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"
#include "closed_room.h"
#include "render/path/denoise.h"
#include "render/path/light_through.h"
#include "render/path/neural_denoise.h"
#include "render/path/path_numbers.h"
#include "render/path/scattering.h"
#include "synthetic_scene.h"

namespace marketgen::render::raytrace {
namespace {

// What a surface sends to an eye at `cosine` from its normal when light 1 comes from all sides.
Vec3f lit_from_everywhere(const Finish& finish, float cosine, int samples = 65536) {
  const Vec3f up{0, 0, 1}, view{std::sqrt(1 - cosine * cosine), 0, cosine};
  const Scattering scattering(finish, up, up, up, view);
  Vec3f sum;
  for (int i = 0; i < samples; ++i) {
    PathNumbers numbers(7, static_cast<std::uint32_t>(i));
    const float pick = numbers.one();
    const Vec2f at = numbers.pair();
    const Scattering::Value value =
        scattering.evaluate(scattering.sample(pick, at.x, at.y).direction);
    if (value.pdf > 0) sum += (value.diffuse + value.gloss) / value.pdf;
  }
  return sum / static_cast<float>(samples);
}

constexpr float one_percent = 0.01F;

TEST(Scattering, WhiteSurfacesReturnAllLight) {  // coat and base share one budget
  for (const float roughness : {0.05F, 0.3F, 0.6F, 1.0F}) {
    for (const float cosine : {0.15F, 0.5F, 1.0F}) {
      for (const float metallic : {0.0F, 1.0F}) {
        const Finish white{.color = {1, 1, 1}, .roughness = roughness, .metallic = metallic};
        EXPECT_NEAR(lit_from_everywhere(white, cosine).x, 1, one_percent)
            << roughness << " " << cosine << " " << metallic;
      }
    }
  }
}

TEST(Scattering, LacqueredAndThinWhiteSurfacesReturnAllLight) {
  Finish lacquered{.color = {1, 1, 1}, .roughness = 0.5F, .metallic = 1, .coat = 1};
  EXPECT_NEAR(lit_from_everywhere(lacquered, 0.7F).x, 1, one_percent);
  lacquered.metallic = 0;
  EXPECT_NEAR(lit_from_everywhere(lacquered, 0.3F).x, 1, one_percent);
  const Finish leaf{.color = {1, 1, 1}, .roughness = 0.5F, .translucency = 0.4F};
  EXPECT_NEAR(lit_from_everywhere(leaf, 0.7F).x, 1, one_percent);
}

// A dull base returns its colour times what the coat lets in, and what the coat mirrors.
TEST(Scattering, ColouredBaseReturnsItsAlbedoBelowTheCoat) {
  const Finish red{.color = {0.6F, 0.1F, 0}, .roughness = 0.4F};
  for (const float cosine : {0.3F, 0.9F}) {
    const float mirrored = gloss_albedo(cosine, 0.4F).total(dielectric_reflectance);
    const Vec3f seen = lit_from_everywhere(red, cosine);
    EXPECT_NEAR(seen.x, mirrored + (1 - mirrored) * 0.6F, one_percent);
    EXPECT_NEAR(seen.y, mirrored + (1 - mirrored) * 0.1F, one_percent);
    EXPECT_NEAR(seen.z, mirrored, one_percent);
  }
}

// Schlick's reflectance is known where the surface is all but a mirror.
TEST(Scattering, SmoothMetalMirrorsItsColour) {
  const Finish copper{.color = {0.95F, 0.64F, 0.54F}, .roughness = 0.02F, .metallic = 1};
  const Vec3f seen = lit_from_everywhere(copper, 0.5F, 4096);
  const float lift = 1.0F / 32;  // (1 - 0.5)^5
  EXPECT_NEAR(seen.x, 0.95F + 0.05F * lift, one_percent);
  EXPECT_NEAR(seen.z, 0.54F + 0.46F * lift, one_percent);
}

TEST(Scattering, TranslucentLightLeavesOnTheFarSide) {
  const Finish leaf{.color = {0, 0.5F, 0}, .roughness = 1, .translucency = 0.5F};
  const Vec3f up{0, 0, 1};
  const Scattering scattering(leaf, up, up, up, up);
  const Vec3f before = scattering.evaluate(normalized(Vec3f{0.3F, 0, 1})).diffuse;
  const Vec3f behind = scattering.evaluate(normalized(Vec3f{0.3F, 0, -1})).diffuse;
  EXPECT_GT(behind.y, 0);
  EXPECT_NEAR(behind.y, before.y, 1e-4F);
}

// Light both ways between two directions is the same (Helmholtz).
TEST(Scattering, DiffuseBaseIsReciprocal) {
  const Finish paper{.color = {0.7F, 0.7F, 0.7F}, .roughness = 0.5F};
  const Vec3f up{0, 0, 1}, a = normalized(Vec3f{0.9F, 0, 0.4F}),
                           b = normalized(Vec3f{-0.1F, 0.2F, 1});
  const float ab = Scattering(paper, up, up, up, a).evaluate(b).diffuse.x / b.z;
  const float ba = Scattering(paper, up, up, up, b).evaluate(a).diffuse.x / a.z;
  EXPECT_NEAR(ab, ba, 1e-3F * ab);
}

// Fresnel's equations for n = 1.5, e.g. Hecht, Optics, 4.6: 4.0 % at 0 and 30 degrees 4.15 %,
// 60 degrees 8.92 %; all light at grazing incidence.
TEST(Interface, ReflectsAsFresnelSays) {
  const auto at = [](double degrees) {
    return interface_reflectance(static_cast<float>(std::cos(degrees * M_PI / 180)), 1.5F);
  };
  EXPECT_NEAR(at(0), 0.04F, 1e-4F);
  EXPECT_NEAR(at(30), 0.0415F, 2e-4F);
  EXPECT_NEAR(at(60), 0.0892F, 2e-4F);
  EXPECT_NEAR(at(90), 1, 1e-4F);
  EXPECT_NEAR(sheet_reflectance(1, 1.5F), 0.0769F, 1e-4F);  // 2R / (1 + R)
}

TEST(Interface, BendsAsSnellSaysAndMirrorsTotally) {
  const Vec3f up{0, 0, 1};
  const float sine = 0.6F;
  const Vec3f down{sine, 0, -0.8F};
  const auto inside = refracted(down, up, 1.33F);
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->x, sine / 1.33F, 1e-5F);
  const auto outside = refracted(*inside, up, 1 / 1.33F);
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->x, sine, 1e-5F);
  const Vec3f steep{0.9F, 0, -std::sqrt(1 - 0.81F)};  // past the critical angle of 48.8 degrees
  EXPECT_FALSE(refracted(steep, up, 1 / 1.33F));
  EXPECT_EQ(interface_reflectance(-steep.z, 1 / 1.33F), 1);
}

// Closed rooms whose walls glow with 1 and send back the share rho are 1 / (1 - rho) bright.
TEST(PathTracing, GlowingRoomIsEvenlyBright) {
  for (const float metallic : {0.0F, 1.0F}) {
    auto world = empty_world({.color = {0.5F, 0.5F, 0.5F},
                              .emission = {1, 1, 1},
                              .roughness = metallic > 0 ? 0.1F : 1.0F,
                              .metallic = metallic});
    finish_world(*world, cube_room());
    const Vec3f light = mean_path_light(*world, square_view({0, 0, 0}, {0.3, 1, 0.1}), 16384);
    // The coat of a dielectric and Fresnel's lift on a metal send back a few per cent more.
    EXPECT_GT(light.x, 2 * 0.99F);
    EXPECT_LT(light.x, 2.25F);
    EXPECT_NEAR(light.x, light.z, 1e-3F);
  }
}

// A convex thing in an even sky: white paint, white metal and clear glass all vanish against it.
TEST(PathTracing, WhiteAndClearThingsVanishInAnEvenSky) {
  Material rough{.color = {1, 1, 1}, .roughness = 0.6F, .metallic = 1};
  Material mirror{.color = {1, 1, 1}, .roughness = 0.05F, .metallic = 1};
  Material paint{.color = {1, 1, 1}, .roughness = 0.4F};
  Material lacquer{.color = {1, 1, 1}, .roughness = 0.4F, .coat = 1};
  Material glass{.clear = true, .refraction = 1.5F};
  Material sheet{.clear = true};
  for (const Material& material : {rough, mirror, paint, lacquer, glass, sheet}) {
    auto world = empty_world(material);
    world->surroundings.even = {1, 1, 1};
    Mesh mesh;
    add_box(mesh, {-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}, 0, 0);
    finish_world(*world, mesh);
    const Vec3f light =
        mean_path_light(*world, square_view({1.5, 2, 1.2}, {0, 0, 0}, 16, 20), 8192);
    EXPECT_NEAR(light.x, 1, one_percent) << material.metallic << material.clear << material.coat;
  }
}

// Light wandering below the skin leaves elsewhere, but all of it leaves.
TEST(PathTracing, SkinOfFruitKeepsItsAlbedo) {
  auto world = empty_world({.color = {1, 1, 1}, .roughness = 0.5F, .scatter_m = 0.01F});
  world->surroundings.even = {1, 1, 1};
  Mesh mesh;
  add_box(mesh, {-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}, 0, 0);
  finish_world(*world, mesh);
  const Vec3f light = mean_path_light(*world, square_view({1.5, 2, 1.2}, {0, 0, 0}, 16, 20), 8192);
  EXPECT_NEAR(light.x, 1, one_percent);
}

// Beer and Lambert: 0.2 m of what takes 3 per metre leave exp(-0.6), and two faces mirror a little.
TEST(PathTracing, SlabsOfColouredWaterDimByTheirDepth) {
  auto world = empty_world({.clear = true, .refraction = 1.33F, .absorption_per_m = {3, 0, 0}});
  world->surroundings.even = {1, 1, 1};
  Mesh mesh;
  add_box(mesh, {-5, -0.1F, -5}, {5, 0.1F, 5}, 0, 0);
  finish_world(*world, mesh);
  const Vec3f light =
      mean_path_light(*world, square_view({0.3, -2, 0.1}, {0.3, 0, 0.1}, 16, 4), 8192);
  const float r = interface_reflectance(1, 1.33F), kept = std::exp(-0.6F);
  const float through = (1 - r) * (1 - r) * kept / (1 - r * r * kept * kept);
  const float back = r + (1 - r) * (1 - r) * r * kept * kept / (1 - r * r * kept * kept);
  EXPECT_NEAR(light.x, through + back, one_percent);
  EXPECT_NEAR(light.z, 1, one_percent);
  const Vec3f straight = light_through(*world, {{0.3F, -2, 0.1F}, {0, 1, 0}, 0, 4});
  EXPECT_NEAR(straight.x, (1 - r) * (1 - r) * kept, 1e-3F);
  EXPECT_NEAR(straight.y, (1 - r) * (1 - r), 1e-3F);
  const Vec3f from_inside = light_through(*world, {{0.3F, 0, 0.1F}, {0, 1, 0}, 0, 4});
  EXPECT_NEAR(from_inside.x, (1 - r) * std::exp(-0.3F), 1e-3F);
}

// Irradiance under the middle of a square lamp (Howell's catalogue of form factors, C-11), seen as
// the radiance of a white floor without gloss.
TEST(PathTracing, LampLightsAFloorAsItsFormFactorSays) {
  const float side = 1, height = 1, radiance = 100;
  auto world = empty_world({.color = {0.5F, 0.5F, 0.5F}, .roughness = 1});
  world->materials.push_back({.color = {0, 0, 0}, .emission = {radiance, radiance, radiance}});
  world->lights.push_back(make_area_light(
      {-side / 2, side / 2, height}, {side, 0, 0}, {0, -side, 0}, Vec3f{1, 1, 1} * radiance));
  Mesh lamp;
  add_quad(lamp,
           {-side / 2, side / 2, height},
           {side / 2, side / 2, height},
           {side / 2, -side / 2, height},
           {-side / 2, -side / 2, height},
           1);
  append(world->shell, world->shell_glass, lamp, {0, 1}, *world, {1, 0});
  Mesh floor;
  add_quad(floor, {-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}, 0);
  finish_world(*world, floor);
  const Vec3f light =
      mean_path_light(*world, square_view({0.6, -0.6, 0.6}, {0, 0, 0}, 8, 0.5), 65536);
  const double x = side / 2 / height, root = std::sqrt(1 + x * x);
  const double irradiance = M_PI * radiance * 4 * (1 / M_PI) * (x / root) * std::atan(x / root);
  // Diffuse light of the base below its coat, and little gloss: the same by quadrature.
  const Vec3f up{0, 0, 1}, view = normalized(Vec3f{0.6F, -0.6F, 0.6F});
  const Scattering floor_look({.color = {0.5F, 0.5F, 0.5F}, .roughness = 1}, up, up, up, view);
  double sent = 0, arrived = 0;
  constexpr int grid = 200;
  for (int i = 0; i < grid * grid; ++i) {
    const Vec3f to_lamp{(static_cast<float>(i % grid) + 0.5F) / grid * side - side / 2,
                        (static_cast<float>(i / grid) + 0.5F) / grid * side - side / 2,
                        height};
    const Vec3f direction = normalized(to_lamp);
    const double angle = static_cast<double>(direction.z / dot(to_lamp, to_lamp)) / (grid * grid);
    const Scattering::Value value = floor_look.evaluate(direction);
    sent += radiance * angle * static_cast<double>(value.diffuse.x + value.gloss.x);
    arrived += radiance * angle * static_cast<double>(direction.z);
  }
  EXPECT_NEAR(arrived, irradiance, irradiance * 1e-3);
  EXPECT_NEAR(light.x, sent, sent * 0.01);
}

TEST(PathNumbers, CoverTheSquareEvenly) {
  // Every elementary interval of 64 holds exactly one of the first 64 points.
  for (const int columns : {1, 4, 8, 64}) {
    std::vector<int> hits(64);
    for (std::uint32_t i = 0; i < 64; ++i) {
      const Vec2f p = PathNumbers(3, i).pair();
      const int rows = 64 / columns;
      ++hits[static_cast<std::size_t>(static_cast<int>(p.x * static_cast<float>(columns)) * rows +
                                      static_cast<int>(p.y * static_cast<float>(rows)))];
    }
    for (const int count : hits)
      EXPECT_EQ(count, 1) << columns;
  }
}

render::Frame small_path_picture(int threads, render::Denoiser denoiser) {
  const ThreadLimit limit(threads);
  scene::Scene scene = empty_room(6000, 4000, 3000);
  add_box_fixture(scene, {2, 2, 0}, {0.5F, 0.5F, 0.5F}, {0.5F, 0.4F, 0.5F});
  const auto renderer = render::Renderer::create(scene).value();
  render::Camera camera;
  camera.from = {0.5, 0.5, 1.6};
  camera.at = {3, 2.5, 0.5};
  camera.width = 40;
  camera.height = 26;
  render::RenderOptions options;
  options.mode = render::RenderMode::path;
  options.samples = 5;
  options.denoiser = denoiser;
  return renderer->render(camera, options).value();
}

TEST(PathPicture, IsTheSameForAnyNumberOfThreads) {
  const render::Frame one = small_path_picture(1, render::Denoiser::own);
  for (const int threads : {2, 4}) {
    const render::Frame more = small_path_picture(threads, render::Denoiser::own);
    EXPECT_EQ(one.color.pixels, more.color.pixels);
    EXPECT_EQ(one.radiance, more.radiance);
  }
}

TEST(PathPicture, ExposureInStopsBrightensThePictureOnly) {
  scene::Scene scene = empty_room(6000, 4000, 3000);
  const auto renderer = render::Renderer::create(scene).value();
  render::Camera camera;
  camera.from = {0.5, 0.5, 1.6};
  camera.at = {3, 2.5, 0.5};
  camera.width = camera.height = 8;
  render::RenderOptions options{
      .mode = render::RenderMode::path, .samples = 2, .denoiser = render::Denoiser::none};
  const render::Frame plain = renderer->render(camera, options).value();
  options.exposure_stops = -2;
  const render::Frame dark = renderer->render(camera, options).value();
  EXPECT_EQ(plain.radiance, dark.radiance);
  EXPECT_LT(dark.color.pixels[0], plain.color.pixels[0]);
}

// A made-up film: two walls of light 1 and 3 with noise of known variance, and a line of shadow.
struct NoisyWalls {
  PathFilm film;
  PictureGuides guides;
  static constexpr int width = 96, height = 64, corner = 48, shadow = 20;
  static float truth(int x, int y) { return (x < corner ? 1.0F : 3.0F) * (y == shadow ? 0.2F : 1); }
  explicit NoisyWalls(float noise)
      : film(width, height, std::vector<PathSums>(width * height), 1), guides(width * height) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t i = film.index(x, y);
        const bool left = x < corner;
        const float u = static_cast<float>(x) * 0.01F, v = static_cast<float>(y) * 0.01F;
        guides.normal.set(i, left ? Vec3f{0, 0, 1} : Vec3f{1, 0, 0});
        guides.position.set(i, left ? Vec3f{u, v, 0} : Vec3f{0.48F, v, u - 0.48F});
        guides.depth_m[i] = 1;
        const float draw = unit_float(hashed(static_cast<std::uint32_t>(i))) - 0.5F;
        const float value = truth(x, y) + noise * draw;
        film.albedo.set(i, {0.5F, 0.5F, 0.5F});
        film.irradiance.set(i, {value, value, value});
        film.irradiance_variance[i] = noise * noise / 12;
      }
    }
  }
  double mean_error(int first_row, int last_row) const {
    double sum = 0;
    for (int y = first_row; y < last_row; ++y) {
      for (int x = 0; x < width; ++x)
        sum += std::fabs(static_cast<double>(film.irradiance.at(film.index(x, y)).x - truth(x, y)));
    }
    return sum / ((last_row - first_row) * width);
  }
};

TEST(Denoise, TakesOutNoiseAndKeepsCornersAndShadowLines) {
  NoisyWalls walls(0.6F);
  const double before = walls.mean_error(0, 64), line_before = walls.mean_error(20, 21);
  denoise(walls.film, walls.guides);
  EXPECT_LT(walls.mean_error(0, 64), before / 4);
  EXPECT_LT(walls.mean_error(20, 21), line_before);  // one pixel wide, and still there
  EXPECT_NEAR(walls.film.irradiance.at(walls.film.index(47, 40)).x, 1, 0.1F);
  EXPECT_NEAR(walls.film.irradiance.at(walls.film.index(48, 40)).x, 3, 0.1F);
}

TEST(Denoise, LeavesCleanLightAlone) {
  NoisyWalls walls(0);
  denoise(walls.film, walls.guides);
  EXPECT_LT(walls.mean_error(0, 64), 0.01);
}

TEST(Denoise, CutsALoneBrightSample) {
  NoisyWalls walls(0.1F);
  const std::size_t spark = walls.film.index(10, 50);
  walls.film.irradiance.set(spark, {500, 500, 500});
  walls.film.irradiance_variance[spark] = 250'000;
  denoise(walls.film, walls.guides);
  EXPECT_NEAR(walls.film.irradiance.at(spark).x, 1, 0.2F);
}

TEST(NeuralDenoise, HalvesTheErrorWhereInstalled) {
  const auto library = neural_denoiser_library();
  if (!library) GTEST_SKIP() << "no Open Image Denoise here";
  NoisyWalls walls(0.6F);
  const auto radiance = neural_denoise(*library, walls.film, walls.guides, 0.5F);
  ASSERT_TRUE(radiance.ok()) << to_string(radiance.error());
  const double before = walls.mean_error(0, 64);
  for (std::size_t i = 0; i < walls.film.count(); ++i)
    walls.film.irradiance.set(i, radiance->at(i) / 0.5F);
  EXPECT_LT(walls.mean_error(0, 64), before / 2);
}

TEST(NeuralDenoise, SaysWhatIsWrongWithAFileThatIsNoLibrary) {
  NoisyWalls walls(0.1F);
  const auto radiance = neural_denoise("/dev/null", walls.film, walls.guides, 1);
  ASSERT_FALSE(radiance.ok());
  EXPECT_EQ(radiance.error().code, "usage.unavailable");
  EXPECT_EQ(radiance.error().where, "/dev/null");
}

}  // namespace
}  // namespace marketgen::render::raytrace
