#include "episodes/product_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "episodes/product_pictures_fingerprint.h"
#include "geometry/rotation_axes.h"
#include "render/catalogue_renderer.h"
#include "render/matter.h"
#include "render/picture_objects.h"
#include "scene/scene.h"

namespace marketgen::episodes {
namespace {

constexpr int stage_mm = 5000, stage_ceiling_mm = 3000;  // as episodes/checkout/checkout_view.cpp
constexpr double product_over_floor_m = 0.95;
constexpr float waiting_z_m = -10, waiting_apart_m = 2;
constexpr auto clear = static_cast<std::uint8_t>(render::Matter::clear);
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

Pose shown_at() {
  const double middle = stage_mm * 0.5e-3;
  return {{middle, middle, product_over_floor_m}, {}};
}

// All of them wait below the floor, where no light of the room falls on them.
scene::Scene picture_stage(std::span<const catalog::Product* const> products) {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = stage_mm;
  scene.layout.shell.ceiling_mm = stage_ceiling_mm;
  for (const catalog::Product* product : products) {
    scene::SceneProduct item;
    item.facing = ~0U;
    item.sku = static_cast<std::uint32_t>(scene.catalog.size());
    item.position_m = {waiting_apart_m * static_cast<float>(item.sku), 0, waiting_z_m};
    scene.products.push_back(item);
    scene.catalog.push_back(*product);
  }
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

// Of the scene's product of that number, which stands there.
Result<agent::ProductPictures> pictures_of(render::Renderer& renderer,
                                           const catalog::Product& product,
                                           std::uint32_t shown) {
  const Vec3 size{product.width_m(), product.depth_m(), product.height_m()};
  agent::ProductPictures pictures;
  for (const Side& side : picture_sides) {
    agent::ProductPicture picture;
    picture.product_from_camera = {Vec3{0, 0, size.z / 2} + side.towards * away_m,
                                   rotation_with_axes(side.down, -side.towards)};
    picture.pixel_m = pixel_m;
    const render::Camera camera = side_camera(shown_at() * picture.product_from_camera,
                                              pixels_of(size, cross(side.down, side.towards)),
                                              pixels_of(size, side.down));
    MARKETGEN_TRY(render::Frame frame, renderer.render(camera, {}));
    for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
      if (frame.instance[i] != shown) frame.depth_m[i] = 0;
      picture.clear.push_back(frame.matter[i] == clear ? 1 : 0);
    }
    picture.color = std::move(frame.color);
    picture.depth_m = std::move(frame.depth_m);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace

Result<std::vector<agent::ProductPictures>> product_pictures(
    std::span<const catalog::Product* const> products) {
  const scene::Scene scene = picture_stage(products);
  MARKETGEN_TRY(const std::unique_ptr<render::Renderer> renderer,
                render::create_catalogue_renderer(scene));
  const std::uint32_t first = render::first_product_object(scene);
  std::vector<agent::ProductPictures> all;
  for (std::uint32_t i = 0; i < products.size(); ++i) {
    const render::MovedProduct here{i, shown_at()};
    MARKETGEN_CHECK(renderer->move_things({&here, 1}, {}));
    MARKETGEN_TRY(all.emplace_back(), pictures_of(*renderer, *products[i], first + i));
  }
  return all;
}

std::string product_pictures_key() {
  return fmt::format("{} {}", render::drawing_key(), product_pictures_fingerprint);
}

}  // namespace marketgen::episodes
