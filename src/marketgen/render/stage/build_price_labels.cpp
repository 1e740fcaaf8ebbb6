#include <fmt/format.h>

#include <cmath>

#include "assets/print/label.h"
#include "io/json.h"
#include "render/picture_objects.h"
#include "render/price_tags.h"
#include "render/stage/build_signage.h"
#include "scene/price_tags.h"

namespace marketgen::render::raytrace {
namespace {

// Heights in pixels: near, and a third of it from afar.
constexpr int near_tag_px = 96, near_card_px = 222;
int pixels(int near_px, PrintDetail detail) {
  return detail == PrintDetail::near ? near_px : near_px / 3;
}

Result<assets::PrintedPicture> print_card(const catalog::Product& product, int card_px) {
  MARKETGEN_TRY(Image card, assets::draw_promotion_card(product, card_px));
  return assets::PrintedPicture{std::move(card), std::nullopt};
}

// A printed rectangle before a shelf: its middle and size in the shelf frame.
struct Sticker {
  float x = 0, y = 0, z = 0, width = 0, height = 0;
  std::uint16_t material = 0;
};

void stick(Draft& draft, std::uint32_t shelf, const Sticker& sticker) {
  const Placement at = placement_of(scene::world_from_shelf(draft.scene(), shelf));
  const float left = sticker.x - sticker.width / 2, right = sticker.x + sticker.width / 2;
  const float low = sticker.z - sticker.height / 2, high = sticker.z + sticker.height / 2;
  Mesh quad;
  add_quad(quad,
           at({left, sticker.y, low}),
           at({right, sticker.y, low}),
           at({right, sticker.y, high}),
           at({left, sticker.y, high}),
           0);
  World& world = draft.world();
  append(world.shell,
         world.shell_glass,
         quad,
         {sticker.material},
         world,
         {first_fixture_object + draft.scene().shelves[shelf].fixture, -1});
}

}  // namespace

PriceLabelBuilder::PriceLabelBuilder(Draft& draft) {
  const scene::Scene& scene = draft.scene();
  const auto paper = [&](std::int32_t texture) {
    return draft.material({.color = {1, 1, 1}, .roughness = 0.5F, .texture = texture});
  };
  const int tag_px = pixels(near_tag_px, draft.print()),
            card_px = pixels(near_card_px, draft.print());
  for (const scene::PriceLabel& label : scene.price_labels) {
    const catalog::Product product = scene::product_on_tag(scene, label);
    const bool promotion = label.promotion != 0;
    const std::string row = io::write_json_line(product);
    Looks looks;
    looks.tag = paper(
        draft.print_texture(fmt::format("tag {} {} {}", tag_px, promotion ? "promotion" : "", row),
                            [product, promotion, tag_px] {
                              return assets::print_price_tag(product, promotion, tag_px);
                            }));
    if (promotion)
      looks.card =
          paper(draft.print_texture(fmt::format("promotion card {} {}", card_px, row),
                                    [product, card_px] { return print_card(product, card_px); }));
    looks_of_label_.push_back(looks);
  }
}

void PriceLabelBuilder::build(Draft& draft) const {
  const scene::Scene& scene = draft.scene();
  for (std::size_t i = 0; i < scene.price_labels.size(); ++i) {
    const scene::PriceLabel& label = scene.price_labels[i];
    const Vec3f at = price_tag_place(scene, label);
    const Sticker tag{at.x, at.y, at.z, label.width_m, label.height_m, looks_of_label_[i].tag};
    stick(draft, label.shelf, tag);
    if (!looks_of_label_[i].card) continue;
    const Vec3f card = promotion_card_place(scene, i);
    stick(draft,
          label.shelf,
          {card.x,
           card.y,
           card.z,
           promotion_card_width_m,
           promotion_card_height_m,
           *looks_of_label_[i].card});
  }
}

}  // namespace marketgen::render::raytrace
