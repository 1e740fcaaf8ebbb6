#include "physics/settle/bulk_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/box_extents.h"
#include "physics/goods/spec_geoms.h"

namespace marketgen::physics {
namespace {

// The wall towards +X of a container that measures `x` across and `y` along it.
ContainerBox wall_ahead(const OpenContainer& c, double x, double y) {
  const double slant = std::hypot(c.taper_m, c.height_m);
  const Quaternion leaning = rotation_about({0, 1, 0}, std::atan2(c.taper_m, c.height_m));
  const Vec3 inner{(x - c.taper_m) / 2, 0, c.height_m / 2};
  return {{inner + rotate(leaning, {c.wall_m / 2, 0, 0}), leaning},
          {c.wall_m / 2, y / 2 + c.wall_m, slant / 2}};
}

ContainerBox ledge_ahead(const OpenContainer& c, double x, double y) {
  return {{{x / 2 - c.taper_m - c.ledge_width_m / 2, 0, c.ledge_height_m / 2}, {}},
          {c.ledge_width_m / 2, y / 2 - c.taper_m, c.ledge_height_m / 2}};
}

}  // namespace

std::vector<ContainerBox> boxes_of(const OpenContainer& c) {
  std::vector<ContainerBox> boxes;
  for (int turns = 0; turns < 4; ++turns) {
    const bool across = turns % 2 != 0;
    const double x = across ? c.top_y_m : c.top_x_m, y = across ? c.top_x_m : c.top_y_m;
    const Pose turned{{}, yaw_from_quarter_turns(turns)};
    const auto add = [&](const ContainerBox& box) {
      boxes.push_back({turned * box.container_from_box, box.half_size});
    };
    add(wall_ahead(c, x, y));
    if (c.ledge_width_m > 0 && c.ledge_height_m > 0) add(ledge_ahead(c, x, y));
  }
  return boxes;
}

bool fits_in(const OpenContainer& c, const catalog::Product& product) {
  std::array<double, 3> pack{product.width_m(), product.depth_m(), product.height_m()};
  std::ranges::sort(pack);
  const double in = 2 * c.taper_m;
  return pack[0] <= c.height_m && pack[1] <= std::min(c.top_x_m, c.top_y_m) - in &&
         pack[2] <= std::max(c.top_x_m, c.top_y_m) - in;
}

std::vector<mjsGeom*> add_container(mjsBody* world, const OpenContainer& container) {
  std::vector<mjsGeom*> geoms{add_floor(world)};
  for (const ContainerBox& box : boxes_of(container))
    geoms.push_back(
        add_shape(world, {assets::CollisionShape::box, box.container_from_box, box.half_size}));
  return geoms;
}

Result<void> check_container(const OpenContainer& c) {
  const bool positive = c.top_x_m > 0 && c.top_y_m > 0 && c.height_m > 0 && c.wall_m > 0 &&
                        c.taper_m >= 0 && c.ledge_width_m >= 0 && c.ledge_height_m >= 0;
  const bool finite = std::isfinite(c.top_x_m + c.top_y_m + c.height_m + c.wall_m + c.taper_m +
                                    c.ledge_width_m + c.ledge_height_m);
  const double narrow = std::min(c.top_x_m, c.top_y_m) - 2 * (c.taper_m + c.ledge_width_m);
  if (positive && finite && narrow > 0) return {};
  return Error{"physics.bad_command",
               "container",
               fmt::format("expected finite sizes greater than 0 and room between walls and "
                           "ledges, not {} x {} m, {} m high, taper {} m, wall {} m, ledge {} x {} "
                           "m",
                           c.top_x_m,
                           c.top_y_m,
                           c.height_m,
                           c.taper_m,
                           c.wall_m,
                           c.ledge_width_m,
                           c.ledge_height_m)};
}

Vec3 turned_half_extents(const catalog::Product& product, const Quaternion& rotation) {
  return box_half_extents(rotation,
                          {product.width_m() / 2, product.depth_m() / 2, product.height_m() / 2});
}

}  // namespace marketgen::physics
