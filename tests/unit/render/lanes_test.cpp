// Eight side by side say what each says alone: textures, surfaces, stored rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/cameras/view.h"
#include "render/sensor/surface8.h"
#include "render/sensor/texture8.h"
#include "render/stage/build_world.h"
#include "render/stage/exhibit.h"
#include "support/committed_catalog.h"
#include "synthetic_scene.h"

namespace marketgen::render::raytrace {
namespace {

Image colorful(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y)[0] = static_cast<std::uint8_t>(x * 37 % 256);
      image.at(x, y)[1] = static_cast<std::uint8_t>(y * 53 % 256);
      image.at(x, y)[2] = static_cast<std::uint8_t>((x + y) % 3 * 100);
    }
  }
  return image;
}

TEST(Lanes, RowsComeOutAsColumns) {
  std::array<std::array<std::int32_t, lane_count>, lane_count> numbers;
  std::array<const void*, lane_count> rows;
  for (std::size_t k = 0; k < lane_count; ++k) {
    for (std::size_t i = 0; i < lane_count; ++i)
      numbers[k][i] = static_cast<std::int32_t>(100 * k + i);
    rows[k] = numbers[k].data();
  }
  const Rows8 columns = side_by_side(rows);
  for (std::size_t k = 0; k < lane_count; ++k) {
    for (std::size_t i = 0; i < lane_count; ++i)
      EXPECT_EQ(columns[i][k], numbers[k][i]);
  }
}

TEST(Lanes, EightTexturesSayWhatEachSaysAlone) {
  const Texture plain(colorful(33, 20)), blocks(blocks_of(colorful(64, 30))),
      bars(blocks_of(colorful(128, 64)),
           assets::LabelBars{
               .u0 = 0.2F, .v0 = 0.1F, .u1 = 0.9F, .v1 = 0.8F, .modules = std::string(95, '1')});
  const std::array<const Texture*, 3> kinds{&plain, &blocks, &bars};
  for (int round = 0; round < 200; ++round) {
    TexturePoints points;
    for (std::size_t k = 0; k < lane_count; ++k) {
      const auto n = static_cast<float>(round) * 8 + static_cast<float>(k);
      // The first rounds have one kind each, the others all of them.
      points.textures[k] = kinds[(round < 60 ? static_cast<std::size_t>(round)
                                             : k * k + static_cast<std::size_t>(round)) %
                                 3];
      points.u.set(k, std::sin(n) * 2);
      points.v.set(k, std::cos(n * 1.7F) * 2);
      points.lod.set(k, std::sin(n * 0.37F) * 6);
    }
    for (const TextureDetail detail : {TextureDetail::full, TextureDetail::level}) {
      const Vec8 seen = filtered(points, detail);
      for (std::size_t k = 0; k < lane_count; ++k) {
        const Texture& texture = *points.textures[k];
        const float u = points.u[k], v = points.v[k], lod = points.lod[k];
        const Vec3f alone = (detail == TextureDetail::full ? texture.filtered(u, v, lod)
                                                           : texture.filtered_in_level(u, v, lod))
                                .xyz();
        EXPECT_NEAR(seen.x[k], alone.x, 1e-5F);
        EXPECT_NEAR(seen.y[k], alone.y, 1e-5F);
        EXPECT_NEAR(seen.z[k], alone.z, 1e-5F);
      }
    }
  }
}

void expect_near(Vec3f a, Vec3f b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

void expect_alike(const Surface& a, const Surface& b) {
  expect_near(a.position, b.position, 1e-5F);
  expect_near(a.face_normal, b.face_normal, 1e-6F);
  expect_near(a.normal, b.normal, 1e-5F);
  expect_near(a.relief_normal, b.relief_normal, 1e-4F);
  expect_near(a.albedo, b.albedo, 1e-4F);
  expect_near(a.emission, b.emission, 0);
  EXPECT_NEAR(a.roughness, b.roughness, 1e-5F);
  EXPECT_NEAR(a.metallic, b.metallic, 1e-5F);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.fixture, b.fixture);
  EXPECT_EQ(a.shelf, b.shelf);
  EXPECT_EQ(a.glass, b.glass);
}

// A room with a box, a pane and packs: floor and walls have textures and relief.
TEST(Lanes, EightSurfacesAreThoseOfSingleRays) {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  add_box_fixture(scene, {3, 3.5F, 0}, {0, 0, 0.5F}, {0.5F, 0.5F, 0.5F});
  add_box_fixture(
      scene, {4, 2.5F, 0}, {0, 0, 0.5F}, {0.3F, 0.02F, 0.5F}, assets::SurfaceKind::glass);
  // Two worn packs among them, one before the other.
  const auto& products = committed_catalog().products;
  scene.catalog.push_back(
      *std::find_if(products.begin(), products.end(), [](const catalog::Product& row) {
        return row.archetype == "box";
      }));
  scene.products.resize(2);
  scene.products[0].position_m = {3, 1.7F, 1.1F};
  scene.products[1].position_m = {3.2F, 1.9F, 1.1F};
  const auto world = build_world(scene, {}, silent_progress(), {});
  ASSERT_TRUE(world.ok());
  for (std::uint32_t i = 0; i < 2; ++i)
    (*world)->instances[(*world)->first_product_instance + i].look = {{1.08F, 0.97F, 0.9F}, 0.8F};
  render::Camera camera;
  camera.from = {3, 1, 1.5};
  camera.at = {3.1, 3, 0.7};
  camera.fov_deg = 75;
  camera.width = 160;
  camera.height = 120;
  const View view(camera);
  for (int y = 0; y < camera.height; y += 3) {
    for (int x = 0; x < camera.width; x += static_cast<int>(packet_size)) {
      RTCRayHit16 packet;
      std::array<Rays8, 2> rays;
      for (std::size_t half = 0; half < 2; ++half) {
        const Float8 lanes(_mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7));
        const float first = static_cast<float>(x) + 8 * static_cast<float>(half);
        rays[half] = view.rays(lanes + first, static_cast<float>(y) + 0.5F);
        set_rays(packet.ray, half, rays[half], View::near_m);
      }
      trace(**world, packet, packet_size, mask_opaque | mask_glass, RayBundle::coherent);
      for (std::size_t i = 0; i < packet_size; ++i) {
        const std::size_t half = i / lane_count, k = i % lane_count;
        const Hits8 hits = hits_of(packet, half);
        ASSERT_TRUE(hits.any[k]);
        Surface8 seen;
        const TextureDetail detail = y % 2 == 0 ? TextureDetail::full : TextureDetail::level;
        see_surfaces(**world, rays[half], hits, view.footprint(hits.t), detail, seen);
        const Hit hit = hit_in(packet, i);
        expect_alike(surface_in(seen, k),
                     surface_at(**world,
                                {lane(rays[half].origin, k), lane(rays[half].direction, k)},
                                hit,
                                view.footprint(hit.t),
                                detail));
      }
    }
  }
}

}  // namespace
}  // namespace marketgen::render::raytrace
