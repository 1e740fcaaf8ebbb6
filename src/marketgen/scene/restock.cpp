#include "scene/restock.h"

#include <algorithm>
#include <map>

#include "io/json.h"
#include "plan/shelf_key.h"
#include "scene/catalog_slice.h"
#include "scene/store_catalog.h"

namespace marketgen::scene {
namespace {

std::map<plan::ShelfKey, std::string> lines_of(const plan::Plan& plan) {
  std::map<plan::ShelfKey, std::string> lines;
  for (const plan::StockedShelf& shelf : plan.planogram.value_or(std::vector<plan::StockedShelf>{}))
    lines[plan::key_of(shelf)] = io::write_json_line(shelf);
  return lines;
}

std::string without_shelves(plan::Plan plan) {
  plan.planogram.reset();
  plan.provenance.clear();
  return io::write_json_line(plan);
}

bool stands_for_itself(const plan::Zone& zone) {
  return zone.stock.misplaced == 0 && !zone.stock.must_stock;
}

// Whether goods are heaped or hung on any of these shelves.
bool has_heaps(const Scene& scene, const std::vector<plan::StockedShelf>& shelves) {
  return std::ranges::any_of(scene.shelves, [&](const SceneShelf& shelf) {
    if (shelf.use == assets::ShelfUse::stand) return false;
    const plan::ShelfKey key{
        scene.layout.fixtures[shelf.fixture].id, plan::shelf_side(shelf.side), shelf.level + 1};
    return std::ranges::any_of(
        shelves, [&](const plan::StockedShelf& one) { return plan::key_of(one) == key; });
  });
}

// The facings, items and tags of one shelf.
struct ShelfRows {
  std::vector<Facing> facings;
  std::vector<SceneProduct> products;
  std::vector<PriceLabel> labels;
};

// The store with these fixtures alone: each stream is named after its fixture, so that they hold
// what they hold among the others.
Result<Scene> alone(const layout::Layout& layout,
                    const std::vector<plan::StockedShelf>& shelves,
                    plan::Plan plan,
                    const catalog::Catalog& catalog,
                    Seed seed) {
  layout::Layout few = layout;
  std::erase_if(few.fixtures, [&](const layout::Fixture& fixture) {
    return std::ranges::find(shelves, fixture.id, &plan::StockedShelf::fixture) == shelves.end();
  });
  plan.planogram = shelves;
  plan.shelves.reset();  // the boards stay where they are
  return build_scene(few, plan, catalog, seed);
}

ShelfRows rows_on(const Scene& scene, std::uint32_t shelf) {
  ShelfRows rows;
  std::map<std::uint32_t, std::uint32_t> number;  // of the shelf's own, by facing
  for (std::uint32_t f = 0; f < scene.facings.size(); ++f) {
    if (scene.facings[f].shelf != shelf) continue;
    number[f] = static_cast<std::uint32_t>(rows.facings.size());
    rows.facings.push_back(scene.facings[f]);
    const auto first = scene.products.begin() + scene.facings[f].first_product;
    rows.products.insert(rows.products.end(), first, first + scene.facings[f].product_count);
  }
  for (PriceLabel label : scene.price_labels) {
    if (label.shelf != shelf) continue;
    label.facing = number.at(label.facing);
    rows.labels.push_back(label);
  }
  return rows;
}

// Puts the shelves' rows in the place of those that the scene has there.
class Splice {
 public:
  Splice(Scene& scene, const std::map<std::uint32_t, ShelfRows>& rows)
      : scene_(scene), rows_(rows) {}

  void run() {
    std::size_t facing = 0, label = 0;
    for (std::uint32_t shelf = 0; shelf < scene_.shelves.size(); ++shelf) {
      const auto anew = rows_.find(shelf);
      const auto first = static_cast<std::uint32_t>(facings_.size());
      const std::size_t first_old = facing;
      for (; facing < scene_.facings.size() && scene_.facings[facing].shelf == shelf; ++facing)
        if (anew == rows_.end()) keep(scene_.facings[facing]);
      if (anew != rows_.end()) add(anew->second, shelf);
      for (; label < scene_.price_labels.size() && scene_.price_labels[label].shelf == shelf;
           ++label) {
        if (anew != rows_.end()) continue;
        labels_.push_back(scene_.price_labels[label]);
        labels_.back().facing += first - static_cast<std::uint32_t>(first_old);
      }
      if (anew != rows_.end()) add_labels(anew->second, shelf, first);
    }
    scene_.facings = std::move(facings_);
    scene_.products = std::move(products_);
    scene_.price_labels = std::move(labels_);
  }

 private:
  void put(Facing facing, const SceneProduct* items) {
    const auto number = static_cast<std::uint32_t>(facings_.size());
    facing.first_product = static_cast<std::uint32_t>(products_.size());
    for (std::uint32_t i = 0; i < facing.product_count; ++i) {
      products_.push_back(items[i]);
      products_.back().facing = number;
    }
    facings_.push_back(facing);
  }

  void keep(const Facing& facing) { put(facing, scene_.products.data() + facing.first_product); }

  void add(const ShelfRows& rows, std::uint32_t shelf) {
    const SceneProduct* items = rows.products.data();
    for (Facing facing : rows.facings) {
      facing.shelf = shelf;
      put(facing, items);
      items += facing.product_count;
    }
  }

  void add_labels(const ShelfRows& rows, std::uint32_t shelf, std::uint32_t first_facing) {
    for (PriceLabel label : rows.labels) {
      label.shelf = shelf;
      label.facing += first_facing;
      labels_.push_back(label);
    }
  }

  Scene& scene_;
  const std::map<std::uint32_t, ShelfRows>& rows_;
  std::vector<Facing> facings_;
  std::vector<SceneProduct> products_;
  std::vector<PriceLabel> labels_;
};

}  // namespace

std::optional<std::vector<plan::StockedShelf>> shelves_changed(const plan::Plan& before,
                                                               const plan::Plan& after,
                                                               const catalog::Catalog& catalog,
                                                               const Scene& scene) {
  if (!catalog.own.empty() || !after.placements.empty() || !after.planogram) return std::nullopt;
  if (!std::ranges::all_of(after.zones, stands_for_itself)) return std::nullopt;
  if (without_shelves(before) != without_shelves(after)) return std::nullopt;
  std::map<plan::ShelfKey, std::string> old = lines_of(before);
  std::vector<plan::StockedShelf> changed;
  for (const plan::StockedShelf& shelf : *after.planogram) {
    const auto was = old.find(plan::key_of(shelf));
    if (was == old.end() || was->second != io::write_json_line(shelf)) changed.push_back(shelf);
    if (was != old.end()) old.erase(was);
  }
  if (!old.empty()) return std::nullopt;
  if (after.shelves == plan::ShelfPitch::fitted && has_heaps(scene, changed)) return std::nullopt;
  return changed;
}

Result<Scene> restocked(Scene scene,
                        const std::vector<plan::StockedShelf>& shelves,
                        const plan::Plan& plan,
                        const catalog::Catalog& catalog) {
  const StoreCatalog rows_of_store(catalog, plan);
  MARKETGEN_TRY(Scene few,
                alone(scene.layout, shelves, plan, rows_of_store.get(), Seed(scene.seed)));
  give_up_catalog_slice(few, catalog);
  std::map<std::string_view, std::uint32_t> fixture_of;
  for (std::uint32_t f = 0; f < scene.layout.fixtures.size(); ++f)
    fixture_of[scene.layout.fixtures[f].id] = f;
  std::map<std::uint32_t, ShelfRows> rows;
  for (std::uint32_t s = 0; s < few.shelves.size(); ++s) {
    const SceneShelf& shelf = few.shelves[s];
    const std::string& id = few.layout.fixtures[shelf.fixture].id;
    const plan::ShelfSide side = plan::shelf_side(shelf.side);
    const bool named = std::ranges::any_of(shelves, [&](const plan::StockedShelf& said) {
      return plan::key_of(said) == plan::ShelfKey{id, side, shelf.level + 1};
    });
    const std::uint32_t in_fixture = s - few.fixtures[shelf.fixture].first_shelf;
    if (named) rows[scene.fixtures[fixture_of.at(id)].first_shelf + in_fixture] = rows_on(few, s);
  }
  give_up_catalog_slice(scene, catalog);
  Splice(scene, rows).run();
  take_catalog_slice(scene, rows_of_store.get());
  return scene;
}

}  // namespace marketgen::scene
