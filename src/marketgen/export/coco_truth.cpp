#include "export/coco_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catalog/country.h"
#include "export/coco_document.h"
#include "export/exporter.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr double cent = 0.005;            // half of one
constexpr double box_tolerance_m = 0.01;  // packs bulge, and depth is in whole millimetres

// Whether an item stands in this column of its block: its middle lies between the column's edges.
bool stands_in(const scene::Scene& scene,
               const scene::Facing& facing,
               const scene::SceneProduct& item,
               std::optional<int> column) {
  if (!column) return true;
  const Vec3 at = inverse(scene::world_from_shelf(scene, facing.shelf)) *
                  scene::world_from_product(item).position;
  const double from_left_m =
      at.x + scene.shelves[facing.shelf].width_m / 2.0 - static_cast<double>(facing.x_m);
  const double width_m = static_cast<double>(facing.width_m) / facing.facings;
  return from_left_m > (*column - 1) * width_m && from_left_m < *column * width_m;
}

}  // namespace

CocoTruth::CocoTruth(const scene::Scene& scene)
    : scene_(scene), planogram_(scene::planogram_rows(scene)) {
  for (std::uint32_t i = 0; i < planogram_.size(); ++i) {
    const scene::PlanogramRow& row = planogram_[i];
    facings_[{row.fixture, coco_side(row.side), row.bay, row.level + 1, row.position + 1}] = i;
  }
  for (std::uint32_t i = 0; i < scene.products.size(); ++i)
    products_[scene::product_id(scene, i)] = i;
  for (std::uint32_t i = 0; i < scene.price_labels.size(); ++i)
    tags_.emplace(scene.price_labels[i].facing, i);
}

std::optional<std::uint32_t> CocoTruth::product(const std::string& instance) const {
  const auto found = products_.find(instance);
  return found == products_.end() ? std::nullopt : std::optional(found->second);
}

const scene::PlanogramRow* CocoTruth::row_at(const std::optional<ReadCocoPlace>& place) const {
  const auto found = place ? facings_.find(*place) : facings_.end();
  return found == facings_.end() ? nullptr : &planogram_[found->second];
}

Result<void> CocoTruth::check_categories(const ReadCoco& coco, const std::string& where) const {
  std::map<std::string, std::string> wanted;
  for (const std::string_view name : coco_shelf_categories)
    wanted[std::string(name)] = coco_shelf;
  for (const catalog::Product& product : scene_.catalog)
    wanted[product.sku] = product.category;
  std::map<std::string, std::string> read;
  for (const auto& [id, names] : coco.categories)
    read.insert(names);
  if (read == wanted && coco.categories.size() == wanted.size()) return {};
  return mismatch(where,
                  fmt::format("its {} categories are not the {} products of the store, gap, "
                              "price_tag and missing_price_tag",
                              coco.categories.size(),
                              scene_.catalog.size()));
}

Result<void> CocoTruth::check(CocoKind kind,
                              const ReadCocoAnnotation& read,
                              const std::string& where) const {
  switch (kind) {
    case CocoKind::item:
      return check_item(read, where);
    case CocoKind::gap:
      return check_gap(read, where);
    case CocoKind::missing_tag:
      return check_missing_tag(read, where);
    case CocoKind::price_tag:
      break;
  }
  return check_price_tag(read, where);
}

Result<void> CocoTruth::check_item(const ReadCocoAnnotation& read, const std::string& where) const {
  const auto row = product(read.instance);
  if (!row) return mismatch(where, "the store has no item \"" + read.instance + "\"");
  const scene::SceneProduct& item = scene_.products[*row];
  const std::string& sku = scene_.catalog[item.sku].sku;
  if (read.sku != sku)
    return mismatch(where,
                    fmt::format("\"{}\" is no \"{}\" but \"{}\"", read.instance, read.sku, sku));
  if (item.facing == scene::no_facing) {
    if (read.place) return mismatch(where, "\"" + read.instance + "\" stands in no block");
    return {};
  }
  const scene::PlanogramRow* block = row_at(read.place);
  if (block != &planogram_[item.facing])
    return mismatch(where, "\"" + read.instance + "\" stands in another place");
  const bool misplaced = block->sku != sku;
  if (read.misplaced != misplaced || read.planogram_sku != (misplaced ? block->sku : ""))
    return mismatch(where,
                    fmt::format("the planogram has \"{}\" where \"{}\" stands", block->sku, sku));
  return {};
}

Result<void> CocoTruth::check_gap(const ReadCocoAnnotation& read, const std::string& where) const {
  const scene::PlanogramRow* block = row_at(read.place);
  if (block == nullptr || block->sku != read.sku)
    return mismatch(where, "the planogram has no block of \"" + read.sku + "\" there");
  if (read.column && (*read.column < 1 || *read.column > block->facings))
    return mismatch(where, fmt::format("column {} is none of {}", *read.column, block->facings));
  const scene::Facing& facing = scene_.facings[facings_.at(*read.place)];
  for (std::uint32_t i = 0; i < facing.product_count; ++i) {
    if (stands_in(scene_, facing, scene_.products[facing.first_product + i], read.column))
      return mismatch(where,
                      fmt::format("\"{}\" stands in the gap",
                                  scene::product_id(scene_, facing.first_product + i)));
  }
  return {};
}

Result<void> CocoTruth::check_price_tag(const ReadCocoAnnotation& read,
                                        const std::string& where) const {
  const scene::PlanogramRow* block = row_at(read.place);
  if (block == nullptr) return mismatch(where, "the planogram has no block there");
  const auto [first, last] = tags_.equal_range(facings_.at(*read.place));
  const bool hangs_there = std::any_of(first, last, [&](const auto& tag) {
    const scene::PriceLabel& label = scene_.price_labels[tag.second];
    return scene_.catalog[label.sku].sku == read.sku && read.promotion == (label.promotion != 0) &&
           std::abs(read.price - label.price_cents / 100.0) < cent;
  });
  if (!hangs_there)
    return mismatch(where,
                    fmt::format("no {} of \"{}\" at {} hangs there",
                                read.promotion ? "offer's tag" : "tag",
                                read.sku,
                                read.price));
  const bool other = block->sku != read.sku;
  const bool dated = !other && std::abs(read.price - block->price) > cent;
  if (read.fault != (other   ? "wrong_product"
                     : dated ? "wrong_price"
                             : "") ||
      read.planogram_sku != (other ? block->sku : ""))
    return mismatch(where,
                    fmt::format("the planogram has \"{}\" for {} there", block->sku, block->price));
  const std::string printed =
      catalog::price_text(read.price, catalog::country_of(scene_.catalog.front()));
  if (std::ranges::find(read.text, printed) == read.text.end())
    return mismatch(where, fmt::format("its text does not say {}", printed));
  return {};
}

Result<void> CocoTruth::check_missing_tag(const ReadCocoAnnotation& read,
                                          const std::string& where) const {
  const scene::PlanogramRow* block = row_at(read.place);
  if (block == nullptr || block->sku != read.sku)
    return mismatch(where, "the planogram has no block of \"" + read.sku + "\" there");
  if (tags_.contains(facings_.at(*read.place))) return mismatch(where, "a tag hangs there");
  return {};
}

bool CocoTruth::lies_in(std::uint32_t product, Vec3 store_point) const {
  const scene::SceneProduct& item = scene_.products[product];
  const catalog::Product& row = scene_.catalog[item.sku];
  const Vec3 at = inverse(scene::world_from_product(item)) * store_point;
  return std::abs(at.x) < row.width_m() / 2 + box_tolerance_m &&
         std::abs(at.y) < row.depth_m() / 2 + box_tolerance_m && at.z > -box_tolerance_m &&
         at.z < row.height_m() + box_tolerance_m;
}

}  // namespace marketgen::exporters
