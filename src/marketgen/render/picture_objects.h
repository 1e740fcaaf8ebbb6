// What the numbers of Frame::instance stand for, and a legend of a picture.
//
//   0                            nothing was hit
//   1                            the room: shell, ceiling, lamps, signs
//   2 + i                        scene.fixtures[i], its price labels too
//   2 + fixtures + j             scene.products[j]
//   2 + fixtures + products + k  actors[k]: a whole robot has one number
//
// A number stands for the same thing in every picture of a scene, whatever the camera; the actors'
// follow their order in Renderer::set_actors().
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "geometry/image.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen {

inline constexpr std::uint32_t shell_object = 1, first_fixture_object = 2;
inline std::uint32_t first_product_object(const Scene& scene) {
  return first_fixture_object + static_cast<std::uint32_t>(scene.fixtures.size());
}
inline std::uint32_t first_actor_object(const Scene& scene) {
  return first_product_object(scene) + static_cast<std::uint32_t>(scene.products.size());
}

enum class ObjectKind { shell, fixture, product, actor };
constexpr std::array<std::string_view, 4> names_of(ObjectKind) {
  return {"shell", "fixture", "product", "actor"};
}

// One object that covers at least one pixel.
struct PictureObject {
  std::uint32_t id = 0;
  ObjectKind kind = ObjectKind::shell;
  std::string name;             // fixture id, product id, actor name; "shell"
  std::string sku;              // of a product
  std::string color;            // in draw_instances(); two objects may share one
  int pixels = 0;               // that show it
  std::array<int, 4> box_px{};  // x0, y0, x1, y1 around them; x1 and y1 are past the last

  static constexpr auto fields = field_list(
      field("id", &PictureObject::id, "number in the picture of object numbers"),
      field("kind", &PictureObject::kind, "shell, fixture, product or actor"),
      field("name", &PictureObject::name, "fixture id, product id, or the actor's name"),
      field("sku", &PictureObject::sku, "of a product"),
      field("color", &PictureObject::color, "in the segmentation; two objects may share one"),
      field("pixels", &PictureObject::pixels, "how many show it"),
      field("box_px", &PictureObject::box_px, "x0, y0, x1, y1; x1 and y1 are past the last pixel"));
};

struct PictureLegend {
  std::string schema = "market-legend/1";
  int width = 0, height = 0;           // pixels
  std::vector<PictureObject> objects;  // by id

  static constexpr auto fields =
      field_list(field("schema", &PictureLegend::schema, "schema tag", constant("market-legend/1")),
                 field("width", &PictureLegend::width, "of the picture, pixels"),
                 field("height", &PictureLegend::height, "of the picture, pixels"),
                 field("objects", &PictureLegend::objects, "what is to be seen, by id"));
};

// Precondition: `frame` is a picture of `scene` with as many actors as there are names.
PictureLegend legend_of(const Frame& frame,
                        const Scene& scene,
                        std::span<const std::string> actor_names);

// Exact: red + 256 * green + 65,536 * blue is the object's number.
Image draw_object_ids(const Frame& frame);

}  // namespace marketgen
