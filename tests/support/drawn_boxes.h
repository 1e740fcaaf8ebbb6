// Pictures with depth of plain boxes, drawn by intersecting rays with them: known answers for
// perception.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "agent/eyes.h"
#include "agent/known_products.h"
#include "geometry/rotation_axes.h"

namespace marketgen {

// A box that stands on its frame's origin, as products do; a colour a side (+x -x +y -y +z -z).
struct DrawnBox {
  Pose pose;
  Vec3 size;
  std::array<Rgb8, 6> colors{};
};

struct DrawnHit {
  double distance = std::numeric_limits<double>::infinity();
  int box = -1, side = 0;
};

inline DrawnHit first_box(const std::vector<DrawnBox>& boxes, Vec3 origin, Vec3 direction) {
  DrawnHit best;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Pose back = inverse(boxes[b].pose);
    const Vec3 o = back * origin - Vec3{0, 0, boxes[b].size.z / 2};
    const Vec3 d = rotate(back.rotation, direction), h = boxes[b].size * 0.5;
    const std::array<double, 3> from{o.x, o.y, o.z}, way{d.x, d.y, d.z}, half{h.x, h.y, h.z};
    double enter = 0, leave = 1e9;
    int side = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(way[axis]) < 1e-12) {
        if (std::abs(from[axis]) > half[axis]) leave = -1;
        continue;
      }
      const double sign = way[axis] > 0 ? 1 : -1;
      const double in = (-sign * half[axis] - from[axis]) / way[axis];
      if (in > enter) {
        enter = in;
        side = static_cast<int>(axis) * 2 + (sign > 0 ? 1 : 0);
      }
      leave = std::min(leave, (sign * half[axis] - from[axis]) / way[axis]);
    }
    if (enter > 1e-6 && enter < leave && enter < best.distance)
      best = {enter, static_cast<int>(b), side};
  }
  return best;
}

// What a pinhole sees of the boxes; `shown` gets the box of each pixel, -1 for none.
inline agent::View drawn_view(const std::vector<DrawnBox>& boxes,
                              const Pose& base_from_camera,
                              int width,
                              int height,
                              double focal_px,
                              std::vector<int>* shown = nullptr) {
  agent::View view;
  view.camera = "drawn";
  view.lens = {focal_px, focal_px, (width - 1) / 2.0, (height - 1) / 2.0};
  view.base_from_camera = base_from_camera;
  view.color = Image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 ray{(x - view.lens.cx) / focal_px, (y - view.lens.cy) / focal_px, 1};
      const DrawnHit hit =
          first_box(boxes, base_from_camera.position, rotate(base_from_camera.rotation, ray));
      view.depth_m.push_back(hit.box < 0 ? 0.0F : static_cast<float>(hit.distance));
      if (shown != nullptr) shown->push_back(hit.box);
      if (hit.box < 0) continue;
      const Rgb8 color =
          boxes[static_cast<std::size_t>(hit.box)].colors[static_cast<std::size_t>(hit.side)];
      std::copy_n(std::array{color.r, color.g, color.b}.begin(), 3, view.color.at(x, y));
    }
  }
  return view;
}

// Straight down from a height over a point.
inline Pose camera_over(Vec3 at) {
  return {at, rotation_with_axes({0, -1, 0}, {0, 0, -1})};
}

// The six pictures of a box of a size, as a catalogue has them.
inline std::vector<agent::ProductPicture> drawn_pictures(Vec3 size,
                                                         const std::array<Rgb8, 6>& colors) {
  const std::vector<DrawnBox> boxes{{{}, size, colors}};
  std::vector<agent::ProductPicture> pictures;
  for (const auto& [towards, down] : {std::pair{Vec3{1, 0, 0}, Vec3{0, 0, -1}},
                                      {{-1, 0, 0}, {0, 0, -1}},
                                      {{0, 1, 0}, {0, 0, -1}},
                                      {{0, -1, 0}, {0, 0, -1}},
                                      {{0, 0, 1}, {0, -1, 0}},
                                      {{0, 0, -1}, {0, 1, 0}}}) {
    agent::ProductPicture picture;
    picture.pixel_m = 0.001;
    picture.product_from_camera = {Vec3{0, 0, size.z / 2} + towards * 0.5,
                                   rotation_with_axes(down, -towards)};
    const int pixels = static_cast<int>(length(size) * 1000);
    picture.color = Image(pixels, pixels);
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        const Vec3 from{(x - (pixels - 1) / 2.0) * 0.001, (y - (pixels - 1) / 2.0) * 0.001, 0};
        const Pose& camera = picture.product_from_camera;
        const DrawnHit hit = first_box(boxes, camera * from, rotate(camera.rotation, {0, 0, 1}));
        picture.depth_m.push_back(hit.box < 0 ? 0.0F : static_cast<float>(hit.distance));
        if (hit.box < 0) continue;
        const Rgb8 color = colors[static_cast<std::size_t>(hit.side)];
        std::copy_n(std::array{color.r, color.g, color.b}.begin(), 3, picture.color.at(x, y));
      }
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

inline std::array<Rgb8, 6> plain(Rgb8 color) {
  std::array<Rgb8, 6> colors;
  colors.fill(color);
  return colors;
}

}  // namespace marketgen
