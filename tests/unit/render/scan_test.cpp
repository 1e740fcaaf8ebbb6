// Bar codes as the renderer shows them, read by an outside decoder (zbar).
//
// MARKETGEN_SCAN=all takes every SKU, MARKETGEN_SCAN=pouch every one of that archetype; otherwise a
// few of every archetype.
// MARKETGEN_SCAN_PICTURES keeps the pictures in that folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "io/file.h"
#include "support/bar_faces.h"

namespace marketgen {
namespace {

constexpr double min_share = 0.98;

std::string setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Products with an EAN: all, or the first, middle and last of every archetype by size.
std::vector<catalog::Product> products_to_scan() {
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  std::map<std::string, std::vector<catalog::Product>> of_archetype;
  for (const catalog::Product& product : catalog.products) {
    if (!product.ean.empty()) of_archetype[product.archetype].push_back(product);
  }
  const std::string wanted = setting("MARKETGEN_SCAN");
  std::vector<catalog::Product> chosen;
  for (auto& [archetype, products] : of_archetype) {
    std::stable_sort(
        products.begin(), products.end(), [](const catalog::Product& a, const catalog::Product& b) {
          return a.mass_kg < b.mass_kg;
        });
    const std::size_t last = products.size() - 1;
    if (!wanted.empty() && wanted != "all" && wanted != archetype) continue;
    if (!wanted.empty())
      chosen.insert(chosen.end(), products.begin(), products.end());
    else
      for (const std::size_t i : std::set<std::size_t>{0, last / 2, last})
        chosen.push_back(products[i]);
  }
  return chosen;
}

// Renders one batch and returns the codes read, by SKU.
std::map<std::string, std::string> read_batch(const BarStage& stage,
                                              const std::filesystem::path& folder) {
  const auto renderer = render::Renderer::create(stage.scene).value();
  render::RenderOptions options;
  options.quality = render::Quality::fast;
  std::vector<std::filesystem::path> files;
  for (const render::Camera& camera : stage.cameras) {
    files.push_back(folder / (camera.name + ".png"));
    EXPECT_TRUE(io::write_png(files.back(), renderer->render(camera, options)->color).ok());
  }
  return scanned(files);
}

TEST(SlowBarCodes, AScannerReadsThemOnTheRenderedPack) {
  const std::vector<catalog::Product> products = products_to_scan();
  const ScratchFolder scratch;
  const std::string kept = setting("MARKETGEN_SCAN_PICTURES");
  const std::filesystem::path folder = kept.empty() ? scratch.path() : std::filesystem::path(kept);
  std::filesystem::create_directories(folder);
  std::size_t right = 0;
  constexpr std::size_t batch = 150;
  for (std::size_t from = 0; from < products.size(); from += batch) {
    const std::size_t to = std::min(products.size(), from + batch);
    const BarStage stage = bar_stage({products.begin() + static_cast<std::ptrdiff_t>(from),
                                      products.begin() + static_cast<std::ptrdiff_t>(to)});
    for (const std::string& sku : stage.without_face)
      std::printf("no bars on its mesh: %s\n", sku.c_str());
    const auto codes = read_batch(stage, folder);
    for (const catalog::Product& product : stage.scene.catalog) {
      const auto found = codes.find(product.sku);
      const bool reads = found != codes.end() && found->second == product.ean;
      right += reads ? 1 : 0;
      if (!reads)
        std::printf("not read: %s (%s)\n", product.sku.c_str(), product.archetype.c_str());
    }
  }
  std::printf("%zu of %zu bar codes read\n", right, products.size());
  EXPECT_GE(static_cast<double>(right), min_share * static_cast<double>(products.size()));
}

}  // namespace
}  // namespace marketgen
