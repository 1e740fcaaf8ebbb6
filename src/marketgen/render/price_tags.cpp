#include "render/price_tags.h"

#include <cmath>

#include "assets/fixtures/fixture_model.h"
#include "render/stage/world.h"

namespace marketgen::render {
namespace {

constexpr float card_lift_m = 8e-4F;  // of a card before the tag
// Where a rail's front is unless the fixture has one elsewhere.
constexpr auto usual_front_m = static_cast<float>(assets::price_rail_face_m);
constexpr auto usual_middle_m =
    static_cast<float>((assets::price_rail_top_m + assets::price_rail_bottom_m) / 2);

struct RailFace {
  float y = usual_front_m, z = usual_middle_m;  // in the shelf frame
};

// The front of the price rail that belongs to a shelf.
RailFace rail_of(const scene::Scene& scene, const scene::SceneShelf& shelf) {
  const raytrace::Placement fixture_from_shelf =
      raytrace::placement_of(Pose{{shelf.position_m[0], shelf.position_m[1], shelf.position_m[2]},
                                  {shelf.rotation_wxyz[0],
                                   shelf.rotation_wxyz[1],
                                   shelf.rotation_wxyz[2],
                                   shelf.rotation_wxyz[3]}});
  const scene::SceneFixture& fixture = scene.fixtures[shelf.fixture];
  for (std::uint32_t i = fixture.first_part; i < fixture.first_part + fixture.part_count; ++i) {
    const scene::ScenePart& part = scene.parts[i];
    if (part.unit != assets::UnitKind::price_rail) continue;
    const Vec3f middle =
        fixture_from_shelf.to_local({part.position_m[0], part.position_m[1], part.position_m[2]});
    const bool before_this_shelf = std::fabs(middle.x) < shelf.width_m / 2 && middle.y > -0.06F &&
                                   middle.y < 0.06F && std::fabs(middle.z) < 0.08F;
    if (before_this_shelf) return {middle.y - part.half_size_m[1], middle.z};
  }
  return {};
}

}  // namespace

Vec3f price_tag_place(const scene::Scene& scene, const scene::PriceLabel& label) {
  const scene::SceneShelf& shelf = scene.shelves[label.shelf];
  const RailFace rail = rail_of(scene, shelf);
  return {label.x_m - shelf.width_m / 2, rail.y - price_tag_lift_m, rail.z};
}

Vec3f promotion_card_place(const scene::Scene& scene, std::size_t row) {
  const scene::PriceLabel& label = scene.price_labels[row];
  const Vec3f tag = price_tag_place(scene, label);
  const float apart = static_cast<float>(row % 3) * card_lift_m;
  return {
      tag.x, tag.y - card_lift_m - apart, tag.z - label.height_m / 2 - promotion_card_height_m / 2};
}

}  // namespace marketgen::render
