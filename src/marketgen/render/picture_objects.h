// What the numbers of Frame::instance stand for.
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
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/fields.h"
#include "geometry/image.h"
#include "render/render.h"
#include "scene/scene.h"

namespace marketgen::render {

inline constexpr std::uint32_t shell_object = 1, first_fixture_object = 2;
inline std::uint32_t first_product_object(const scene::Scene& scene) {
  return first_fixture_object + static_cast<std::uint32_t>(scene.fixtures.size());
}
inline std::uint32_t first_actor_object(const scene::Scene& scene) {
  return first_product_object(scene) + static_cast<std::uint32_t>(scene.products.size());
}

enum class ObjectKind { shell, fixture, product, actor };
constexpr std::array<std::string_view, 4> names_of(ObjectKind) {
  return {"shell", "fixture", "product", "actor"};
}
// Precondition: `object` is not 0.
ObjectKind kind_of(const scene::Scene& scene, std::uint32_t object);

// What kind of thing an object is, for semantic segmentation.
struct PictureCategory {
  std::uint16_t id = 0;  // in category pictures; 0 there is nothing
  ObjectKind kind = ObjectKind::shell;
  std::string name;   // product category, fixture kind; "shell", "actor", "person"
  std::string color;  // in draw_categories()

  static constexpr auto fields =
      field_list(field("id", &PictureCategory::id, "number in the picture of categories"),
                 field("kind", &PictureCategory::kind, "shell, fixture, product or actor"),
                 field("name", &PictureCategory::name, "product category or fixture kind"),
                 field("color", &PictureCategory::color, "in the coloured picture of categories"));
};

// All categories of a scene: 1 shell, 2 actor, then its fixture kinds and its product categories by
// name, then what actors say that they are (people: "person"). Numbers hold for every picture of
// the scene, whoever stands in it; names are what other scenes share.
class PictureCategories {
 public:
  // The scene must outlive it. Categories of actors in their order in Renderer::set_actors();
  // those that are not named are "actor".
  explicit PictureCategories(const scene::Scene& scene,
                             const std::vector<std::string>& categories_of_actors = {});

  const std::vector<PictureCategory>& rows() const { return rows_; }
  // Number of an object's category; 0 for object 0.
  std::uint16_t of(std::uint32_t object) const;

 private:
  void add_categories_of(const std::vector<std::string>& actors);
  const scene::Scene& scene_;
  std::vector<PictureCategory> rows_;
  std::vector<std::uint16_t> of_fixture_, of_sku_, of_actor_;
};

// Exact: red + 256 * green + 65,536 * blue is the object's number.
Image draw_object_ids(const Frame& frame);
// One category number a pixel.
std::vector<std::uint16_t> category_ids(const Frame& frame, const PictureCategories& categories);
// "#rrggbb" of object_color().
std::string hex_of_object_color(std::uint32_t object);

}  // namespace marketgen::render
