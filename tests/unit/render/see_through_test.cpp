// Clear packs in sensor pictures: what lies behind shows, while depth, number and matter stay the
// pack's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "support/committed_catalog.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

// A bottle of water on a block, a coloured board 0.3 m behind it.
struct BottleBeforeBoard {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  render::Camera camera;
  std::uint32_t bottle = 0;

  explicit BottleBeforeBoard(std::array<float, 3> board) {
    add_box_fixture(scene, {3, 3.2F, 0}, {0, 0, 0.4F}, {0.5F, 0.4F, 0.4F});
    add_box_fixture(scene, {3, 3.5F, 0}, {0, 0, 1}, {0.5F, 0.02F, 0.4F});
    scene.parts.back().color = board;
    scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
    scene.catalog.push_back(water());
    scene::SceneProduct product;
    product.position_m = {3, 3.2F, 0.8F};
    scene.products = {product};
    bottle = render::first_product_object(scene);
    camera.from = {3, 2.5, 0.95};
    camera.at = {3, 3.2, 0.95};
    camera.fov_deg = 30;
    camera.width = 200;
    camera.height = 200;
  }

  static catalog::Product water() {
    const auto& products = committed_catalog().products;
    return *std::find_if(products.begin(), products.end(), [](const catalog::Product& product) {
      return product.sku == "beverages-mineral-water-still-1-5l";
    });
  }

  render::Frame taken(const render::RenderOptions& options) const {
    const auto renderer = render::Renderer::create(scene);
    EXPECT_TRUE(renderer.ok()) << (renderer.ok() ? "" : to_string(renderer.error()));
    return (*renderer)->render(camera, options).value();
  }
};

render::RenderOptions at_quality(render::Quality quality) {
  render::RenderOptions options;
  options.quality = quality;
  return options;
}

bool is_clear(const render::Frame& frame, std::size_t pixel) {
  return static_cast<render::Matter>(frame.matter[pixel]) == render::Matter::clear;
}

// Mean colour of the clear wall's pixels.
Vec3 wall_color(const render::Frame& frame) {
  Vec3 sum;
  double count = 0;
  for (std::size_t i = 0; i < frame.matter.size(); ++i) {
    if (!is_clear(frame, i)) continue;
    const std::uint8_t* rgb = &frame.color.pixels[3 * i];
    sum += Vec3{double(rgb[0]), double(rgb[1]), double(rgb[2])};
    ++count;
  }
  EXPECT_GT(count, 1000);
  return sum / count;
}

TEST(SeeThrough, TheBoardBehindABottleColoursIt) {
  const BottleBeforeBoard red({0.8F, 0.05F, 0.05F}), green({0.05F, 0.5F, 0.05F});
  for (const render::Quality quality :
       {render::Quality::fast, render::Quality::balanced, render::Quality::best}) {
    const render::Frame before_red = red.taken(at_quality(quality)),
                        before_green = green.taken(at_quality(quality));
    const Vec3 with_red = wall_color(before_red), with_green = wall_color(before_green);
    EXPECT_GT(with_red.x, with_red.y + 40) << name_of(quality);
    EXPECT_GT(with_green.y, with_green.x + 20) << name_of(quality);
    // Annotations are the bottle's.
    EXPECT_EQ(before_red.instance, before_green.instance);
    EXPECT_EQ(before_red.depth_m, before_green.depth_m);
    EXPECT_EQ(before_red.matter, before_green.matter);
    for (std::size_t i = 0; i < before_red.matter.size(); ++i) {
      if (!is_clear(before_red, i)) continue;
      ASSERT_EQ(before_red.instance[i], red.bottle);
      ASSERT_NEAR(before_red.depth_m[i], 0.68F, 0.03F);
    }
  }
}

// Path tracing bends light the same way; its labels and what they hide are equal anyway.
TEST(SeeThrough, WallsLookAsInPathTracing) {
  const BottleBeforeBoard board({0.8F, 0.05F, 0.05F});
  const render::Frame sensor = board.taken(at_quality(render::Quality::best));
  render::RenderOptions options;
  options.mode = render::RenderMode::path;
  options.samples = 32;
  options.denoiser = render::Denoiser::own;
  const render::Frame path = board.taken(options);
  const Vec3 a = wall_color(sensor), b = wall_color(path);
  EXPECT_NEAR(a.x, b.x, 20);
  EXPECT_NEAR(a.y, b.y, 20);
  EXPECT_NEAR(a.z, b.z, 20);
}

TEST(SeeThrough, ThreadsChangeNothing) {
  const BottleBeforeBoard board({0.8F, 0.05F, 0.05F});
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return board.taken(at_quality(render::Quality::best));
  };
  const render::Frame one = with_threads(1), three = with_threads(3);
  EXPECT_EQ(one.color.pixels, three.color.pixels);
}

}  // namespace
}  // namespace marketgen
