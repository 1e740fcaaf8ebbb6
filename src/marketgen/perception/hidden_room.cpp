#include "perception/hidden_room.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::perception {
namespace {

constexpr double every_m = 0.008;             // along a solid
constexpr std::array across{-0.8, 0.0, 0.8};  // shares of its half width and depth
constexpr float measured_within_m = 0.004F;

// Where nothing is measured nothing is known.
bool is_hidden(const std::vector<ViewCloud>& views, Vec3f point) {
  return std::ranges::none_of(views, [&](const ViewCloud& view) {
    const auto seen = view.project(point);
    return seen && view.has(seen->pixel) &&
           view.view().depth_m[seen->pixel] > seen->depth_m - measured_within_m;
  });
}

}  // namespace

double hidden_length_m(const std::vector<robots::ToolSolid>& solids,
                       const Pose& base_from_tip,
                       const SeenIn& seen_in) {
  if (seen_in.views == nullptr) return 0;
  const Pose views_from_tip = inverse(seen_in.base_from_views) * base_from_tip;
  double hidden_m = 0;
  for (const robots::ToolSolid& solid : solids) {
    const Pose views_from_solid = views_from_tip * solid.tool_from_solid;
    const Vec3 half = solid.half_size;
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * half.z / every_m)));
    int hidden = 0;
    for (int i = 0; i < steps; ++i)
      for (const double x : across)
        for (const double y : across)
          if (is_hidden(
                  *seen_in.views,
                  to_float(views_from_solid *
                           Vec3{x * half.x, y * half.y, half.z * ((2 * i + 1.0) / steps - 1)})))
            ++hidden;
    hidden_m += 2 * half.z * hidden / (steps * static_cast<int>(across.size() * across.size()));
  }
  return hidden_m;
}

}  // namespace marketgen::perception
