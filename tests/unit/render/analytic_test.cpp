// Depth, numbers and normals of bodies whose pictures are known by formula, through plain and
// distorted lenses in any pose: planes, a box, a cylinder, a sphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "render/picture_objects.h"
#include "render/render.h"
#include "synthetic_scene.h"

namespace marketgen {
namespace {

constexpr double within_m = 1e-3;

// Where a ray from `eye` along `d` meets something, by formula: how far, and the normal there.
struct Met {
  double t = 0;
  Vec3 normal;
  std::uint32_t object = 0;
};
using Eye = Vec3;

void keep_nearest(std::optional<Met>& best, double t, Vec3 normal, std::uint32_t object) {
  if (t > 0.02 && (!best || t < best->t)) best = Met{t, normal, object};
}

void meet_sphere(
    std::optional<Met>& best, Eye eye, Vec3 d, Vec3 middle, double r, std::uint32_t id) {
  const Vec3 off = eye - middle;
  const double b = dot(off, d), root = b * b - dot(off, off) + r * r;
  if (root < 0) return;
  const double t = -b - std::sqrt(root);
  keep_nearest(best, t, normalized(off + d * t), id);
}

// Upright, from z0 to z1, caps included.
void meet_cylinder(std::optional<Met>& best,
                   Eye eye,
                   Vec3 d,
                   Vec3 middle,
                   double r,
                   double half,
                   std::uint32_t id) {
  const Vec3 off = eye - middle;
  const double a = d.x * d.x + d.y * d.y, b = off.x * d.x + off.y * d.y;
  const double root = b * b - a * (off.x * off.x + off.y * off.y - r * r);
  if (a > 0 && root >= 0) {
    const double t = (-b - std::sqrt(root)) / a;
    const Vec3 p = off + d * t;
    if (std::fabs(p.z) <= half) keep_nearest(best, t, {p.x / r, p.y / r, 0}, id);
  }
  for (const double z : {-half, half}) {
    const double t = (z - off.z) / d.z;
    const Vec3 p = off + d * t;
    if (p.x * p.x + p.y * p.y <= r * r) keep_nearest(best, t, {0, 0, z > 0 ? 1.0 : -1.0}, id);
  }
}

void meet_box(std::optional<Met>& best, Eye eye, Vec3 d, Vec3 low, Vec3 high, std::uint32_t id) {
  double enter = -1e30, leave = 1e30;
  Vec3 normal;
  const double o[3] = {eye.x, eye.y, eye.z}, v[3] = {d.x, d.y, d.z};
  const double l[3] = {low.x, low.y, low.z}, h[3] = {high.x, high.y, high.z};
  for (int axis = 0; axis < 3; ++axis) {
    const double t0 = (l[axis] - o[axis]) / v[axis], t1 = (h[axis] - o[axis]) / v[axis];
    if (std::min(t0, t1) > enter) {
      enter = std::min(t0, t1);
      normal = {axis == 0 ? -std::copysign(1.0, d.x) : 0,
                axis == 1 ? -std::copysign(1.0, d.y) : 0,
                axis == 2 ? -std::copysign(1.0, d.z) : 0};
    }
    leave = std::min(leave, std::max(t0, t1));
  }
  if (enter < leave) keep_nearest(best, enter, normal, id);
}

render::Actor ball(Vec3 middle, double radius) {
  constexpr int rings = 256, segments = 512;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = std::numbers::pi * (double(i) / rings - 0.5);
    const double r = i == 0 || i == rings ? 0 : radius * std::cos(angle);
    profile.push_back({static_cast<float>(r), static_cast<float>(radius * std::sin(angle)), 0});
  }
  render::ActorBody body;
  body.name = "ball";
  add_lathe(body.mesh, profile, segments);
  body.surfaces.push_back({});
  body.world_from_body.position = middle;
  return {"ball", {body}};
}

// A room of 6 x 6 x 3 m with a box, a drum and a ball in the air. The renderer's cylinders are
// prisms: the drum is a lathe as fine as the ball.
class Bodies {
 public:
  Bodies() {
    box_ = add_box_fixture(scene_, {2, 4.2F, 0}, {0, 0, 0.4F}, {0.3F, 0.35F, 0.4F});
    renderer_ = render::Renderer::create(scene_).value();
    const std::vector<render::Actor> actors{ball(sphere_middle, sphere_radius), drum()};
    EXPECT_TRUE(renderer_->set_actors(actors).ok());
  }

  render::Frame picture(const render::Camera& camera) const {
    return renderer_->render(camera, {}).value();
  }

  Met expected(Vec3 eye, Vec3 d) const {
    std::optional<Met> best;
    meet_box(best, eye, d, {1.7, 3.85, 0}, {2.3, 4.55, 0.8}, box_);
    const std::uint32_t first = render::first_actor_object(scene_);
    meet_sphere(best, eye, d, sphere_middle, sphere_radius, first);
    meet_cylinder(best, eye, d, drum_middle, drum_radius, drum_half, first + 1);
    keep_nearest(best, -eye.z / d.z, {0, 0, 1}, render::shell_object);
    keep_nearest(best, (6 - eye.y) / d.y, {0, -1, 0}, render::shell_object);
    keep_nearest(best, -eye.x / d.x, {1, 0, 0}, render::shell_object);
    keep_nearest(best, (6 - eye.x) / d.x, {-1, 0, 0}, render::shell_object);
    keep_nearest(best, -eye.y / d.y, {0, 1, 0}, render::shell_object);
    return *best;
  }

 private:
  static constexpr Vec3 sphere_middle{3.1, 3.6, 1.1}, drum_middle{3.8, 4.3, 0.6};
  static constexpr double sphere_radius = 0.3, drum_radius = 0.25, drum_half = 0.5;

  static render::Actor drum() {
    const auto r = static_cast<float>(drum_radius), h = static_cast<float>(drum_half);
    render::ActorBody body;
    body.name = "drum";
    add_lathe(body.mesh, {{0, -h, 0}, {r, -h, 0, true}, {r, h, 0, true}, {0, h, 0}}, 512);
    body.surfaces.push_back({});
    body.world_from_body.position = drum_middle;
    return {"drum", {body}};
  }

  scene::Scene scene_ = empty_room(6000, 6000, 3000);
  std::uint32_t box_ = 0;
  std::unique_ptr<render::Renderer> renderer_;
};

// The ideal direction of a pixel, by OpenCV's own fixed-point inverse of the distortion rather than
// by ours, in the camera's frame.
Vec3 direction_of(const render::Intrinsics& k, int x, int y) {
  const Vec2 seen{(x - k.cx) / k.fx, (y - k.cy) / k.fy};
  const render::LensDistortion& d = k.distortion;
  Vec2 p = seen;
  for (int i = 0; i < 200; ++i) {
    const double r2 = p.x * p.x + p.y * p.y;
    const double radial = 1 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
    const Vec2 tangential{2 * d.p1 * p.x * p.y + d.p2 * (r2 + 2 * p.x * p.x),
                          d.p1 * (r2 + 2 * p.y * p.y) + 2 * d.p2 * p.x * p.y};
    p = {(seen.x - tangential.x) / radial, (seen.y - tangential.y) / radial};
  }
  return {p.x, p.y, 1};
}

bool is_plain_around(
    const Bodies& bodies, const render::Camera& camera, const Pose& pose, int x, int y) {
  const render::Intrinsics k = render::intrinsics_of(camera);
  const auto met = [&](int px, int py) {
    return bodies.expected(pose.position,
                           normalized(rotate(pose.rotation, direction_of(k, px, py))));
  };
  const Met here = met(x, y);
  for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const Met beside = met(x + dx, y + dy);
    if (beside.object != here.object || dot(beside.normal, here.normal) < 0.8) return false;
  }
  return here.t > 0;
}

// Compares every third pixel that is not at an edge; returns how many there were.
int compare(const Bodies& bodies, const render::Camera& camera) {
  const render::Frame frame = bodies.picture(camera);
  const Pose pose = render::opencv_pose_of(camera);
  const render::Intrinsics k = render::intrinsics_of(camera);
  int compared = 0;
  for (int y = 1; y < camera.height - 1; y += 3) {
    for (int x = 1; x < camera.width - 1; x += 3) {
      const Vec3 d = normalized(rotate(pose.rotation, direction_of(k, x, y)));
      const Met met = bodies.expected(pose.position, d);
      if ((pose.position + d * met.t).z > 2.5) continue;  // lamps and signs hang there
      if (!is_plain_around(bodies, camera, pose, x, y)) continue;
      if (met.object == render::shell_object && (pose.position + d * met.t).z < 0.1) {
        if (met.normal.z == 0) continue;  // the skirting
      }
      const bool on_wall = met.object == render::shell_object && met.normal.z == 0;
      if (on_wall && (pose.position + d * met.t).z > 1.2) continue;  // posters hang there
      const auto i = static_cast<std::size_t>(y * camera.width + x);
      EXPECT_EQ(frame.instance[i], met.object) << x << "," << y;
      const double depth = dot(d, rotate(pose.rotation, {0, 0, 1})) * met.t;
      EXPECT_NEAR(frame.depth_m[i], depth, within_m) << x << "," << y << " of " << met.object;
      const Vec3 normal{frame.normals[3 * i], frame.normals[3 * i + 1], frame.normals[3 * i + 2]};
      EXPECT_GT(dot(normal, met.normal), 0.999) << x << "," << y << " of " << met.object;
      ++compared;
    }
  }
  return compared;
}

TEST(Analytic, APlainCameraSeesWhatTheFormulasSay) {
  const Bodies bodies;
  render::Camera camera;
  camera.from = {2.4, 1.2, 1.4};
  camera.at = {3, 4, 0.7};
  camera.width = 320, camera.height = 240;
  EXPECT_GT(compare(bodies, camera), 5000);
}

TEST(Analytic, SoDoesADistortedLensInAnyPose) {
  const Bodies bodies;
  render::Camera upright;
  upright.from = {2.4, 1.2, 1.4};
  upright.at = {3, 4, 0.7};
  const Pose rolled = render::opencv_pose_of(upright) * Pose{{}, rotation_about({0, 0, 1}, 0.6)};
  const render::Intrinsics lens{
      260.5, 255.25, 148.5, 131.75, {-0.28, 0.09, 0.0011, -0.0007, -0.013}};
  EXPECT_GT(compare(bodies, render::posed_camera("rolled", rolled, lens, 320, 240)), 5000);
  const render::Intrinsics pincushion{260.5, 255.25, 170, 110, {0.22, 0.05, -0.002, 0.001, 0.01}};
  EXPECT_GT(compare(bodies, render::posed_camera("rolled", rolled, pincushion, 320, 240)), 5000);
}

}  // namespace
}  // namespace marketgen
