#include "server/replay_things.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

namespace marketgen::server {

Result<void> ReplayThings::add(const episodes::ThingMotion& thing,
                               bool is_goal,
                               const std::string& episode) {
  const bool is_basket = thing.kind == episodes::ThingKind::basket;
  if (!is_basket && !meshes_.contains(thing.sku)) {
    const auto row_in = [&](const std::vector<catalog::Product>& rows) {
      return std::ranges::find(rows, thing.sku, &catalog::Product::sku);
    };
    auto row = row_in(store_->scene.catalog);
    if (row == store_->scene.catalog.end()) row = row_in(catalog_->products);
    if (row == catalog_->products.end())
      return Error{"catalog.unknown_sku",
                   thing.sku,
                   fmt::format("lies in {} and is neither in the store nor in the catalogue: show "
                               "the results with the version that made them",
                               episode)};
    meshes_[thing.sku] = products_.size();
    products_.push_back(*row);
  }
  const auto [name, name_zh] = names_of_sku(thing.sku);
  const std::int32_t mesh = is_basket ? -1 : static_cast<std::int32_t>(meshes_.at(thing.sku));
  rows_.push_back({thing.kind, thing.number, thing.sku, name, name_zh, mesh, is_goal});
  return {};
}

std::pair<std::string, std::string> ReplayThings::names_of_sku(const std::string& sku) const {
  for (const std::vector<catalog::Product>* rows :
       std::initializer_list<const std::vector<catalog::Product>*>{&products_,
                                                                   &store_->scene.catalog}) {
    const auto row = std::ranges::find(*rows, sku, &catalog::Product::sku);
    if (row != rows->end()) return {row->name, row->name_zh};
  }
  return {sku, sku};
}

}  // namespace marketgen::server
