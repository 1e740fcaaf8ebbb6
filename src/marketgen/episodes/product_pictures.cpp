#include "episodes/product_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/rotation_axes.h"
#include "render/picture_objects.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen::episodes {
namespace {

constexpr int stage_mm = 5000, stage_ceiling_mm = 3000;  // as episodes/checkout/checkout_view.cpp
constexpr float product_over_floor_m = 0.95F;
constexpr double pixel_m = 0.001, border_m = 0.004, away_m = 0.6;

struct Side {
  Vec3 towards;  // from the product to the camera
  Vec3 down;     // of the picture
};
constexpr std::array<Side, 6> picture_sides{{{{0, -1, 0}, {0, 0, -1}},
                                             {{0, 1, 0}, {0, 0, -1}},
                                             {{1, 0, 0}, {0, 0, -1}},
                                             {{-1, 0, 0}, {0, 0, -1}},
                                             {{0, 0, 1}, {0, -1, 0}},
                                             {{0, 0, -1}, {0, 1, 0}}}};

scene::Scene picture_stage(const catalog::Product& product) {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = stage_mm;
  scene.layout.shell.ceiling_mm = stage_ceiling_mm;
  scene.catalog.push_back(product);
  scene::SceneProduct item;
  item.facing = ~0U;
  const float middle = stage_mm * 0.5e-3F;
  item.position_m = {middle, middle, product_over_floor_m};
  scene.products.push_back(item);
  return scene;
}

render::Camera side_camera(const Pose& world_from_camera, int width, int height) {
  render::Camera camera;
  camera.name = "product";
  camera.width = width;
  camera.height = height;
  camera.ortho_height_m = height * pixel_m;
  camera.world_from_camera = world_from_camera;
  return camera;
}

int pixels_of(Vec3 size, Vec3 along) {
  const double length = std::abs(dot(size, along));
  return static_cast<int>(std::ceil((length + 2 * border_m) / pixel_m));
}

}  // namespace

Result<std::vector<agent::ProductPicture>> product_pictures(const catalog::Product& product) {
  const scene::Scene scene = picture_stage(product);
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer, render::Renderer::create(scene));
  const auto& at = scene.products.front().position_m;
  const Pose world_from_product{{at[0], at[1], at[2]}, {}};
  const Vec3 size{product.width_m(), product.depth_m(), product.height_m()};
  const std::uint32_t shown = render::first_product_object(scene);
  std::vector<agent::ProductPicture> pictures;
  for (const Side& side : picture_sides) {
    agent::ProductPicture picture;
    picture.product_from_camera = {Vec3{0, 0, size.z / 2} + side.towards * away_m,
                                   rotation_with_axes(side.down, -side.towards)};
    picture.pixel_m = pixel_m;
    const render::Camera camera = side_camera(world_from_product * picture.product_from_camera,
                                              pixels_of(size, cross(side.down, side.towards)),
                                              pixels_of(size, side.down));
    MARKETGEN_TRY(render::Frame frame, renderer->render(camera, {}));
    for (std::size_t i = 0; i < frame.depth_m.size(); ++i)
      if (frame.instance[i] != shown) frame.depth_m[i] = 0;
    picture.color = std::move(frame.color);
    picture.depth_m = std::move(frame.depth_m);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace marketgen::episodes
