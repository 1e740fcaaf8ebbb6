#include <algorithm>

#include "assets/archetypes/collision.h"
#include "assets/archetypes/panel_box.h"
#include "assets/archetypes/registry.h"
#include "assets/archetypes/surfaces.h"

namespace marketgen {
namespace {

// Built as a rounded box that is then squeezed: the lower rounding becomes the foot, the straight
// wall the tapered side, the upper rounding the flange with the film.
constexpr float tray_foot = 0.25F, tray_flange = 0.75F;  // shares of the rounded box's height
constexpr float tray_under_flange = 0.71F;               // where the wall steps out to the flange
constexpr float foot_high = 0.16F, flange_low = 0.78F,
                flange_high = 0.82F;                     // shares of the tray's height
constexpr float foot_scale = 0.86F, wall_scale = 0.93F;  // of the footprint

float squeezed_height(float t) {
  if (t <= tray_foot) return foot_high * t / tray_foot;
  if (t <= tray_flange)
    return foot_high + (flange_low - foot_high) * (t - tray_foot) / (tray_flange - tray_foot);
  return flange_low + (flange_high - flange_low) * (t - tray_flange) / (1 - tray_flange);
}

float footprint_scale(float t) {
  if (t >= tray_flange) return 1;
  if (t >= tray_under_flange) {
    return wall_scale +
           (1 - wall_scale) * (t - tray_under_flange) / (tray_flange - tray_under_flange);
  }
  return foot_scale + (wall_scale - foot_scale) * std::max(0.0F, t - tray_foot) /
                          (tray_under_flange - tray_foot);
}

// The film's rise over the contents, 0 at the flange.
float film_dome(Vec3f share) {
  const auto hump = [](float s) {
    const float square = (2 * s - 1) * (2 * s - 1);
    return std::max(0.0F, 1 - square * square * 1.2F);
  };
  return share.z >= 1 ? hump(share.x) * hump(share.y) : 0;
}

Vec3f tray_point(Vec3f share, Vec3f size, float radius) {
  const float straight = 4 * radius;
  const Vec3f p = rounded_box_point(share, {size.x, size.y, straight}, radius);
  const float t = p.z / straight;
  const float scale = footprint_scale(t);
  const float z = squeezed_height(t) + (1 - flange_high) * film_dome(share);
  return {p.x * scale, p.y * scale, z * size.z};
}

}  // namespace

Result<ProductModel> make_tray(const Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t body = pack.add_surface(plastic(colors.secondary));
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  const float radius = std::min({0.018F, 0.2F * size.x, 0.2F * size.y});

  const BoxGrid grid{rounded_lines(size.x, radius, 2, 6),
                     rounded_lines(size.y, radius, 2, 4),
                     {0, 0.146F, tray_foot, tray_under_flange, tray_flange, 0.854F, 1}};
  add_panel_box(pack, grid, {print, body, body, body, print, body}, [&](Vec3f share) {
    return tray_point(share, size, radius);
  });
  return pack.finish();
}

CollisionPrimitive collision_tray(const Product& product) {
  return box_around(product);
}

}  // namespace marketgen
