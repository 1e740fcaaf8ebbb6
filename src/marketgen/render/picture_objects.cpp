#include "render/picture_objects.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace marketgen {
namespace {

PictureObject described(std::uint32_t id,
                        const Scene& scene,
                        std::span<const std::string> actor_names) {
  PictureObject object;
  object.id = id;
  const auto [r, g, b] = object_color(id);
  object.color = fmt::format("#{:02x}{:02x}{:02x}", r, g, b);
  if (id >= first_actor_object(scene)) {
    object.kind = ObjectKind::actor;
    object.name = actor_names[id - first_actor_object(scene)];
  } else if (id >= first_product_object(scene)) {
    const std::uint32_t row = id - first_product_object(scene);
    object.kind = ObjectKind::product;
    object.name = product_id(scene, row);
    object.sku = scene.catalog[scene.products[row].sku].sku;
  } else if (id >= first_fixture_object) {
    object.kind = ObjectKind::fixture;
    object.name = scene.layout.fixtures[id - first_fixture_object].id;
  } else {
    object.name = "shell";
  }
  return object;
}

void include_pixel(PictureObject& object, int x, int y) {
  auto& [x0, y0, x1, y1] = object.box_px;
  if (object.pixels++ == 0) object.box_px = {x, y, x + 1, y + 1};
  x0 = std::min(x0, x), y0 = std::min(y0, y);
  x1 = std::max(x1, x + 1), y1 = std::max(y1, y + 1);
}

}  // namespace

PictureLegend legend_of(const Frame& frame,
                        const Scene& scene,
                        std::span<const std::string> actor_names) {
  PictureLegend legend;
  legend.width = frame.color.width, legend.height = frame.color.height;
  std::map<std::uint32_t, PictureObject> objects;
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    const std::uint32_t id = frame.instance[i];
    if (id == 0) continue;
    auto found = objects.find(id);
    if (found == objects.end())
      found = objects.emplace(id, described(id, scene, actor_names)).first;
    const int pixel = static_cast<int>(i);
    include_pixel(found->second, pixel % legend.width, pixel / legend.width);
  }
  for (auto& [id, object] : objects)
    legend.objects.push_back(std::move(object));
  return legend;
}

Image draw_object_ids(const Frame& frame) {
  Image image(frame.color.width, frame.color.height);
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(frame.instance[i] >> (8 * c));
  }
  return image;
}

}  // namespace marketgen
