#include "store/report_page.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "audit/metrics.h"
#include "base/text.h"
#include "io/jpeg.h"
#include "io/png.h"
#include "layout/layout_picture.h"

namespace marketgen::store {
namespace {

constexpr int layout_px = 1100;

std::string counted(std::uint64_t number, std::string_view what) {
  return fmt::format("{} {}", with_thousands(static_cast<std::int64_t>(number)), what);
}

Result<std::vector<PagePicture>> pictures_of(const Store& store, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(std::string layout,
                io::encode_png(layout::draw_layout(store.scene.layout, catalog, layout_px)));
  std::vector<PagePicture> pictures{{"Layout", "image/png", std::move(layout)}};
  for (const FileDigest& file : store.manifest.files) {
    const std::filesystem::path path = file.path;
    if (path.parent_path() != "previews" || path.extension() != ".png") continue;
    MARKETGEN_TRY(const Image picture, io::read_png(store.folder / path));
    MARKETGEN_TRY(std::string bytes, io::encode_jpeg(picture));  // a tenth of the PNG
    pictures.push_back({path.stem().string(), "image/jpeg", std::move(bytes)});
  }
  return pictures;
}

std::vector<PlotBar> fill_by_zone(const scene::Scene& scene) {
  std::map<std::string, double> width_m, stocked_m;
  const auto zone_of = [&](std::uint32_t shelf) -> const std::string& {
    return scene.layout.fixtures[scene.shelves[shelf].fixture].zone;
  };
  for (std::uint32_t shelf = 0; shelf < scene.shelves.size(); ++shelf)
    width_m[zone_of(shelf)] += scene.shelves[shelf].width_m;
  for (const scene::Facing& facing : scene.facings)
    stocked_m[zone_of(facing.shelf)] += facing.product_count > 0 ? facing.width_m : 0;
  std::vector<PlotBar> bars;
  for (const auto& [zone, width] : width_m) {
    const double share = width > 0 ? stocked_m[zone] / width : 0;
    bars.push_back({zone, share, fmt::format("{:.0f} % of {:.0f} m", 100 * share, width)});
  }
  return bars;
}

std::vector<PlotBar> items_by_category(const scene::Scene& scene) {
  std::map<std::string, std::uint64_t> count;
  for (const scene::SceneProduct& item : scene.products)
    ++count[scene.catalog[item.sku].category];
  std::uint64_t most = 1;
  for (const auto& [category, items] : count)
    most = std::max(most, items);
  std::vector<PlotBar> bars;
  for (const auto& [category, items] : count)
    bars.push_back({category,
                    static_cast<double>(items) / static_cast<double>(most),
                    counted(items, "items")});
  std::ranges::stable_sort(bars, std::greater<>(), &PlotBar::share);
  return bars;
}

}  // namespace

Result<StorePage> page_of(const Store& store, StoreReport report, const catalog::Catalog& catalog) {
  StorePage page;
  page.manifest = store.manifest;
  page.report = std::move(report);
  MARKETGEN_TRY(page.pictures, pictures_of(store, catalog));
  page.fill = fill_by_zone(store.scene);
  page.categories = items_by_category(store.scene);
  std::vector<bool> stands(store.scene.catalog.size(), false);
  for (const scene::SceneProduct& item : store.scene.products)
    stands[item.sku] = true;
  for (std::size_t sku = 0; sku < stands.size(); ++sku) {
    if (!stands[sku]) continue;
    page.prices_eur.push_back(store.scene.catalog[sku].price);
    page.masses_kg.push_back(store.scene.catalog[sku].mass_kg);
  }
  return page;
}

}  // namespace marketgen::store
