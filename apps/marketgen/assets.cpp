// marketgen assets: look into the asset library.
#include <fmt/format.h>

#include "assets/fixture_model.h"
#include "assets/label.h"
#include "assets/product_model.h"
#include "base/parallel.h"
#include "catalog/search.h"
#include "command.h"
#include "io/file.h"
#include "io/json.h"
#include "io/png.h"
#include "render/contact_sheet.h"

namespace marketgen::app {
namespace {

namespace fs = std::filesystem;

struct AssetFlags {
  CommonFlags common;
  std::string id, text, picture, label, folder;
  std::vector<std::string> catalogs;
  int size_px = 400;
};

struct CategoryCount {
  std::string category;
  int products = 0;
  static constexpr auto fields = field_list(field("category", &CategoryCount::category, "category"),
                                            field("products", &CategoryCount::products, "rows"));
};

struct AssetRow {
  std::string id, name, kind, category;
  static constexpr auto fields =
      field_list(field("id", &AssetRow::id, "SKU or fixture kind"),
                 field("name", &AssetRow::name, "name"),
                 field("kind", &AssetRow::kind, "archetype or generator"),
                 field("category", &AssetRow::category, "category, or facility"));
};

// What `list --json` prints.
struct AssetList {
  int goods = 0, facilities = 0, articulated = 0, materials = 0, archetypes = 0;
  std::vector<CategoryCount> by_category;
  std::vector<AssetRow> rows;
  static constexpr auto fields =
      field_list(field("goods", &AssetList::goods, "products"),
                 field("facilities", &AssetList::facilities, "fixture kinds"),
                 field("articulated", &AssetList::articulated, "facilities with joints"),
                 field("materials", &AssetList::materials, "materials"),
                 field("archetypes", &AssetList::archetypes, "container shapes"),
                 field("by_category", &AssetList::by_category, "products per category"),
                 field("rows", &AssetList::rows, "every asset"));
};

struct SearchRow {
  std::string sku, name, category;
  double score = 0, price = 0;
  static constexpr auto fields = field_list(field("sku", &SearchRow::sku, "SKU"),
                                            field("name", &SearchRow::name, "name"),
                                            field("category", &SearchRow::category, "category"),
                                            field("score", &SearchRow::score, "rank"),
                                            field("price", &SearchRow::price, "euro"));
};

std::string title_of(const Product& p) {
  return fmt::format("{}{}{}{}{}",
                     p.brand,
                     p.brand.empty() ? "" : " ",
                     p.name,
                     p.variant.empty() ? "" : " ",
                     p.variant);
}

AssetList list_of(const Catalog& catalog) {
  AssetList list;
  list.goods = static_cast<int>(catalog.products.size());
  list.facilities = static_cast<int>(catalog.fixture_kinds.size());
  list.materials = static_cast<int>(catalog.materials.size());
  list.archetypes = static_cast<int>(archetypes().size());
  for (const CategoryRow& category : catalog.categories)
    list.by_category.push_back({category.id, 0});
  for (const Product& p : catalog.products) {
    for (CategoryCount& c : list.by_category)
      c.products += c.category == p.category ? 1 : 0;
    list.rows.push_back({p.sku, title_of(p), p.archetype, p.category});
  }
  for (const FixtureKind& k : catalog.fixture_kinds)
    list.rows.push_back({k.kind, k.name, k.generator, "facility"});
  return list;
}

Result<void> list_assets(const AssetFlags& flags) {
  MARKETGEN_TRY(const Catalog catalog, load_rows(flags.catalogs));
  const AssetList list = list_of(catalog);
  if (flags.common.json) {
    fmt::print("{}", write_json(list));
    return {};
  }
  fmt::print("{} goods of {} shapes, {} facilities, {} materials\n",
             list.goods,
             list.archetypes,
             list.facilities,
             list.materials);
  for (const CategoryCount& c : list.by_category)
    fmt::print("  {:<14} {:>5}\n", c.category, c.products);
  for (const AssetRow& row : list.rows)
    fmt::print("{:<48} {:<20} {:<14} {}\n", row.id, row.kind, row.category, row.name);
  return {};
}

Result<const Product*> product_called(const Catalog& catalog, const std::string& id) {
  if (const Product* product = catalog.product(id)) return product;
  std::vector<std::string_view> names;
  for (const Product& p : catalog.products)
    names.push_back(p.sku);
  return unknown_name("catalog.unknown_sku", id, "product", id, names);
}

Result<void> show_asset(const AssetFlags& flags) {
  MARKETGEN_TRY(const Catalog catalog, load_rows(flags.catalogs));
  if (const FixtureKind* kind = catalog.fixture_kind(flags.id);
      kind != nullptr && flags.picture.empty() && flags.label.empty()) {
    fmt::print("{}", write_json(*kind));
    return {};
  }
  MARKETGEN_TRY(const Product* product, product_called(catalog, flags.id));
  if (!flags.picture.empty()) {
    MARKETGEN_TRY(const Image picture, draw_product(*product, flags.size_px));
    MARKETGEN_CHECK(write_png(flags.picture, picture));
  }
  if (!flags.label.empty()) {
    constexpr int label_px = 1024;
    MARKETGEN_TRY(const Image label, draw_label(*product, label_px));
    MARKETGEN_CHECK(write_png(flags.label, label));
  }
  fmt::print("{}", write_json(*product));
  return {};
}

Result<void> search_assets(const AssetFlags& flags) {
  MARKETGEN_TRY(const Catalog catalog, load_rows(flags.catalogs));
  std::vector<SearchRow> rows;
  for (const SearchHit& hit : search_products(catalog, flags.text)) {
    const Product& p = catalog.products[hit.product];
    rows.push_back({p.sku, title_of(p), p.category, hit.score, p.price});
  }
  if (flags.common.json) {
    fmt::print("{}", write_json(rows));
    return {};
  }
  constexpr std::size_t shown = 20;
  for (std::size_t i = 0; i < std::min(rows.size(), shown); ++i)
    fmt::print("{:>5.2f}  {:<48} {:<36} {:>6.2f}\n",
               rows[i].score,
               rows[i].sku,
               rows[i].name,
               rows[i].price);
  fmt::print("{} products match \"{}\"\n", rows.size(), flags.text);
  return {};
}

Result<void> draw_sheets(const AssetFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const Catalog catalog, load_rows(flags.catalogs));
  std::error_code failed;
  fs::create_directories(flags.folder, failed);
  if (failed) return Error{"io.cannot_write", flags.folder, failed.message()};
  for (const CategoryRow& category : catalog.categories) {
    std::vector<Product> products;
    for (const Product& p : catalog.products) {
      if (p.category == category.id) products.push_back(p);
    }
    MARKETGEN_TRY(const Image sheet, draw_contact_sheet(products, flags.size_px));
    const fs::path file = fs::path(flags.folder) / (category.id + ".png");
    MARKETGEN_CHECK(write_png(file, sheet));
    if (!flags.common.quiet) fmt::print("picture     {}\n", file.string());
  }
  return {};
}

using Action = Result<void> (*)(const AssetFlags&);

}  // namespace

Run add_assets(CLI::App& app) {
  auto flags = std::make_shared<AssetFlags>();
  auto action = std::make_shared<Action>(list_assets);
  CLI::App* command =
      app.add_subcommand("assets", "Look into the asset library: list, show, search, sheet");
  command->require_subcommand(1);
  const auto add = [&](const char* name, const char* what, Action run, Takes takes) {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->callback([action, run] { *action = run; });
    sub->add_option(
        "--catalog", flags->catalogs, "JSON file with products of your own (repeatable)");
    add_common_flags(*sub, flags->common, takes);
    return sub;
  };
  add("list", "Counts and rows", list_assets, Takes::json);
  CLI::App* show = add("show", "One row, and its pictures", show_asset, Takes::json);
  show->add_option("id", flags->id, "SKU or fixture kind")->required();
  show->add_option("--picture", flags->picture, "PNG: three-quarter view");
  show->add_option("--label", flags->label, "PNG: the printed sheet");
  show->add_option("--size", flags->size_px, "pixels a side")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  CLI::App* search =
      add("search", "Products that match a text, best first", search_assets, Takes::json);
  search->add_option("text", flags->text, "words to look for")->required();
  CLI::App* sheet =
      add("sheet", "Contact sheets, one picture a category", draw_sheets, Takes::nothing);
  sheet->add_option("-o,--output", flags->folder, "folder for the pictures")->required();
  sheet->add_option("--size", flags->size_px, "pixels a product")
      ->check(CLI::Range(64, 1024))
      ->capture_default_str();
  command->footer("Example:  marketgen assets search \"something to clean windows\"");
  return [flags, action] {
    const auto done = (*action)(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
