#include "render/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/picture_grid.h"
#include "render/render.h"

namespace marketgen::render {
namespace {

constexpr int product_room_mm = 9000;   // a bright empty room round the product
constexpr double product_fov_deg = 22;  // little perspective

// A scene with one product in the middle of an empty room, on a white block at hand height.
scene::Scene stage_for(const catalog::Product& product) {
  scene::Scene scene;
  scene.layout.shell.width_mm = scene.layout.shell.depth_mm = product_room_mm;
  scene.layout.shell.ceiling_mm = 3000;
  scene.layout.look.floor = scene.layout.look.wall = scene.layout.look.ceiling = "";
  scene.layout.look.light_lux = 1400;
  scene.catalog.push_back(product);
  scene::SceneProduct item;
  item.facing = 0;
  const double middle = product_room_mm * 0.5e-3;
  item.position_m = {static_cast<float>(middle), static_cast<float>(middle), 0.0F};
  scene.products.push_back(item);
  return scene;
}

// From where a shopper would look: more from above the flatter the product is, and nearly from the
// front when it is as deep as wide, since a round pack has its print there.
Vec3 view_of(const catalog::Product& product) {
  const double flatness = 1 - product.height_m() / (0.6 * product.depth_m());
  const double ratio = product.depth_m() / product.width_m();
  const bool maybe_round = ratio > 0.95 && ratio < 1.05;
  return normalized(
      Vec3{maybe_round ? 0.08 : 0.45, -1.0, 0.42 + 0.7 * std::clamp(flatness, 0.0, 1.0)});
}

// The product's box fills the picture but for a border.
Camera camera_for(const catalog::Product& product, int size_px) {
  constexpr double filled = 0.86;  // of the picture's side
  const double middle = product_room_mm * 0.5e-3;
  const Vec3 at{middle, middle, product.height_m() / 2};
  const Vec3 view = view_of(product);
  const Vec3 right = normalized(cross({0, 0, 1}, view)), up = cross(view, right);
  const double slope = filled * std::tan(product_fov_deg / 2 * std::numbers::pi / 180);
  double distance = 0;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        const Vec3 corner{x * product.width_m(), y * product.depth_m(), z * product.height_m()};
        const double aside = std::max(std::abs(dot(corner, right)), std::abs(dot(corner, up)));
        distance = std::max(distance, aside / slope + dot(corner, view));
      }
    }
  }
  return {"product", at + view * distance, at, product_fov_deg, 0, size_px, size_px};
}

}  // namespace

Result<Image> draw_product(const catalog::Product& product, int size_px) {
  const scene::Scene scene = stage_for(product);
  MARKETGEN_TRY(const std::unique_ptr<Renderer> renderer, Renderer::create(scene));
  RenderOptions options;
  options.quality = Quality::best;
  MARKETGEN_TRY(Frame frame, renderer->render(camera_for(product, size_px), options));
  return std::move(frame.color);
}

Result<Image> draw_contact_sheet(const std::vector<catalog::Product>& products, int size_px) {
  return picture_grid(
      products.size(), size_px, [&](std::size_t i) { return draw_product(products[i], size_px); });
}

}  // namespace marketgen::render
