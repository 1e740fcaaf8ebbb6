#include "export/coco_panels.h"

#include <algorithm>
#include <cmath>

#include "render/price_tags.h"
#include "scene/price_tags.h"
#include "scene/shelf_fill.h"

namespace marketgen::exporters {
namespace {

constexpr double min_panel_depth_m = 0.05;  // of a corner before the camera
constexpr double tag_depth_m = render::price_tag_lift_m / 2;
constexpr double gap_depth_m = 5e-3;  // a front board's lip is no thing that stands in a gap

// A panel in the camera's frame.
class SeenPanel {
 public:
  SeenPanel(const ShelfPanel& panel, const render::Camera& camera)
      : k_(render::intrinsics_of(camera)), panel_(panel) {
    const Pose seen = inverse(render::opencv_pose_of(camera)) * panel.world_from_panel;
    middle_ = seen.position;
    right_ = rotate(seen.rotation, {1, 0, 0});
    up_ = rotate(seen.rotation, {0, 0, 1});
    back_ = rotate(seen.rotation, {0, 1, 0});
  }

  // x0, y0, x1, y1 of the pixels that it may cover; nothing behind the camera or beside the
  // picture.
  std::optional<std::array<int, 4>> box(int width, int height) const {
    if (dot(back_, middle_) <= 0) return std::nullopt;  // it turns its back
    std::array<double, 4> box{1e9, 1e9, -1e9, -1e9};
    for (const double x : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        const Vec3 corner = middle_ + right_ * (x * panel_.width_m) + up_ * (z * panel_.height_m);
        if (corner.z < min_panel_depth_m) return std::nullopt;
        const double px = k_.cx + k_.fx * corner.x / corner.z;
        const double py = k_.cy + k_.fy * corner.y / corner.z;
        box = {
            std::min(box[0], px), std::min(box[1], py), std::max(box[2], px), std::max(box[3], py)};
      }
    }
    if (box[2] < 0 || box[3] < 0 || box[0] > width - 1 || box[1] > height - 1) return std::nullopt;
    const auto pixel = [](double at, int size) {
      return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(size)));
    };
    return std::array<int, 4>{pixel(std::floor(box[0]), width),
                              pixel(std::floor(box[1]), height),
                              pixel(std::ceil(box[2]) + 1, width),
                              pixel(std::ceil(box[3]) + 1, height)};
  }

  // Depth of the panel at the centre of a pixel; nothing where it is not.
  std::optional<double> depth_at(int x, int y) const {
    const Vec3 ray{(x - k_.cx) / k_.fx, (y - k_.cy) / k_.fy, 1};
    const double depth = dot(back_, middle_) / dot(back_, ray);
    const Vec3 off = ray * depth - middle_;
    if (depth <= 0 || std::abs(dot(off, right_)) > panel_.width_m / 2 ||
        std::abs(dot(off, up_)) > panel_.height_m / 2)
      return std::nullopt;
    return depth;
  }

 private:
  render::Intrinsics k_;
  const ShelfPanel& panel_;
  Vec3 middle_, right_, up_, back_;
};

// `shows(pixel, depth)`: whether the picture shows the panel there, whose depth it is.
template <class Shows>
PanelView view_of(const ShelfPanel& panel,
                  const render::Camera& camera,
                  const render::Frame& frame,
                  const Shows& shows) {
  const SeenPanel seen(panel, camera);
  PanelView view;
  const int width = frame.color.width, height = frame.color.height;
  const auto box = seen.box(width, height);
  if (!box) return view;
  view.box = {width, height, 0, 0};
  for (int x = (*box)[0]; x < (*box)[2]; ++x) {
    for (int y = (*box)[1]; y < (*box)[3]; ++y) {
      const auto depth = seen.depth_at(x, y);
      if (!depth) continue;
      ++view.alone;
      if (!shows(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x),
                 *depth))
        continue;
      view.pixels.push_back(static_cast<std::uint32_t>(x * height + y));
      view.box = {std::min(view.box[0], x),
                  std::min(view.box[1], y),
                  std::max(view.box[2], x + 1),
                  std::max(view.box[3], y + 1)};
    }
  }
  return view;
}

// The front of part of a block: from `left_m` on the shelf, from its left end.
ShelfPanel front_panel(const scene::Scene& scene,
                       std::uint32_t row,
                       double left_m,
                       double width_m,
                       std::optional<int> column) {
  const scene::Facing& facing = scene.facings[row];
  const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
  const double height_m = std::min<double>(
      scene.catalog[facing.sku].height_m() * std::max<int>(1, facing.stack), shelf.clearance_m);
  const Vec3 middle{
      left_m + width_m / 2 - shelf.width_m / 2.0, assets::goods_front_m, height_m / 2};
  return {scene::world_from_shelf(scene, facing.shelf) * Pose{middle, {}},
          width_m,
          height_m,
          row,
          0,
          column};
}

// Which columns of the block have an item.
std::vector<bool> taken_columns(const scene::Scene& scene, const scene::Facing& facing) {
  std::vector<bool> taken(facing.facings, false);
  const Pose shelf_from_world = inverse(scene::world_from_shelf(scene, facing.shelf));
  const double left_m = facing.x_m - scene.shelves[facing.shelf].width_m / 2.0;
  for (std::uint32_t i = 0; i < facing.product_count; ++i) {
    const Vec3 at = shelf_from_world *
                    scene::world_from_product(scene.products[facing.first_product + i]).position;
    const double column = std::floor((at.x - left_m) / facing.width_m * facing.facings);
    taken[static_cast<std::size_t>(std::clamp(column, 0.0, facing.facings - 1.0))] = true;
  }
  return taken;
}

}  // namespace

std::vector<ShelfPanel> price_tag_panels(const scene::Scene& scene) {
  std::vector<ShelfPanel> panels;
  for (std::uint32_t row = 0; row < scene.price_labels.size(); ++row) {
    const scene::PriceLabel& label = scene.price_labels[row];
    const Vec3 middle = to_double(render::price_tag_place(scene, label));
    panels.push_back({scene::world_from_shelf(scene, label.shelf) * Pose{middle, {}},
                      label.width_m,
                      label.height_m,
                      label.facing,
                      row,
                      {}});
  }
  return panels;
}

std::vector<ShelfPanel> missing_tag_panels(const scene::Scene& scene) {
  std::vector<bool> has_tag(scene.facings.size(), false);
  for (const scene::PriceLabel& label : scene.price_labels)
    has_tag[label.facing] = true;
  std::vector<ShelfPanel> panels;
  for (std::uint32_t row = 0; row < scene.facings.size(); ++row) {
    const scene::Facing& facing = scene.facings[row];
    if (has_tag[row] || facing.width_m <= 0 || scene.shelves[facing.shelf].price_rail == 0)
      continue;
    const scene::PriceLabel tag = scene::tag_before_block(facing.shelf, facing.x_m, facing.width_m);
    Vec3 middle = to_double(render::price_tag_place(scene, tag));
    middle.y += static_cast<double>(render::price_tag_lift_m);
    panels.push_back({scene::world_from_shelf(scene, facing.shelf) * Pose{middle, {}},
                      tag.width_m,
                      tag.height_m,
                      row,
                      0,
                      {}});
  }
  return panels;
}

std::vector<ShelfPanel> gap_panels(const scene::Scene& scene) {
  std::vector<ShelfPanel> panels;
  for (std::uint32_t row = 0; row < scene.facings.size(); ++row) {
    const scene::Facing& facing = scene.facings[row];
    if (facing.width_m <= 0 || facing.facings == 0) continue;
    const bool loose = scene.shelves[facing.shelf].use == assets::ShelfUse::heap ||
                       scene::lies_in_a_heap(scene.catalog[facing.sku]);
    if (loose) {
      if (facing.product_count == 0)
        panels.push_back(front_panel(scene, row, facing.x_m, facing.width_m, {}));
      continue;
    }
    const std::vector<bool> taken = taken_columns(scene, facing);
    const double width_m = static_cast<double>(facing.width_m) / facing.facings;
    for (int column = 0; column < facing.facings; ++column) {
      if (!taken[static_cast<std::size_t>(column)])
        panels.push_back(front_panel(scene, row, facing.x_m + column * width_m, width_m, column));
    }
  }
  return panels;
}

PanelView view_of_tag(const ShelfPanel& tag,
                      std::uint32_t fixture_object,
                      const render::Camera& camera,
                      const render::Frame& frame) {
  return view_of(tag, camera, frame, [&](std::size_t pixel, double depth) {
    return frame.instance[pixel] == fixture_object &&
           std::abs(static_cast<double>(frame.depth_m[pixel]) - depth) < tag_depth_m;
  });
}

PanelView view_of_gap(const ShelfPanel& gap,
                      const render::Camera& camera,
                      const render::Frame& frame) {
  return view_of(gap, camera, frame, [&](std::size_t pixel, double depth) {
    const auto met = static_cast<double>(frame.depth_m[pixel]);
    return met == 0 || met > depth - gap_depth_m;
  });
}

}  // namespace marketgen::exporters
