#include "export/price_prints.h"

#include <map>
#include <tuple>

#include <fmt/format.h>

#include "assets/print/label.h"
#include "base/parallel.h"
#include "export/label_picture.h"
#include "io/json.h"
#include "io/png.h"
#include "render/picture_cache.h"
#include "render/price_tags.h"
#include "scene/price_tags.h"

namespace marketgen::exporters {
namespace {

constexpr int tag_px = 64, card_px = 148;  // heights

Mesh upright_quad(float width_m, float height_m) {
  const float x = width_m / 2, z = height_m / 2;
  Mesh quad;
  add_quad(quad, {-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}, 0);
  return quad;
}

// Of what is stuck on there in the shelf's frame.
Pose place_at(const scene::Scene& scene, const scene::PriceLabel& label, const Vec3f& in_shelf) {
  return scene::world_from_shelf(scene, label.shelf) * Pose{to_double(in_shelf), {}};
}

using Design = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // SKU, promotion, cents

Design design_of(const scene::PriceLabel& label) {
  return {label.sku, label.promotion, label.price_cents};
}

// One design of tag for each SKU, promotion and price, one mesh for each size of it.
Result<void> add_tags(const scene::Scene& scene, PricePrints& prints) {
  struct Same {
    const scene::PriceLabel* first = nullptr;
    std::vector<Pose> places;
  };
  std::map<Design, std::size_t> picture_of;
  std::map<Design, catalog::Product> said;
  std::map<std::tuple<Design, float, float>, Same> tags;  // and size
  for (const scene::PriceLabel& label : scene.price_labels) {
    Same& same = tags[{design_of(label), label.width_m, label.height_m}];
    if (same.first == nullptr) same.first = &label;
    same.places.push_back(place_at(scene, label, render::price_tag_place(scene, label)));
    picture_of[design_of(label)] = 0;
    said.try_emplace(design_of(label), scene::product_on_tag(scene, label));
  }
  std::vector<std::pair<Design, Result<std::string>>> drawn;
  for (const auto& [key, index] : picture_of)
    drawn.emplace_back(key, std::string());
  parallel_for(drawn.size(), [&](std::size_t i) {
    const Design& design = drawn[i].first;
    const bool promotion = std::get<1>(design) != 0;
    const Result<Image> tag = exported_price_tag(said.at(design), promotion, tag_px);
    drawn[i].second = tag.ok() ? io::encode_png(*tag) : tag.error();
  });
  for (auto& [key, png] : drawn) {
    if (!png.ok()) return png.error();
    picture_of[key] = prints.pictures.size();
    prints.pictures.push_back(std::move(png).value());
  }
  for (auto& [key, same] : tags)
    prints.tags.push_back({"price/" + scene.catalog[same.first->sku].sku,
                           picture_of[design_of(*same.first)],
                           upright_quad(same.first->width_m, same.first->height_m),
                           std::move(same.places)});
  return {};
}

// One card a SKU on offer, at all its places.
Result<void> add_cards(const scene::Scene& scene, PricePrints& prints) {
  std::map<std::uint32_t, std::vector<Pose>> cards;  // by SKU
  for (std::size_t row = 0; row < scene.price_labels.size(); ++row) {
    const scene::PriceLabel& label = scene.price_labels[row];
    if (label.promotion != 0)
      cards[label.sku].push_back(place_at(scene, label, render::promotion_card_place(scene, row)));
  }
  for (auto& [sku, places] : cards) {
    const catalog::Product& product = scene.catalog[sku];
    MARKETGEN_TRY(
        const Image card,
        render::raytrace::cached_picture(
            fmt::format("promotion card {} {}", card_px, io::write_json_line(product)),
            [&product = product] { return assets::draw_promotion_card(product, card_px); }));
    MARKETGEN_TRY(std::string png, io::encode_png(card));
    prints.cards.push_back(
        {"offer/" + product.sku,
         prints.pictures.size(),
         upright_quad(render::promotion_card_width_m, render::promotion_card_height_m),
         std::move(places)});
    prints.pictures.push_back(std::move(png));
  }
  return {};
}

}  // namespace

Result<PricePrints> price_prints(const scene::Scene& scene) {
  PricePrints prints;
  MARKETGEN_CHECK(add_tags(scene, prints));
  MARKETGEN_CHECK(add_cards(scene, prints));
  return prints;
}

Mesh mesh_of_all(const PricePrint& print) {
  Mesh all;
  for (const Pose& pose : print.places) {
    const std::size_t first = all.positions.size();
    all.append(print.mesh);
    place(all, pose, first);
  }
  return all;
}

}  // namespace marketgen::exporters
