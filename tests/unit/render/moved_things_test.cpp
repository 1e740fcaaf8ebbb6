// Products and doors that do not stand where the scene has them, and batches of cameras: pictures
// are those of a scene that was made so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "scene/articulation.h"
#include "support/committed_catalog.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

scene::SceneProduct product_at(float x, float y, float z) {
  scene::SceneProduct product;
  product.sku = 0;
  product.position_m = {x, y, z};
  return product;
}

catalog::Product first_can() {
  const auto& products = committed_catalog().products;
  return *std::find_if(products.begin(), products.end(), [](const catalog::Product& product) {
    return product.archetype == "can";
  });
}

// Two cans stand on a block in front of the camera, one before the other; a door hangs beside.
// Around them nothing, or so many cans behind it that the store's search tree is not built anew.
enum class Store { small, large };
constexpr int cans_of_large = 9'000;

struct CansAndDoor {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  render::Camera camera;
  std::uint32_t cans = 0, door = 0;  // numbers in pictures
  explicit CansAndDoor(Store store = Store::small) {
    add_box_fixture(scene, {3, 3.5F, 0}, {0, 0, 0.4F}, {0.5F, 0.5F, 0.4F});
    door = add_box_fixture(scene, {3.6F, 2.6F, 0}, {0.2F, 0, 1}, {0.2F, 0.02F, 0.4F});
    scene::SceneJoint hinge;
    hinge.fixture = 1;
    hinge.name = "door";
    hinge.kind = assets::JointKind::hinge;
    hinge.lower = -2;
    hinge.upper = 2;
    scene.joints.push_back(hinge);
    scene.fixtures[1].joint_count = 1;
    scene.parts[1].joint = 0;
    scene.catalog.push_back(first_can());
    scene.products = {product_at(3, 3.1F, 0.8F), product_at(3, 3.4F, 0.8F)};
    cans = render::first_product_object(scene);
    camera.from = {3, 2, 0.95};
    camera.at = {3, 3, 0.85};
    camera.width = 160;
    camera.height = 120;
    for (int i = 0; store == Store::large && i < cans_of_large; ++i)
      scene.products.push_back(product_at(
          0.1F + 0.06F * static_cast<float>(i % 95), 0.1F, 0.03F * static_cast<float>(i / 95)));
  }
};

render::Frame taken(render::Renderer& renderer, const render::Camera& camera) {
  Result<render::Frame> frame = renderer.render(camera, {});
  EXPECT_TRUE(frame.ok());
  return std::move(frame).value();
}

render::Frame taken(const scene::Scene& scene, const render::Camera& camera) {
  const auto renderer = render::Renderer::create(scene);
  EXPECT_TRUE(renderer.ok()) << (renderer.ok() ? "" : to_string(renderer.error()));
  return taken(**renderer, camera);
}

int pixels_of(const render::Frame& frame, std::uint32_t object) {
  return static_cast<int>(std::count(frame.instance.begin(), frame.instance.end(), object));
}

void expect_same_geometry(const render::Frame& a, const render::Frame& b) {
  EXPECT_EQ(a.instance, b.instance);
  for (std::size_t i = 0; i < a.depth_m.size(); ++i)
    ASSERT_NEAR(a.depth_m[i], b.depth_m[i], 1e-4F) << i;
}

class MovedInAnyStore : public testing::TestWithParam<Store> {};
INSTANTIATE_TEST_SUITE_P(Sizes, MovedInAnyStore, testing::Values(Store::small, Store::large));

TEST_P(MovedInAnyStore, AProductIsSeenWhereItWasPutAndNowhereElse) {
  CansAndDoor s(GetParam());
  const auto renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  const render::Frame before = taken(**renderer, s.camera);
  ASSERT_GT(pixels_of(before, s.cans), 50);
  const Pose pose{{3.2, 3.0, 0.9}, rotation_about({1, 0, 0}, 0.7)};
  ASSERT_TRUE((*renderer)->move_things(std::vector<render::MovedProduct>{{0, pose}}, {}).ok());
  const render::Frame moved = taken(**renderer, s.camera);
  CansAndDoor other(GetParam());
  other.scene.products[0].position_m = {3.2F, 3.0F, 0.9F};
  other.scene.products[0].rotation_wxyz = {static_cast<float>(pose.rotation.w),
                                           static_cast<float>(pose.rotation.x),
                                           static_cast<float>(pose.rotation.y),
                                           static_cast<float>(pose.rotation.z)};
  expect_same_geometry(moved, taken(other.scene, other.camera));
  // The second can, hidden by the first until now, is seen through where that stood.
  EXPECT_GT(pixels_of(moved, s.cans + 1), pixels_of(before, s.cans + 1));
  ASSERT_TRUE((*renderer)->move_things({}, {}).ok());
  const render::Frame back = taken(**renderer, s.camera);
  EXPECT_EQ(back.color.pixels, before.color.pixels);
  EXPECT_EQ(back.depth_m, before.depth_m);
}

TEST_P(MovedInAnyStore, FollowingOneIsAsPuttingItThere) {
  CansAndDoor s(GetParam());
  const auto followed = render::Renderer::create(s.scene), put = render::Renderer::create(s.scene);
  ASSERT_TRUE(followed.ok() && put.ok());
  for (const double x : {2.8, 2.9, 3.05}) {
    const std::vector<render::MovedProduct> moved{{1, {{x, 3.0, 0.85}, {}}}};
    ASSERT_TRUE((*followed)->move_things(moved, {}).ok());
  }
  ASSERT_TRUE((*put)
                  ->move_things(std::vector<render::MovedProduct>{{1, {{3.05, 3.0, 0.85}, {}}}}, {})
                  .ok());
  EXPECT_EQ(taken(**followed, s.camera).color.pixels, taken(**put, s.camera).color.pixels);
}

TEST(MovedThings, ADoorSwings) {
  CansAndDoor s;
  const auto renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  ASSERT_TRUE((*renderer)->move_things({}, std::vector<render::MovedJoint>{{0, 1.2}}).ok());
  const render::Frame moved = taken(**renderer, s.camera);
  scene::Scene open = scene::scene_at(s.scene, {1.2});
  open.parts[1].joint = -1;
  open.fixtures[1].joint_count = 0;
  open.joints.clear();
  expect_same_geometry(moved, taken(open, s.camera));
  EXPECT_NE(moved.instance, taken(s.scene, s.camera).instance);
}

// In path mode, too, nothing is left of a product where it stood, its shadow included; and its
// outline is the one of where it stands.
TEST(MovedThings, LeaveNoShadowAndNoOutlineBehind) {
  CansAndDoor s;
  scene::Scene without = s.scene;
  without.products.clear();
  const auto renderer = render::Renderer::create(s.scene),
             empty = render::Renderer::create(without);
  ASSERT_TRUE(renderer.ok() && empty.ok());
  const Pose away{{0.5, 5.5, 0}, {}}, beside{{3.2, 3.1, 0.8}, {}};
  ASSERT_TRUE(
      (*renderer)->move_things(std::vector<render::MovedProduct>{{0, away}, {1, away}}, {}).ok());
  render::RenderOptions options;
  options.mode = render::RenderMode::path;
  options.quality = render::Quality::best;
  options.samples = 64;
  options.denoiser = render::Denoiser::none;
  const render::Frame moved = *(*renderer)->render(s.camera, options);
  const render::Frame clear = *(*empty)->render(s.camera, options);
  double sum_moved = 0, sum_clear = 0;  // on the block's top, where the cans stood
  for (int y = 70; y < 90; ++y) {
    for (int x = 70; x < 90; ++x) {
      const auto i = static_cast<std::size_t>(y * s.camera.width + x);
      ASSERT_EQ(moved.instance[i], clear.instance[i]);
      sum_moved += static_cast<double>(moved.radiance[3 * i]);
      sum_clear += static_cast<double>(clear.radiance[3 * i]);
    }
  }
  EXPECT_NEAR(sum_moved / sum_clear, 1, 0.02);

  ASSERT_TRUE((*renderer)->move_things(std::vector<render::MovedProduct>{{0, beside}}, {}).ok());
  const render::Frame frame = taken(**renderer, s.camera);
  const std::vector<render::Silhouette> outline =
      (*renderer)->silhouettes(s.camera, frame, std::span(&s.cans, 1));
  int left = s.camera.width, right = 0;
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    if (frame.instance[i] != s.cans) continue;
    left = std::min(left, static_cast<int>(i) % s.camera.width);
    right = std::max(right, static_cast<int>(i) % s.camera.width);
  }
  ASSERT_TRUE(outline[0].box_px.has_value());
  EXPECT_NEAR((*outline[0].box_px)[0], left, 1.5);
  EXPECT_NEAR((*outline[0].box_px)[2], right + 1, 1.5);
}

TEST(MovedThings, FaultyOnesAreRefusedAndNothingMoves) {
  CansAndDoor s;
  const auto renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  const render::Frame before = taken(**renderer, s.camera);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<render::MovedProduct>> faulty{
      {{2, {}}}, {{0, {}}, {0, {}}}, {{0, {{nan, 0, 0}, {}}}}, {{0, {{}, {0, 0, 0, 0}}}}};
  for (const auto& products : faulty) {
    const Result<void> moved = (*renderer)->move_things(products, {});
    ASSERT_FALSE(moved.ok());
    EXPECT_EQ(moved.error().code, "render.bad_move");
  }
  for (const render::MovedJoint& joint : {render::MovedJoint{1, 0.5}, render::MovedJoint{0, nan}}) {
    const Result<void> moved = (*renderer)->move_things({}, std::span(&joint, 1));
    ASSERT_FALSE(moved.ok());
    EXPECT_EQ(moved.error().code, "render.bad_move");
  }
  EXPECT_EQ(taken(**renderer, s.camera).color.pixels, before.color.pixels);
}

// Buffers of one picture.
struct Memory {
  std::vector<std::uint8_t> rgb, matter;
  std::vector<float> depth, normals;
  std::vector<std::uint32_t> instance;
  explicit Memory(std::size_t pixels)
      : rgb(3 * pixels), matter(pixels), depth(pixels), normals(3 * pixels), instance(pixels) {}
  render::FrameBuffers buffers() {
    return {rgb.data(), depth.data(), instance.data(), normals.data(), matter.data()};
  }
};

TEST(Batch, ManyCamerasOfManyWorldsAreAsOneByOne) {
  CansAndDoor s;
  const auto first = render::Renderer::create(s.scene), second = render::Renderer::create(s.scene);
  ASSERT_TRUE(first.ok() && second.ok());
  ASSERT_TRUE((*second)
                  ->move_things(std::vector<render::MovedProduct>{{0, {{3.1, 3.0, 0.85}, {}}}}, {})
                  .ok());
  std::vector<render::Shot> shots;
  std::vector<Memory> memory(6, Memory(160 * 120));
  for (std::size_t i = 0; i < memory.size(); ++i) {
    render::Camera camera = s.camera;
    camera.from.x += 0.05 * static_cast<double>(i);
    shots.push_back({i % 2 == 0 ? first->get() : second->get(), camera, memory[i].buffers()});
  }
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    for (Memory& m : memory)
      std::fill(m.rgb.begin(), m.rgb.end(), std::uint8_t{1});
    ASSERT_TRUE(render::render_batch(shots, {}).ok());
    for (std::size_t i = 0; i < memory.size(); ++i) {
      const render::Frame alone = taken(*shots[i].renderer, shots[i].camera);
      EXPECT_EQ(memory[i].rgb, alone.color.pixels) << i;
      EXPECT_EQ(memory[i].depth, alone.depth_m) << i;
      EXPECT_EQ(memory[i].instance, alone.instance) << i;
      EXPECT_EQ(memory[i].normals, alone.normals) << i;
      EXPECT_EQ(memory[i].matter, alone.matter) << i;
    }
  }
}

TEST(Batch, WhatIsNotWantedIsNotWritten) {
  CansAndDoor s;
  const auto renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  std::vector<float> depth(160 * 120);
  const render::Shot shot{renderer->get(), s.camera, {.depth_m = depth.data()}};
  ASSERT_TRUE(render::render_batch(std::span(&shot, 1), {}).ok());
  EXPECT_EQ(depth, taken(**renderer, s.camera).depth_m);
}

TEST(Batch, AFaultyCameraIsNamed) {
  CansAndDoor s;
  const auto renderer = render::Renderer::create(s.scene);
  ASSERT_TRUE(renderer.ok());
  render::Camera faulty = s.camera;
  faulty.width = 0;
  const std::vector<render::Shot> shots{{renderer->get(), s.camera, {}},
                                        {renderer->get(), faulty, {}}};
  const Result<void> result = render::render_batch(shots, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "camera.bad_size");
  EXPECT_EQ(result.error().where, "shot 1");
}

}  // namespace
}  // namespace marketgen
