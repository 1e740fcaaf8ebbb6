#include "render/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "render/picture_grid.h"
#include "render/render.h"

namespace marketgen {
namespace {

constexpr int room_mm = 4000;           // a bright empty room round the product
constexpr double product_fov_deg = 22;  // little perspective

// A scene with one product in the middle of an empty room, on a white block at hand height.
Scene stage_for(const Product& product) {
  Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = room_mm;
  scene.layout.shell.ceiling_mm = 3000;
  scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
  scene.layout.look.light_lux = 1000;
  scene.catalog.push_back(product);
  SceneProduct item;
  item.facing = 0;
  const double middle = room_mm * 0.5e-3;
  item.position_m = {static_cast<float>(middle), static_cast<float>(middle), 0.0F};
  scene.products.push_back(item);
  return scene;
}

Camera camera_for(const Product& product, int size_px) {
  const double middle = room_mm * 0.5e-3;
  const double radius = 0.5 * std::sqrt(product.width_m() * product.width_m() +
                                        product.depth_m() * product.depth_m() +
                                        product.height_m() * product.height_m());
  const double distance = 1.12 * radius / std::sin(product_fov_deg / 2 * 3.14159265358979 / 180);
  const Vec3 at{middle, middle, product.height_m() / 2};
  const Vec3 direction = normalized(Vec3{0.45, -1.0, 0.42});
  return {"product", at + direction * distance, at, product_fov_deg, 0, size_px, size_px};
}

}  // namespace

Result<Image> draw_product(const Product& product, int size_px) {
  const Scene scene = stage_for(product);
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(scene));
  RenderOptions options;
  options.quality = Quality::best;
  MARKETGEN_TRY(Frame frame, renderer->render(camera_for(product, size_px), options));
  return std::move(frame.color);
}

Result<Image> draw_contact_sheet(const std::vector<Product>& products, int size_px) {
  return picture_grid(
      products.size(), size_px, [&](std::size_t i) { return draw_product(products[i], size_px); });
}

}  // namespace marketgen
