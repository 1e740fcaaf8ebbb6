// Actors in pictures: boxes whose depth is known, robots against triangles met one by one, and what
// a robot must leave as it was.
#include "render/stage/actor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "render/stage/robot_actor.h"
#include "robots/link_parts.h"
#include "robots/placed_robot.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr float one_millimetre = 1e-3F;

std::unique_ptr<render::Renderer> renderer_of(const scene::Scene& scene) {
  Result<std::unique_ptr<render::Renderer>> made = render::Renderer::create(scene);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : to_string(made.error()));
  return std::move(made).value();
}

render::Frame picture_of(render::Renderer& renderer,
                         const render::Camera& camera,
                         render::RenderOptions options = {}) {
  const Result<render::Frame> frame = renderer.render(camera, options);
  EXPECT_TRUE(frame.ok()) << (frame.ok() ? "" : to_string(frame.error()));
  return *frame;
}

render::Camera camera_at(Vec3 from, Vec3 at) {
  render::Camera camera;
  camera.from = from;
  camera.at = at;
  camera.width = 161;
  camera.height = 121;
  return camera;
}

std::size_t pixel_at(const render::Camera& camera, int x, int y) {
  return static_cast<std::size_t>(y * camera.width + x);
}

render::Actor box_actor(Vec3 middle, Vec3f half, float yaw = 0) {
  render::ActorBody body;
  body.name = "box";
  add_box(body.mesh, -half, half, 0, 0);
  body.surfaces.push_back({{0.8F, 0.1F, 0.1F}, 0.5F, 0});
  body.world_from_body = {middle, rotation_about({0, 0, 1}, yaw)};
  return {"crate", {body}};
}

// A room of 6 x 6 x 3 m with a shelf of 1 x 0.4 x 1 m at its north wall.
struct Room {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  std::uint32_t shelf = add_box_fixture(scene, {3, 5.5F, 0}, {0, 0, 0.5F}, {0.5F, 0.2F, 0.5F});
  render::Camera camera = camera_at({3, 1, 0.5}, {3, 2, 0.5});
};

TEST(Actors, DepthAndNumberOfABoxAreKnown) {
  const Room room;
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer->set_actors({box_actor({3, 3, 0.5}, {0.2F, 0.2F, 0.2F})}).ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  const std::size_t middle = pixel_at(room.camera, 80, 60);
  EXPECT_NEAR(frame.depth_m[middle], 1.8F, one_millimetre);
  EXPECT_EQ(frame.instance[middle], render::first_actor_object(room.scene));
  EXPECT_NEAR(frame.normals[3 * middle + 1], -1, one_millimetre);
  const std::size_t beside = pixel_at(room.camera, 70 - 25, 60);  // 0.35 m left of the box
  EXPECT_EQ(frame.instance[beside], 1U);
}

// Turned by 45 degrees it shows its edge, half a diagonal nearer than its middle.
TEST(Actors, MovingOneIsAsPuttingItThere) {
  const Room room;
  const auto moved = renderer_of(room.scene), put = renderer_of(room.scene);
  const render::Actor there =
      box_actor({3, 2.5, 0.5}, {0.2F, 0.2F, 0.2F}, std::numbers::pi_v<float> / 4);
  ASSERT_TRUE(moved->set_actors({box_actor({1, 3, 0.5}, {0.2F, 0.2F, 0.2F})}).ok());
  picture_of(*moved, room.camera);
  ASSERT_TRUE(moved->move_actor(0, std::vector<Pose>{there.bodies[0].world_from_body}).ok());
  ASSERT_TRUE(put->set_actors({there}).ok());
  const render::Frame a = picture_of(*moved, room.camera), b = picture_of(*put, room.camera);
  EXPECT_EQ(a.color.pixels, b.color.pixels);
  EXPECT_EQ(a.depth_m, b.depth_m);
  EXPECT_EQ(a.instance, b.instance);
  EXPECT_NEAR(
      a.depth_m[pixel_at(room.camera, 80, 60)], 1.5F - 0.2F * std::numbers::sqrt2_v<float>, 0.01F);
}

TEST(Actors, WithoutThemThePictureIsTheStores) {
  const Room room;
  const auto renderer = renderer_of(room.scene);
  const render::Frame before = picture_of(*renderer, room.camera);
  ASSERT_TRUE(renderer->set_actors({box_actor({3, 3, 0.5}, {0.2F, 0.2F, 0.2F})}).ok());
  EXPECT_NE(picture_of(*renderer, room.camera).color.pixels, before.color.pixels);
  ASSERT_TRUE(renderer->set_actors({}).ok());
  const render::Frame after = picture_of(*renderer, room.camera);
  EXPECT_EQ(after.color.pixels, before.color.pixels);
  EXPECT_EQ(after.depth_m, before.depth_m);
}

TEST(Actors, EachHasItsOwnNumberAndHidesWhatIsBehind) {
  const Room room;
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer
                  ->set_actors({box_actor({3, 4, 0.5}, {0.5F, 0.1F, 0.5F}),
                                box_actor({3.2, 3, 0.5}, {0.2F, 0.1F, 0.2F})})
                  .ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  const std::uint32_t first = render::first_actor_object(room.scene);
  EXPECT_EQ(frame.instance[pixel_at(room.camera, 75, 60)], first);
  EXPECT_EQ(frame.instance[pixel_at(room.camera, 90, 60)], first + 1);
}

TEST(Actors, BehindGlassTheyAreSeen) {
  Room room;
  add_box_fixture(
      room.scene, {3, 2, 0}, {0, 0, 0.5F}, {2, 0.005F, 0.5F}, assets::SurfaceKind::glass);
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer->set_actors({box_actor({3, 3, 0.5}, {0.2F, 0.2F, 0.2F})}).ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  EXPECT_EQ(frame.instance[pixel_at(room.camera, 80, 60)], render::first_actor_object(room.scene));
  EXPECT_NEAR(frame.depth_m[pixel_at(room.camera, 80, 60)], 1.8F, one_millimetre);
}

// ---- Robots. ----

robots::PlacedRobot robot_at(const std::string& text) {
  const auto spec = robots::parse_robot_spec(text, text);
  EXPECT_TRUE(spec.ok());
  Result<robots::PlacedRobot> placed =
      robots::place_robot(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", *spec, text);
  EXPECT_TRUE(placed.ok()) << (placed.ok() ? "" : to_string(placed.error()));
  return std::move(placed).value();
}

render::Actor actor_of(const robots::PlacedRobot& placed) {
  Result<render::Actor> actor = render::robot_actor(placed.robot, placed.q, placed.world_from_base);
  EXPECT_TRUE(actor.ok());
  return std::move(actor).value();
}

// The pinhole written out anew: the axes of a level camera, and where points land.
struct Pinhole {
  Vec3 from, ahead, right, up;
  double focal_px, middle_x, middle_y;
  explicit Pinhole(const render::Camera& camera)
      : from(camera.from),
        ahead(normalized(camera.at - camera.from)),
        right(normalized(cross(ahead, {0, 0, 1}))),
        up(cross(right, ahead)),
        focal_px(camera.height / 2.0 / std::tan(camera.fov_deg * std::numbers::pi / 360)),
        middle_x(camera.width / 2.0),
        middle_y(camera.height / 2.0) {}
  Vec3 ray(int x, int y) const {  // one metre along the axis
    return ahead + right * ((x + 0.5 - middle_x) / focal_px) -
           up * ((y + 0.5 - middle_y) / focal_px);
  }
  std::array<int, 2> pixel(Vec3 p) const {
    const Vec3 d = p - from;
    const double depth = dot(d, ahead);
    return {static_cast<int>(std::floor(middle_x + dot(d, right) / depth * focal_px)),
            static_cast<int>(std::floor(middle_y - dot(d, up) / depth * focal_px))};
  }
};

// The robot's triangles in the store frame, by links.
std::vector<std::vector<std::array<Vec3, 3>>> triangles_of(const robots::PlacedRobot& placed) {
  std::vector<std::vector<std::array<Vec3, 3>>> all;
  const auto links = robots::robot_parts(placed.robot, robots::link_poses(placed.robot, placed.q));
  EXPECT_TRUE(links.ok());
  for (const auto& parts : *links) {
    auto& triangles = all.emplace_back();
    for (const robots::LinkPart& part : parts) {
      for (const auto& t : part.mesh.triangles) {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = placed.world_from_base * to_double(part.mesh.positions[t[k]]);
        triangles.push_back(corners);
      }
    }
  }
  return all;
}

// Cramer's rule (Moeller and Trumbore, 1997), both sides.
std::optional<double> meeting(Vec3 from, Vec3 direction, const std::array<Vec3, 3>& t) {
  const Vec3 a = t[1] - t[0], b = t[2] - t[0], p = cross(direction, b), s = from - t[0];
  const double determinant = dot(a, p);
  if (std::abs(determinant) < 1e-18) return {};
  const double u = dot(s, p) / determinant;
  const Vec3 q = cross(s, a);
  const double v = dot(direction, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return {};
  const double far = dot(b, q) / determinant;
  return far > 0 ? std::optional(far) : std::nullopt;
}

double nearest_meeting(const std::vector<std::vector<std::array<Vec3, 3>>>& links,
                       Vec3 from,
                       Vec3 direction) {
  double nearest = HUGE_VAL;
  for (const auto& triangles : links) {
    for (const auto& triangle : triangles)
      nearest = std::min(nearest, meeting(from, direction, triangle).value_or(HUGE_VAL));
  }
  return nearest;
}

struct RobotRoom {
  scene::Scene scene = empty_room(6000, 6000, 3000);
  robots::PlacedRobot robot;
  render::Camera camera = camera_at({1.2, 1, 1.3}, {3, 3, 0.75});
  explicit RobotRoom(const std::string& text) : robot(robot_at(text)) {}
};

class RobotPictures : public testing::TestWithParam<const char*> {};

// Pixels whose ray passes an edge within a hair may go either way: 1 in 200 is let off.
TEST_P(RobotPictures, DepthIsThatOfItsTriangles) {
  const RobotRoom room(GetParam());
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer->set_actors({actor_of(room.robot)}).ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  const auto links = triangles_of(room.robot);
  const Pinhole eye(room.camera);
  int looked = 0, on_robot = 0, wrong = 0;
  for (int y = 1; y < room.camera.height; y += 4) {
    for (int x = 1; x < room.camera.width; x += 4) {
      const std::size_t i = pixel_at(room.camera, x, y);
      const double expected = nearest_meeting(links, eye.from, eye.ray(x, y));
      const bool seen = frame.instance[i] == render::first_actor_object(room.scene);
      ++looked;
      on_robot += seen ? 1 : 0;
      if (seen != std::isfinite(expected) || (seen && std::abs(frame.depth_m[i] - expected) > 1e-3))
        ++wrong;
    }
  }
  EXPECT_GT(on_robot, looked / 40);
  EXPECT_LE(wrong, looked / 200);
}

// One of the pixels round (x, y) shows `object`: a finger is thinner than a pixel is wide.
bool near_pixel_is(
    const render::Frame& frame, const render::Camera& camera, int x, int y, std::uint32_t object) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (frame.instance[pixel_at(camera, x + dx, y + dy)] == object) return true;
    }
  }
  return false;
}

// The middle of each link's body lies behind a pixel of the robot.
TEST_P(RobotPictures, EveryLinkCoversItsPlaceInTheSegmentation) {
  const RobotRoom room(GetParam());
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer->set_actors({actor_of(room.robot)}).ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  const Pinhole eye(room.camera);
  int links = 0, covered = 0;
  for (const auto& triangles : triangles_of(room.robot)) {
    if (triangles.empty()) continue;
    Vec3 sum;
    for (const auto& t : triangles)
      sum = sum + t[0] + t[1] + t[2];
    const auto [x, y] = eye.pixel(sum / (3.0 * static_cast<double>(triangles.size())));
    ASSERT_TRUE(x > 0 && y > 0 && x + 1 < room.camera.width && y + 1 < room.camera.height);
    ++links;
    covered +=
        near_pixel_is(frame, room.camera, x, y, render::first_actor_object(room.scene)) ? 1 : 0;
  }
  EXPECT_GT(links, 8);
  EXPECT_EQ(covered, links);
}

TEST_P(RobotPictures, TheStoreStaysAsItWas) {
  const RobotRoom room(GetParam());
  const auto renderer = renderer_of(room.scene);
  const render::Frame before = picture_of(*renderer, room.camera);
  ASSERT_TRUE(renderer->set_actors({actor_of(room.robot)}).ok());
  const render::Frame with = picture_of(*renderer, room.camera);
  const Pinhole eye(room.camera);
  const Vec3 base = room.robot.world_from_base.position;
  double far_change = 0, under_before = 0, under_with = 0;
  int far = 0, under = 0;
  for (std::size_t i = 0; i < with.instance.size(); ++i) {
    if (with.instance[i] == render::first_actor_object(room.scene)) {
      EXPECT_LE(with.depth_m[i], before.depth_m[i] + 1e-4F);
      continue;
    }
    ASSERT_EQ(with.instance[i], before.instance[i]);
    ASSERT_EQ(with.depth_m[i], before.depth_m[i]);
    const int pixel = static_cast<int>(i);
    const Vec3 seen = eye.from + eye.ray(pixel % room.camera.width, pixel / room.camera.width) *
                                     double{with.depth_m[i]};
    const double away = std::hypot(seen.x - base.x, seen.y - base.y);
    const int was = before.color.pixels[3 * i + 1], is = with.color.pixels[3 * i + 1];
    if (away > 2) far_change += std::abs(is - was), ++far;
    if (away < 0.6 && seen.z < 0.01) under_before += was, under_with += is, ++under;
  }
  ASSERT_GT(far, 100);
  EXPECT_LT(far_change / far, 1.5);  // of 255: light that comes back from the robot, and noise
  ASSERT_GT(under, 10);
  EXPECT_LT(under_with, 0.99 * under_before);  // it stands in its own shadow
}

INSTANTIATE_TEST_SUITE_P(Rows,
                         RobotPictures,
                         testing::Values("panda-on-stand@3,3,-150",
                                         "realman-rm65@3,3,-120,lift=0.4",
                                         "realman-rm75@3,3,-160,left_tool=suction-cup"));

TEST(Actors, RobotsMoveByTheirLinkPoses) {
  const RobotRoom room("panda-on-stand@3,3,-150");
  const robots::PlacedRobot next = robot_at("panda-on-stand@3.4,2.8,170,joint1=0.4,joint4=-1.9");
  const auto moved = renderer_of(room.scene), put = renderer_of(room.scene);
  ASSERT_TRUE(moved->set_actors({actor_of(room.robot)}).ok());
  ASSERT_TRUE(put->set_actors({actor_of(next)}).ok());
  ASSERT_TRUE(
      moved->move_actor(0, render::world_link_poses(next.robot, next.q, next.world_from_base))
          .ok());
  EXPECT_EQ(picture_of(*moved, room.camera).color.pixels,
            picture_of(*put, room.camera).color.pixels);
}

class ActorThreads : public testing::TestWithParam<render::RenderMode> {};

TEST_P(ActorThreads, ThreadCountDoesNotChangePixels) {
  const RobotRoom room("realman-rm65@3,3,-120");
  render::RenderOptions options;
  options.mode = GetParam();
  options.samples = 2;
  std::vector<render::Frame> frames;
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    const auto renderer = renderer_of(room.scene);
    ASSERT_TRUE(renderer->set_actors({actor_of(room.robot)}).ok());
    frames.push_back(picture_of(*renderer, room.camera, options));
  }
  EXPECT_EQ(frames[0].color.pixels, frames[1].color.pixels);
  EXPECT_EQ(frames[0].instance, frames[1].instance);
  EXPECT_TRUE(std::find(frames[0].instance.begin(),
                        frames[0].instance.end(),
                        render::first_actor_object(room.scene)) != frames[0].instance.end());
}
INSTANTIATE_TEST_SUITE_P(BothModes,
                         ActorThreads,
                         testing::Values(render::RenderMode::sensor, render::RenderMode::path));

// ---- Faults. ----

void expect_bad(const Result<void>& set) {
  ASSERT_FALSE(set.ok());
  EXPECT_EQ(set.error().code, "render.bad_actor") << to_string(set.error());
}

TEST(Actors, FaultyOnesAreRefusedAndNothingChanges) {
  const Room room;
  const auto renderer = renderer_of(room.scene);
  const render::Actor good = box_actor({3, 3, 0.5}, {0.2F, 0.2F, 0.2F});
  ASSERT_TRUE(renderer->set_actors({good}).ok());
  const render::Frame before = picture_of(*renderer, room.camera);
  const auto refused = [&](const auto& spoil) {
    render::Actor bad = good;
    spoil(bad.bodies[0]);
    expect_bad(renderer->set_actors({bad}));
  };
  refused([](render::ActorBody& body) { body.mesh.triangles[0][1] = 1000; });
  refused([](render::ActorBody& body) { body.mesh.surfaces[0] = 1; });
  refused([](render::ActorBody& body) { body.mesh.surfaces.pop_back(); });
  refused([](render::ActorBody& body) { body.mesh.normals.pop_back(); });
  refused([](render::ActorBody& body) { body.mesh.positions[0].x = NAN; });
  refused([](render::ActorBody& body) { body.surfaces[0].color.x = 1.5F; });
  refused([](render::ActorBody& body) { body.surfaces[0].roughness = NAN; });
  refused([](render::ActorBody& body) { body.world_from_body.position.z = HUGE_VAL; });
  refused([](render::ActorBody& body) { body.world_from_body.rotation.w = 2; });
  expect_bad(renderer->move_actor(1, std::vector<Pose>(1)));
  expect_bad(renderer->move_actor(0, std::vector<Pose>(2)));
  Pose nowhere;
  nowhere.position.x = NAN;
  expect_bad(renderer->move_actor(0, std::vector<Pose>{nowhere}));
  EXPECT_EQ(picture_of(*renderer, room.camera).color.pixels, before.color.pixels);
}

TEST(PictureObjects, NumbersArePaintedExactly) {
  const Room room;
  const auto renderer = renderer_of(room.scene);
  ASSERT_TRUE(renderer->set_actors({box_actor({3.1, 2, 0.5}, {0.1F, 0.1F, 0.1F})}).ok());
  const render::Frame frame = picture_of(*renderer, room.camera);
  const Image ids = render::draw_object_ids(frame);
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    ASSERT_EQ(ids.pixels[3 * i] + 256U * ids.pixels[3 * i + 1] + 65'536U * ids.pixels[3 * i + 2],
              frame.instance[i]);
  }
}

}  // namespace
}  // namespace marketgen
