// marketgen assets: look into the asset library.
#include <fmt/format.h>

#include "assets/fixtures/fixture_model.h"
#include "assets/product_model.h"
#include "base/parallel.h"
#include "base/text.h"
#include "build_library.h"
#include "catalog/asset_database.h"
#include "catalog/full_name.h"
#include "command.h"
#include "import_asset.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "io/png.h"
#include "named_flag.h"
#include "number_flags.h"
#include "render/contact_sheet.h"
#include "render/fixture_picture.h"
#include "render/material_picture.h"
#include "render/picture_grid.h"
#include "say.h"
#include "scene/fixture_stage.h"
#include "settle_heaps.h"
#include "show_asset.h"

namespace marketgen::app {
namespace {

namespace fs = std::filesystem;

struct AssetFlags {
  CommonFlags common;
  catalog::AssetQuery query;
  ShownAsset shown;
  std::string folder;
  bool resume = false;
  ImportFlags import;
  std::vector<std::string> catalogs, only;
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
  catalog::AssetKind kind = catalog::AssetKind::goods;
  std::string id, sku, name, category;
  double score = 0, price = 0;
  static constexpr auto fields =
      field_list(field("kind", &SearchRow::kind, "goods, facility or material"),
                 field("id", &SearchRow::id, "SKU, fixture kind or material id"),
                 field("sku", &SearchRow::sku, "of goods"),
                 field("name", &SearchRow::name, "name"),
                 field("category", &SearchRow::category, "category of goods"),
                 field("score", &SearchRow::score, "rank; 0 without a text"),
                 field("price", &SearchRow::price, "euro, of goods"));
};

SearchRow row_of(const catalog::Catalog& catalog, const catalog::AssetHit& hit) {
  switch (hit.kind) {
    case catalog::AssetKind::goods: {
      const catalog::Product& p = catalog.products[hit.row];
      return {hit.kind, p.sku, p.sku, catalog::full_name(p), p.category, hit.score, p.price};
    }
    case catalog::AssetKind::facility: {
      const catalog::FixtureKind& k = catalog.fixture_kinds[hit.row];
      return {hit.kind, k.kind, "", k.name, "", hit.score, 0};
    }
    default: {
      const catalog::MaterialRow& m = catalog.materials[hit.row];
      return {hit.kind, m.id, "", m.name, "", hit.score, 0};
    }
  }
}

// Whether anything on the fixture moves.
Result<bool> is_articulated(const catalog::FixtureKind& kind, const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const scene::Scene stage, scene::stage_fixture(kind, catalog));
  return !stage.joints.empty();
}

Result<AssetList> list_of(const catalog::Catalog& catalog,
                          const std::vector<catalog::AssetHit>& hits) {
  AssetList list;
  list.archetypes = static_cast<int>(assets::archetypes().size());
  for (const catalog::CategoryRow& category : catalog.categories)
    list.by_category.push_back({category.id, 0});
  for (const catalog::AssetHit& hit : hits) {
    const SearchRow row = row_of(catalog, hit);
    std::string kind;
    if (hit.kind == catalog::AssetKind::goods) {
      ++list.goods;
      kind = catalog.products[hit.row].archetype;
      for (CategoryCount& c : list.by_category)
        c.products += c.category == row.category ? 1 : 0;
    } else if (hit.kind == catalog::AssetKind::facility) {
      ++list.facilities;
      kind = catalog.fixture_kinds[hit.row].generator;
      MARKETGEN_TRY(const bool moves, is_articulated(catalog.fixture_kinds[hit.row], catalog));
      list.articulated += moves ? 1 : 0;
    } else {
      ++list.materials;
      kind = name_of(catalog.materials[hit.row].pattern);
    }
    const std::string category =
        hit.kind == catalog::AssetKind::goods ? row.category : std::string(name_of(hit.kind));
    list.rows.push_back({row.id, row.name, kind, category});
  }
  return list;
}

Result<std::vector<catalog::AssetHit>> found_by(const AssetFlags& flags,
                                                const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const catalog::AssetDatabase database, catalog::AssetDatabase::open(catalog));
  return database.find(flags.query);
}

Result<void> list_assets(const AssetFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  MARKETGEN_TRY(const auto hits, found_by(flags, catalog));
  MARKETGEN_TRY(const AssetList list, list_of(catalog, hits));
  if (flags.common.json) {
    fmt::print("{}", io::write_json(list));
    return {};
  }
  say("{} goods of {} shapes, {} facilities ({} articulated), {} materials\n",
      list.goods,
      list.archetypes,
      list.facilities,
      list.articulated,
      list.materials);
  for (const CategoryCount& c : list.by_category)
    say("  {:<14} {:>5}\n", c.category, c.products);
  for (const AssetRow& row : list.rows)
    say("{:<48} {:<20} {:<14} {}\n", row.id, row.kind, row.category, row.name);
  return {};
}

Result<void> show_one(const AssetFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  ShownAsset shown = flags.shown;
  shown.size_px = flags.size_px;
  return show_asset(catalog, shown);
}

Result<void> search_assets(const AssetFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  MARKETGEN_TRY(const auto hits, found_by(flags, catalog));
  std::vector<SearchRow> rows;
  rows.reserve(hits.size());
  for (const catalog::AssetHit& hit : hits)
    rows.push_back(row_of(catalog, hit));
  if (flags.common.json) {
    fmt::print("{}", io::write_json(rows));
    return {};
  }
  constexpr std::size_t shown = 20;
  for (std::size_t i = 0; i < std::min(rows.size(), shown); ++i)
    say("{:>6.2f}  {:<9} {:<48} {}\n",
        rows[i].score,
        name_of(rows[i].kind),
        rows[i].id,
        rows[i].name);
  say("{} assets match \"{}\"\n", rows.size(), flags.query.text);
  return {};
}

Result<void> import_into(const AssetFlags& flags) {
  MARKETGEN_CHECK(probe_import(flags.import));
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  return import_one(flags.import, catalog, flags.common);
}

Result<void> save_sheet(const AssetFlags& flags, const std::string& name, const Image& sheet) {
  const fs::path file = fs::path(flags.folder) / (name + ".png");
  MARKETGEN_CHECK(io::write_png(file, sheet));  // at once: what is finished is kept
  if (!flags.common.quiet) say("picture     {}\n", file.string());
  return {};
}

Result<Image> facility_sheet(const catalog::Catalog& catalog, int size_px) {
  return render::picture_grid(
      catalog.fixture_kinds.size(), size_px, [&](std::size_t i) -> Result<Image> {
        MARKETGEN_TRY(const scene::Scene stage,
                      scene::stage_fixture(catalog.fixture_kinds[i], catalog));
        return render::draw_fixture(stage, size_px);
      });
}

Result<Image> goods_sheet(const catalog::Catalog& catalog,
                          const std::string& category,
                          int size_px) {
  std::vector<catalog::Product> products;
  for (const catalog::Product& p : catalog.products) {
    if (p.category == category) products.push_back(p);
  }
  return render::draw_contact_sheet(products, size_px);
}

// The sheets that are asked for, in the order in which they are drawn; all when none is named.
Result<std::vector<std::string>> sheet_names(const catalog::Catalog& catalog,
                                             const std::vector<std::string>& only) {
  std::vector<std::string> names;
  for (const catalog::CategoryRow& category : catalog.categories)
    names.push_back(category.id);
  names.insert(names.end(), {"facilities", "materials"});
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const std::string& name : only) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return Error{"usage.bad_flag",
                   "--only",
                   fmt::format("there is no sheet \"{}\"; sheets are: {}{}",
                               name,
                               fmt::join(known, ", "),
                               did_you_mean(name, known))};
  }
  return only.empty() ? names : only;
}

Result<void> draw_sheets(const AssetFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  MARKETGEN_TRY(const auto names, sheet_names(catalog, flags.only));
  io::Outputs folder;
  MARKETGEN_CHECK(folder.add_folder(flags.folder));
  for (const std::string& name : names) {
    MARKETGEN_TRY(const Image sheet,
                  name == "facilities" ? facility_sheet(catalog, flags.size_px)
                  : name == "materials"
                      ? render::draw_material_sheet(catalog.materials, flags.size_px)
                      : goods_sheet(catalog, name, flags.size_px));
    MARKETGEN_CHECK(save_sheet(flags, name, sheet));
  }
  return {};
}

using Action = Result<void> (*)(const AssetFlags&);

void add_filters(CLI::App& sub, AssetFlags& flags) {
  catalog::AssetQuery& q = flags.query;
  sub.add_option("--zone", q.zone, "what belongs in a zone type: dairy, snacks ...")
      ->type_name("ZONE");
  sub.add_option("--category", q.category, "category of goods")->type_name("CATEGORY");
  sub.add_option("--subcategory", q.subcategory, "shelf group of goods");
  sub.add_option("--archetype", q.archetype, "container shape, or generator of facilities")
      ->type_name("SHAPE");
  sub.add_option("--material", q.material, "contact material, or body material of facilities")
      ->type_name("MATERIAL");
  sub.add_option("--style", q.style, "what suits a style")->type_name("STYLE");
  sub.add_option("--storage", q.storage, "how it is kept")
      ->type_name(choice_of(names_of(catalog::Storage{})));
  const NumberCheck size_mm = real_number(0.1, 1e5);
  sub.add_option("--max-width-mm", q.max_width_mm, "no wider")->check(size_mm);
  sub.add_option("--max-depth-mm", q.max_depth_mm, "no deeper")->check(size_mm);
  sub.add_option("--max-height-mm", q.max_height_mm, "no higher")->check(size_mm);
  sub.add_option("--max-mass-kg", q.max_mass_kg, "no heavier")->check(real_number(1e-6, 1e4));
}

Result<void> build_all(const AssetFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  return build_library(catalog, flags.common);
}

Result<void> settle_all(const AssetFlags& flags) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows(flags.catalogs));
  return settle_heaps(catalog, flags.folder, flags.resume, flags.common);
}

void add_heaps(CLI::App& sub, AssetFlags& flags) {
  add_output(sub, "-o,--output", flags.folder, "JSON file to write")->required();
  sub.add_flag("--resume", flags.resume, "go on with a run that was broken off");
}

void add_show(CLI::App& sub, AssetFlags& flags) {
  sub.add_option("id", flags.shown.id, "SKU, fixture kind or material")
      ->type_name("ASSET")
      ->required();
  add_output(sub, "--picture", flags.shown.picture, "PNG or JPEG: three-quarter view");
  add_output(sub, "--label", flags.shown.label, "PNG or JPEG: the printed sheet");
  sub.add_option("--joint", flags.shown.joints, "NAME=STATE or NAME=NUMBER, all=open (repeatable)")
      ->type_name("JOINT");
  sub.add_option("--size", flags.size_px, "pixels a side")
      ->check(whole_number(64, 4096))
      ->capture_default_str();
}

void add_sheet(CLI::App& sub, AssetFlags& flags) {
  add_output(sub, "-o,--output", flags.folder, "folder for the pictures")->required();
  sub.add_option("--only", flags.only, "a category, facilities or materials (repeatable)")
      ->type_name("CATEGORY");
  sub.add_option("--pixels,--size", flags.size_px, "pixels an asset")
      ->check(whole_number(64, 1024))
      ->capture_default_str();
}

}  // namespace

Run add_assets(CLI::App& app) {
  auto flags = std::make_shared<AssetFlags>();
  auto action = std::make_shared<Action>(list_assets);
  CLI::App* command = app.add_subcommand(
      "assets", "The asset library: list, show, search, sheet, import, build, heaps");
  command->require_subcommand(1);
  const auto add = [&](const char* name, const char* what, Action run, Takes takes) {
    CLI::App* sub = command->add_subcommand(name, what);
    sub->callback([action, run] { *action = run; });
    sub->add_option("--catalog",
                    flags->catalogs,
                    "products of your own: CSV, JSON or asset.json (repeatable)")
        ->type_name("FILE");
    add_common_flags(*sub, flags->common, takes);
    return sub;
  };
  add_filters(*add("list", "Counts and rows", list_assets, Takes::json), *flags);
  add_show(*add("show", "One row, what follows from it, and its pictures", show_one, Takes::json),
           *flags);
  CLI::App* search =
      add("search", "Assets that match a text, best first", search_assets, Takes::json);
  search->add_option("text", flags->query.text, "words to look for")
      ->type_name("WORDS")
      ->required();
  add_filters(*search, *flags);
  add_sheet(*add("sheet",
                 "Contact sheets: goods by category, facilities, materials",
                 draw_sheets,
                 Takes::nothing),
            *flags);
  add_import_flags(
      *add("import",
           "Takes a GLB or OBJ model, or pictures of a pack, into a library of your own",
           import_into,
           Takes::json),
      flags->import);
  add("build", "Draws every label sheet into the cache", build_all, Takes::json);
  add_heaps(*add("heaps",
                 "Settles heaps of loose goods in MuJoCo: data/heaps.json",
                 settle_all,
                 Takes::nothing),
            *flags);
  command->footer("Example:  marketgen assets search \"something to clean windows\"");
  return [flags, action] {
    const auto done = (*action)(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
