#include "scene/restock.h"

#include "bench/bench.h"
#include "bench/sample_store.h"
#include "plan/patch.h"
#include "plan/shelf_key.h"
#include "scene/bays.h"
#include "scene/stocked_shelf.h"

namespace marketgen::bench {
namespace {

// What the shelf of this row holds, said as a planogram says it.
plan::StockedShelf as_it_stands(const scene::Scene& scene, std::uint32_t shelf) {
  const scene::SceneShelf& row = scene.shelves[shelf];
  plan::StockedShelf said{
      scene.layout.fixtures[row.fixture].id, plan::shelf_side(row.side), row.level + 1, {}};
  for (const scene::Facing& facing : scene.facings) {
    if (facing.shelf != shelf) continue;
    said.blocks.push_back({scene.catalog[facing.sku].sku, facing.facings, {}, {}, {}});
  }
  return said;
}

// The first shelf on which packs stand in two blocks or more.
std::uint32_t shelf_with_blocks(const scene::Scene& scene) {
  for (std::size_t f = 0; f + 1 < scene.facings.size(); ++f) {
    const std::uint32_t shelf = scene.facings[f].shelf;
    if (scene.shelves[shelf].use == assets::ShelfUse::stand && scene.facings[f].facings > 1 &&
        scene.facings[f + 1].shelf == shelf)
      return shelf;
  }
  fatal("no shelf holds two blocks");
}

}  // namespace

Figures run_restock(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  const store::CreateOptions options = neighbourhood_store(scratch / "store", false);
  MARKETGEN_CHECK(store::create_store(options, catalog));
  MARKETGEN_TRY(const store::Store store, store::open_store(options.folder, catalog));
  plan::StockedShelf shelf = as_it_stands(store.scene, shelf_with_blocks(store.scene));
  plan::StockedShelf fewer = shelf;
  --fewer.blocks.front().facings;
  plan::Plan whole = store.plan, one = store.plan;
  whole.planogram = {shelf};
  one.planogram = {fewer};

  constexpr int runs = 25;
  Result<void> failed;
  // From the plan before and after: finding what changed, stocking it, and a scene of its own.
  const auto seconds = [&](const plan::Plan& before, const plan::Plan& after) {
    return median_seconds(runs, [&] {
      const auto changed = scene::shelves_changed(before, after, catalog, store.scene);
      if (!changed) fatal("the change reaches further than its shelf");
      const auto anew = scene::restocked(store.scene, *changed, after, catalog);
      if (!anew.ok()) failed = anew.error();
    });
  };
  const double shelf_s = seconds(store.plan, whole), facing_s = seconds(whole, one);
  const double all_s = median_seconds(runs, [&] {
    const auto scene = scene::build_scene(store.scene.layout, one, catalog, Seed(store.scene.seed));
    if (!scene.ok()) failed = scene.error();
  });
  MARKETGEN_CHECK(failed);
  const std::string machine = machine_name();
  const auto figure = [&](const char* name, double value, const char* unit, int n) {
    return Figure{name, value, unit, n, std::nullopt, std::nullopt, machine};
  };
  const auto products = static_cast<double>(store.scene.products.size());
  return std::vector<Figure>{figure("restock_products", products, "items", 1),
                             figure("restock_shelf_s", shelf_s, "s", runs),
                             figure("restock_facing_s", facing_s, "s", runs),
                             figure("restock_whole_store_s", all_s, "s", runs)};
}

}  // namespace marketgen::bench
