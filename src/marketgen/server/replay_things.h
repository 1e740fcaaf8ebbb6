// What an episode moves, as a page is told of it, and the goods whose shapes it draws.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "episodes/motion.h"
#include "store/store.h"

namespace marketgen::server {

struct ReplayThing {
  episodes::ThingKind kind = episodes::ThingKind::item;
  std::uint32_t number = 0;
  std::string sku, name, name_zh;
  std::int32_t mesh = -1;
  bool is_goal = false;
  static constexpr auto fields = field_list(
      field("kind", &ReplayThing::kind, "item, product or basket"),
      field("number", &ReplayThing::number, "of the item, or row of the place's product"),
      field("sku", &ReplayThing::sku, "product; none of a basket"),
      field("name", &ReplayThing::name, "of the product"),
      field("name_zh", &ReplayThing::name_zh, "in Chinese"),
      field("mesh", &ReplayThing::mesh, "row of meshes.bin; -1: a body of robot.bin"),
      field("goal", &ReplayThing::is_goal, "it is asked for"));
};

class ReplayThings {
 public:
  ReplayThings() = default;
  // `catalog` outlives it.
  ReplayThings(std::shared_ptr<const store::Store> store, const catalog::Catalog& catalog)
      : store_(std::move(store)), catalog_(&catalog) {}

  // One more, after those before. `episode`: whose it is, for errors. Error catalog.unknown_sku:
  // neither the store nor the catalogue has its product.
  Result<void> add(const episodes::ThingMotion& thing, bool is_goal, const std::string& episode);
  const std::vector<ReplayThing>& rows() const { return rows_; }
  // Distinct, in the order of ReplayThing::mesh.
  const std::vector<catalog::Product>& products() const { return products_; }
  // In English and Chinese; the SKU itself where no row has it.
  std::pair<std::string, std::string> names_of_sku(const std::string& sku) const;

 private:
  std::shared_ptr<const store::Store> store_;
  const catalog::Catalog* catalog_ = nullptr;
  std::vector<ReplayThing> rows_;
  std::vector<catalog::Product> products_;
  std::map<std::string, std::size_t> meshes_;  // by SKU: row of products_
};

}  // namespace marketgen::server
