#include "scene/price_tags.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "catalog/country.h"

namespace marketgen::scene {
namespace {

constexpr double label_width_m = 0.07, label_height_m = 0.038, min_label_width_m = 0.03;
constexpr double gap_between_tags_m = 0.002;
// What a price was before it changed, as a share of what it is.
constexpr std::array<double, 6> old_prices = {0.8, 0.85, 0.9, 1.1, 1.15, 1.25};

std::uint32_t old_price_cents(std::uint32_t cents, const catalog::Country& country, Stream& draw) {
  const double share = old_prices[static_cast<std::size_t>(
      draw.integer(0, static_cast<int>(old_prices.size()) - 1))];
  const std::uint32_t coin = country.minor_digits > 0 ? 1 : 100;
  const auto old = static_cast<std::uint32_t>(std::lround(cents * share / coin)) * coin;
  return old == cents ? cents + coin : old;  // of very low prices
}

struct ShelfTags {
  std::vector<PriceLabel> tags;  // as they should be, from left to right

  // The tag of another product on the shelf; the same where there is only one.
  const PriceLabel& other_than(const PriceLabel& tag, Stream& draw) const {
    std::vector<const PriceLabel*> others;
    for (const PriceLabel& other : tags)
      if (other.sku != tag.sku) others.push_back(&other);
    return others.empty() ? tag
                          : *others[static_cast<std::size_t>(
                                draw.integer(0, static_cast<int>(others.size()) - 1))];
  }
};

class TagFaults {
 public:
  TagFaults(const Scene& scene, Seed seed, const catalog::Country& country)
      : scene_(scene), seed_(seed), country_(country) {}

  void add(const ShelfTags& shelf, const plan::PriceTagSpec& faults) {
    for (const PriceLabel& right : shelf.tags)
      add_tag(shelf, right, faults);
  }
  void keep(const PriceLabel& tag) { kept_.push_back(tag); }
  std::vector<PriceLabel> take() { return std::move(kept_); }

 private:
  void add_tag(const ShelfTags& shelf, PriceLabel tag, const plan::PriceTagSpec& faults) {
    Stream draw = stream_of(tag);
    if (draw.chance(faults.missing)) return;
    if (draw.chance(faults.wrong_product)) {
      const PriceLabel& other = shelf.other_than(tag, draw);
      tag.sku = other.sku, tag.promotion = other.promotion, tag.price_cents = other.price_cents;
    } else if (draw.chance(faults.wrong_price)) {
      tag.price_cents = old_price_cents(tag.price_cents, country_, draw);
    } else if (draw.chance(faults.doubled) && has_room_for_two(tag)) {
      PriceLabel old = tag;
      const auto aside_m = static_cast<float>((tag.width_m + gap_between_tags_m) / 2);
      tag.x_m -= aside_m, old.x_m += aside_m;
      old.price_cents = old_price_cents(tag.price_cents, country_, draw);
      kept_.push_back(tag);
      kept_.push_back(old);
      return;
    }
    kept_.push_back(tag);
  }

  bool has_room_for_two(const PriceLabel& tag) const {
    return scene_.facings[tag.facing].width_m >= 2 * tag.width_m + gap_between_tags_m;
  }

  Stream stream_of(const PriceLabel& tag) const {
    const std::uint32_t fixture = scene_.shelves[tag.shelf].fixture;
    return seed_.child("price_tags", scene_.layout.fixtures[fixture].id)
        .child("shelf", tag.shelf - scene_.fixtures[fixture].first_shelf)
        .child("facing", scene_.facings[tag.facing].position)
        .stream();
  }

  const Scene& scene_;
  Seed seed_;
  const catalog::Country& country_;
  std::vector<PriceLabel> kept_;
};

const plan::PriceTagSpec* faults_at(const Scene& scene,
                                    const plan::Plan& plan,
                                    std::uint32_t shelf) {
  const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[shelf].fixture];
  const plan::Zone* zone = plan::find_zone(plan, fixture.zone);
  return zone != nullptr && zone->stock.price_tags ? &*zone->stock.price_tags : nullptr;
}

}  // namespace

std::uint32_t price_cents(const catalog::Product& product) {
  return static_cast<std::uint32_t>(product.price * 100 + 0.5);
}

PriceLabel tag_before_block(std::uint32_t shelf, double x_m, double width_m) {
  PriceLabel tag;
  tag.shelf = shelf;
  tag.width_m = static_cast<float>(std::clamp(width_m - 0.004, min_label_width_m, label_width_m));
  tag.height_m = static_cast<float>(label_height_m);
  tag.x_m = static_cast<float>(x_m + width_m / 2);
  return tag;
}

catalog::Product product_on_tag(const Scene& scene, const PriceLabel& label) {
  catalog::Product product = scene.catalog[label.sku];
  if (label.price_cents != price_cents(product)) product.price = label.price_cents / 100.0;
  return product;
}

TagFault fault_of(const Scene& scene, const PriceLabel& label) {
  if (label.sku != scene.facings[label.facing].sku) return TagFault::wrong_product;
  return label.price_cents == price_cents(scene.catalog[label.sku]) ? TagFault::none
                                                                    : TagFault::wrong_price;
}

void fault_price_tags(Scene& scene, const plan::Plan& plan, Seed seed) {
  const auto has_faults = [](const plan::Zone& zone) { return zone.stock.price_tags.has_value(); };
  if (std::ranges::none_of(plan.zones, has_faults)) return;
  TagFaults made(scene, seed, catalog::country_or_euro(plan.country));
  for (std::size_t row = 0; row < scene.price_labels.size();) {
    ShelfTags shelf;
    const std::uint32_t number = scene.price_labels[row].shelf;
    while (row < scene.price_labels.size() && scene.price_labels[row].shelf == number)
      shelf.tags.push_back(scene.price_labels[row++]);
    if (const plan::PriceTagSpec* faults = faults_at(scene, plan, number))
      made.add(shelf, *faults);
    else
      for (const PriceLabel& tag : shelf.tags)
        made.keep(tag);
  }
  scene.price_labels = made.take();
}

}  // namespace marketgen::scene
