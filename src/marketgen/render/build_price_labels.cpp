#include <cmath>

#include "assets/label.h"
#include "io/json.h"
#include "render/build_signage.h"

namespace marketgen::raytrace {
namespace {

constexpr int tag_px = 96;
constexpr float lift_m = 8e-4F;  // label stock before the rail
// Where a rail's front usually is (assets/fixtures/units.h): 6 mm before the board, 38 mm down, 2
// mm up.
constexpr float usual_front_m = -0.006F, usual_middle_m = -0.018F;

struct RailFace {
  float y = usual_front_m, z = usual_middle_m;  // in the shelf frame
};

// The front of the price rail that belongs to a shelf.
RailFace rail_of(const Scene& scene, const SceneShelf& shelf) {
  const Placement fixture_from_shelf =
      placement_of(Pose{{shelf.position_m[0], shelf.position_m[1], shelf.position_m[2]},
                        {shelf.rotation_wxyz[0],
                         shelf.rotation_wxyz[1],
                         shelf.rotation_wxyz[2],
                         shelf.rotation_wxyz[3]}});
  const SceneFixture& fixture = scene.fixtures[shelf.fixture];
  for (std::uint32_t i = fixture.first_part; i < fixture.first_part + fixture.part_count; ++i) {
    const ScenePart& part = scene.parts[i];
    if (part.unit != UnitKind::price_rail) continue;
    const Vec3f middle =
        fixture_from_shelf.to_local({part.position_m[0], part.position_m[1], part.position_m[2]});
    const bool before_this_shelf = std::fabs(middle.x) < shelf.width_m / 2 && middle.y > -0.06F &&
                                   middle.y < 0.06F && std::fabs(middle.z) < 0.08F;
    if (before_this_shelf) return {middle.y - part.half_size_m[1], middle.z};
  }
  return {};
}

}  // namespace

PriceLabelBuilder::PriceLabelBuilder(Draft& draft) {
  const Scene& scene = draft.scene();
  for (const PriceLabel& label : scene.price_labels) {
    const Product& product = scene.catalog[label.sku];
    const bool promotion = label.promotion != 0;
    const std::string content = "tag " + std::to_string(tag_px) +
                                (promotion ? " promotion " : " ") + write_json_line(product);
    const std::int32_t texture = draft.texture(
        content, [&product, promotion] { return draw_price_tag(product, promotion, tag_px); });
    material_of_label_.push_back(
        draft.material({.color = {1, 1, 1}, .roughness = 0.5F, .texture = texture}));
  }
}

void PriceLabelBuilder::build(Draft& draft) const {
  const Scene& scene = draft.scene();
  World& world = draft.world();
  for (std::size_t i = 0; i < scene.price_labels.size(); ++i) {
    const PriceLabel& label = scene.price_labels[i];
    const SceneShelf& shelf = scene.shelves[label.shelf];
    const RailFace rail = rail_of(scene, shelf);
    const Placement at = placement_of(world_from_shelf(scene, label.shelf));
    const float x = label.x_m - shelf.width_m / 2, y = rail.y - lift_m;
    const float left = x - label.width_m / 2, right = x + label.width_m / 2;
    const float low = rail.z - label.height_m / 2, high = rail.z + label.height_m / 2;
    Mesh quad;
    add_quad(quad,
             at({left, y, low}),
             at({right, y, low}),
             at({right, y, high}),
             at({left, y, high}),
             0);
    append(world.shell,
           world.shell_glass,
           quad,
           {material_of_label_[i]},
           world,
           {2 + shelf.fixture, -1});
  }
}

}  // namespace marketgen::raytrace
