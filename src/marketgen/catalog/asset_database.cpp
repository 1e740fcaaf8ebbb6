#include "catalog/asset_database.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/hash.h"
#include "catalog/search_words.h"
#include "catalog/zone_goods.h"
#include "io/cache_entry.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::catalog {
namespace {

// Goes up whenever the tables or what stands in them change.
constexpr std::string_view table_version = "assets-1";

// `id` is the order in which equals are listed. `words` has one row an asset and `sayings` one an
// intent's `say` and `means`; both stem English and fold accents.
constexpr const char* tables = R"sql(
  CREATE TABLE assets(id INTEGER PRIMARY KEY, kind INTEGER, row INTEGER, asset TEXT, category TEXT,
    subcategory TEXT, archetype TEXT, material TEXT, storage TEXT, width_mm INTEGER,
    depth_mm INTEGER, height_mm INTEGER, mass_kg REAL, name_words INTEGER);
  CREATE TABLE asset_zones(zone TEXT, asset INTEGER, PRIMARY KEY(zone, asset)) WITHOUT ROWID;
  CREATE TABLE asset_styles(style TEXT, asset INTEGER, PRIMARY KEY(style, asset)) WITHOUT ROWID;
  CREATE TABLE names(list TEXT, name TEXT, PRIMARY KEY(list, name)) WITHOUT ROWID;
  CREATE VIRTUAL TABLE words USING fts5(name, name_zh, variant, brand, keywords, subcategory,
    category, description, tokenize = 'porter unicode61 remove_diacritics 2');
  CREATE VIRTUAL TABLE sayings USING fts5(say, means UNINDEXED, tokens UNINDEXED,
    tokenize = 'porter unicode61 remove_diacritics 2');
)sql";

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts)
    text += part + "; ";  // the semicolon keeps phrases from running over two keywords
  return text;
}

// "dry_goods" is searched as "dry goods".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

template <class Row>
std::vector<std::uint32_t> order_by(const std::vector<Row>& rows, std::string Row::*key) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < rows.size(); ++i)
    order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return rows[a].*key < rows[b].*key;
  });
  return order;
}

// Fills the tables of one database.
class Filler {
 public:
  static Result<void> fill(io::SqlDatabase& sql, const Catalog& catalog) {
    MARKETGEN_CHECK(sql.run("BEGIN"));
    MARKETGEN_CHECK(sql.run(tables));
    Filler filler(catalog);
    MARKETGEN_CHECK(filler.prepare(sql));
    MARKETGEN_CHECK(filler.add_goods());
    MARKETGEN_CHECK(filler.add_facilities());
    MARKETGEN_CHECK(filler.add_materials());
    MARKETGEN_CHECK(filler.add_names());
    MARKETGEN_CHECK(filler.add_styles());
    MARKETGEN_CHECK(filler.add_sayings());
    MARKETGEN_CHECK(sql.run("INSERT INTO words(words) VALUES('optimize')"));
    return sql.run("COMMIT");
  }

 private:
  explicit Filler(const Catalog& catalog) : catalog_(catalog) {}

  Result<void> prepare(const io::SqlDatabase& sql) {
    const auto make = [&](std::optional<io::SqlStatement>& statement,
                          const char* text) -> Result<void> {
      MARKETGEN_TRY(io::SqlStatement made, sql.prepare(text));
      statement = std::move(made);
      return {};
    };
    MARKETGEN_CHECK(make(asset_, "INSERT INTO assets VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
    MARKETGEN_CHECK(make(words_,
                         "INSERT INTO words(rowid, name, name_zh, variant, brand, keywords, "
                         "subcategory, category, description) VALUES(?,?,?,?,?,?,?,?,?)"));
    MARKETGEN_CHECK(make(zone_, "INSERT INTO asset_zones VALUES(?,?)"));
    MARKETGEN_CHECK(make(name_, "INSERT OR IGNORE INTO names VALUES(?,?)"));
    MARKETGEN_CHECK(make(saying_, "INSERT INTO sayings VALUES(?,?,?)"));
    MARKETGEN_CHECK(make(style_of_material_,
                         "INSERT OR IGNORE INTO asset_styles SELECT ?1, id FROM assets WHERE "
                         "(kind = 2 AND asset = ?2) OR (kind = 1 AND material = ?2)"));
    return make(style_of_words_,
                "INSERT OR IGNORE INTO asset_styles SELECT ?1, rowid FROM words WHERE words "
                "MATCH ?2");
  }

  // The columns that every asset has; the others stay empty until they are bound.
  io::SqlStatement& start_asset(AssetKind kind, std::uint32_t row, const std::string& id) {
    return asset_->start()
        .bind(1, ++id_)
        .bind(2, static_cast<std::int64_t>(kind))
        .bind(3, std::int64_t{row})
        .bind(4, id);
  }

  Result<void> add_zone(const ZoneTypeRow& zone) {
    return zone_->start().bind(1, zone.type).bind(2, id_).run();
  }

  static std::int64_t words_in(const std::string& name) {
    return static_cast<std::int64_t>(search_words_of(name).size());
  }

  Result<void> add_goods() {
    for (std::uint32_t row : order_by(catalog_.products, &Product::sku)) {
      const Product& p = catalog_.products[row];
      MARKETGEN_CHECK(start_asset(AssetKind::goods, row, p.sku)
                          .bind(5, p.category)
                          .bind(6, p.subcategory)
                          .bind(7, p.archetype)
                          .bind(8, p.material)
                          .bind(9, name_of(p.storage))
                          .bind(10, std::int64_t{p.size_mm[0]})
                          .bind(11, std::int64_t{p.size_mm[1]})
                          .bind(12, std::int64_t{p.size_mm[2]})
                          .bind(13, p.mass_kg)
                          .bind(14, words_in(p.name))
                          .run());
      MARKETGEN_CHECK(words_->start()
                          .bind(1, id_)
                          .bind(2, p.name)
                          .bind(3, with_spaced_characters(p.name_zh))
                          .bind(4, p.variant)
                          .bind(5, p.brand)
                          .bind(6, joined(p.keywords))
                          .bind(7, p.subcategory)
                          .bind(8, spoken(p.category))
                          .bind(9, p.description)
                          .run());
      for (const ZoneTypeRow& zone : catalog_.zone_types) {
        if (belongs_to(zone, p, catalog_)) MARKETGEN_CHECK(add_zone(zone));
      }
    }
    return {};
  }

  Result<void> add_facilities() {
    for (std::uint32_t row : order_by(catalog_.fixture_kinds, &FixtureKind::kind)) {
      const FixtureKind& k = catalog_.fixture_kinds[row];
      MARKETGEN_CHECK(start_asset(AssetKind::facility, row, k.kind)
                          .bind(7, k.generator)
                          .bind(8, k.material)
                          .bind(9, name_of(k.temperature))
                          .bind(10, std::int64_t{k.module_widths_mm.at(0)})
                          .bind(11, std::int64_t{k.depth_mm})
                          .bind(12, std::int64_t{k.height_mm})
                          .bind(14, words_in(k.name))
                          .run());
      MARKETGEN_CHECK(words_->start()
                          .bind(1, id_)
                          .bind(2, k.name)
                          .bind(6, joined(k.keywords) + joined(k.tags))
                          .bind(7, spoken(k.generator))
                          .bind(8, "facility fixture")
                          .run());
      for (const ZoneTypeRow& zone : catalog_.zone_types) {
        if (belongs_to(zone, k, catalog_)) MARKETGEN_CHECK(add_zone(zone));
      }
    }
    return {};
  }

  Result<void> add_materials() {
    for (std::uint32_t row : order_by(catalog_.materials, &MaterialRow::id)) {
      const MaterialRow& m = catalog_.materials[row];
      MARKETGEN_CHECK(start_asset(AssetKind::material, row, m.id).bind(14, words_in(m.name)).run());
      MARKETGEN_CHECK(words_->start()
                          .bind(1, id_)
                          .bind(2, m.name)
                          .bind(6, joined(m.uses))
                          .bind(7, spoken(std::string(name_of(m.pattern))))
                          .bind(8, "material")
                          .run());
    }
    return {};
  }

  Result<void> add_name(std::string_view list, const std::string& name) {
    return name_->start().bind(1, list).bind(2, name).run();
  }

  Result<void> add_names() {
    for (const ZoneTypeRow& zone : catalog_.zone_types)
      MARKETGEN_CHECK(add_name("zone type", zone.type));
    for (const StyleRow& style : catalog_.styles)
      MARKETGEN_CHECK(add_name("style", style.id));
    for (const CategoryRow& category : catalog_.categories)
      MARKETGEN_CHECK(add_name("category", category.id));
    for (const std::string_view storage : names_of(Storage{}))
      MARKETGEN_CHECK(add_name("storage", std::string(storage)));
    return {};
  }

  Result<void> add_styles() {
    for (const StyleRow& style : catalog_.styles) {
      for (const std::string* material :
           {&style.floor, &style.wall, &style.ceiling, &style.fixture})
        MARKETGEN_CHECK(style_of_material_->start().bind(1, style.id).bind(2, *material).run());
      for (const std::string& keyword : style.keywords) {
        std::vector<std::string> tokens;
        for (const SearchWord& word : search_words_of(keyword))
          tokens.insert(tokens.end(), word.tokens.begin(), word.tokens.end());
        MARKETGEN_CHECK(
            style_of_words_->start().bind(1, style.id).bind(2, phrase_expression(tokens)).run());
      }
    }
    return {};
  }

  Result<void> add_sayings() {
    for (const SearchIntent& intent : catalog_.search_lexicon.intents) {
      for (const std::string& say : intent.say) {
        std::size_t tokens = 0;
        for (const SearchWord& word : search_words_of(say))
          tokens += word.tokens.size();
        for (const std::string& means : intent.means)
          MARKETGEN_CHECK(saying_->start()
                              .bind(1, with_spaced_characters(say))
                              .bind(2, means)
                              .bind(3, static_cast<std::int64_t>(tokens))
                              .run());
      }
    }
    return {};
  }

  const Catalog& catalog_;
  std::int64_t id_ = 0;  // of the asset added last
  std::optional<io::SqlStatement> asset_, words_, zone_, name_, saying_, style_of_material_,
      style_of_words_;
};

constexpr std::string_view assets_kind = "assets/2";

std::filesystem::path cache_file(const Catalog& catalog) {
  Hasher hash;
  hash.add(assets_kind)
      .add(table_version)
      .add(io::SqlDatabase::engine_version())
      .add(catalog.content_hash);
  hash.add(io::write_json_line(catalog.search_lexicon));
  return io::cache_folder() / "assets" / (hash.hex() + ".sqlite");
}

}  // namespace

Result<AssetDatabase> AssetDatabase::build(const Catalog& catalog) {
  MARKETGEN_TRY(io::SqlDatabase sql, io::SqlDatabase::create());
  MARKETGEN_CHECK(Filler::fill(sql, catalog));
  return AssetDatabase(std::move(sql), catalog.search_lexicon);
}

Result<AssetDatabase> AssetDatabase::open(const Catalog& catalog) {
  if (catalog.content_hash.empty()) return build(catalog);
  const std::filesystem::path file = cache_file(catalog);
  if (const std::optional<std::string> bytes = io::kept_entry(file, assets_kind)) {
    if (Result<io::SqlDatabase> sql = io::SqlDatabase::open(*bytes); sql.ok())
      return AssetDatabase(std::move(sql).value(), catalog.search_lexicon);
    else
      io::drop_entry(file, sql.error().message);
  }
  MARKETGEN_TRY(AssetDatabase database, build(catalog));
  MARKETGEN_TRY(const std::string bytes, database.sql_.bytes());
  (void)io::keep_entry(file, assets_kind, bytes).ok();
  return database;
}

}  // namespace marketgen::catalog
