#include "assets/shapes/archetypes/tray_parts.h"

#include <algorithm>

namespace marketgen::assets {
namespace {

// Built as a rounded box that is then squeezed: the lower rounding becomes the foot, the straight
// wall the tapered side, the upper rounding the flange with the film.
//
// Shares of the rounded box's height, nearly those of the tray: what is printed on its front is not
// stretched.
constexpr float tray_foot = 0.14F, tray_flange = 0.86F;
constexpr float tray_under_flange = 0.83F;  // where the wall steps out to the flange
constexpr float mid_rounding = 0.146F / 0.25F * tray_foot;  // half way around an edge

float squeezed_height(const TrayForm& form, float t) {
  if (t <= tray_foot) return form.foot_high * t / tray_foot;
  if (t <= tray_flange) {
    return form.foot_high +
           (form.flange_low - form.foot_high) * (t - tray_foot) / (tray_flange - tray_foot);
  }
  return form.flange_low +
         (form.flange_high - form.flange_low) * (t - tray_flange) / (1 - tray_flange);
}

float footprint_scale(const TrayForm& form, float t) {
  if (t >= tray_flange) return 1;
  if (t >= tray_under_flange) {
    return form.wall_scale +
           (1 - form.wall_scale) * (t - tray_under_flange) / (tray_flange - tray_under_flange);
  }
  return form.foot_scale + (form.wall_scale - form.foot_scale) * std::max(0.0F, t - tray_foot) /
                               (tray_under_flange - tray_foot);
}

// The film's rise over the contents, 0 at the flange.
float film_dome(const TrayForm& form, Vec3f share) {
  const auto hump = [&](float s) {
    const float square = (2 * s - 1) * (2 * s - 1);
    return std::max(0.0F, 1 - square * square * form.dome_flat);
  };
  return share.z >= 1 ? hump(share.x) * hump(share.y) : 0;
}

Vec3f tray_point(const TrayForm& form, Vec3f share, Vec3f size, float radius) {
  const float straight = radius / tray_foot;
  const Vec3f p = rounded_box_point(share, {size.x, size.y, straight}, radius);
  const float t = p.z / straight;
  const float scale = footprint_scale(form, t);
  const float z = squeezed_height(form, t) + (1 - form.flange_high) * film_dome(form, share);
  return {p.x * scale, p.y * scale, z * size.z};
}

}  // namespace

void add_tray(PackBuilder& pack, const TrayForm& form, std::uint16_t print, std::uint16_t body) {
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  const float radius = std::min({form.greatest_corner_m, 0.2F * size.x, 0.2F * size.y});
  const BoxGrid grid{
      rounded_lines(size.x, radius, 2, 6),
      rounded_lines(size.y, radius, 2, 4),
      {0, mid_rounding, tray_foot, tray_under_flange, tray_flange, 1 - mid_rounding, 1}};
  add_panel_box(pack, grid, {print, body, body, body, print, body}, [&](Vec3f share) {
    return tray_point(form, share, size, radius);
  });
}

}  // namespace marketgen::assets
