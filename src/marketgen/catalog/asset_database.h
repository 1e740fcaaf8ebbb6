// The asset database: goods, facilities and materials in SQLite with full-text search (FTS5), asked
// by zone, category, size, temperature, style and free text.
//
// Ranking of free text, the only one there is:
//   1. The text is cut into words. Words of SearchLexicon::skip ("something", "to") are dropped; a
//      run of Chinese characters is a word, and so is each pair of neighbours in a run of more than
//      two. Plurals and endings do not matter (Porter stemming), nor do case and accents.
//   2. One, two or three neighbouring words that are `say` of an intent may also be what it means:
//      "wash dishes" is also "dish soap". A group is one word, or two or three with such a meaning.
//   3. A group scores a row by the best of: its words themselves; one of its meanings, times 0.6
//      when it is a single English word; rows with a word that begins so (three letters or more)
//      times 0.3. The score of words is
//      BM25 (Robertson and Zaragoza 2009; k1 = 1.2, b = 0.75) with the column weights name 5,
//      Chinese name 5, variant 2, brand 2, keywords 3, subcategory 3, category 1, description 0.5.
//      Characters of a Chinese word that stand apart count 0.5 of the word.
//   4. A row scores the sum of its groups times the share of the groups that matched, and half as
//      much again when every word of its name is in the question, or in what a saying means: "milk"
//      is milk before it is milk rolls.
//   5. "without X" asks for "X free", "no X", "zero X" or "without X", and leaves out rows that
//      mention X otherwise.
//   6. Ties: goods, then facilities, then materials; within each by id.
// The answer depends on the rows and the question only.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "io/sqlite.h"

namespace marketgen::catalog {

enum class AssetKind { goods, facility, material };
constexpr std::array<std::string_view, 3> names_of(AssetKind) {
  return {"goods", "facility", "material"};
}

// Everything that is set must hold; the empty query is every asset. A limit on size, mass, storage
// or archetype leaves out assets that have none.
struct AssetQuery {
  std::string text{};              // ranked, see above
  std::vector<AssetKind> kinds{};  // empty: all
  std::string zone{};              // zone type: belongs_to() in catalog/zone_goods.h
  std::string category{}, subcategory{};
  std::string archetype{};  // of goods; of facilities, their generator
  std::string material{};   // contact material of goods, body material of facilities
  std::string style{};      // materials of the style, facilities built in them, and whatever has
                            // one of the style's keywords among its own words
  std::string storage{};    // ambient, chilled or frozen
  int max_width_mm = 0, max_depth_mm = 0, max_height_mm = 0;  // 0: no limit
  double max_mass_kg = 0;                                     // 0: no limit
};

struct AssetHit {
  AssetKind kind = AssetKind::goods;
  std::uint32_t row = 0;  // of catalog.products, .fixture_kinds or .materials
  double score = 0;       // 0 without a text
};

// Belongs to one thread at a time.
class AssetDatabase {
 public:
  // Made in memory from the catalogue's rows.
  static Result<AssetDatabase> build(const Catalog& catalog);
  // As `build`, kept under $MARKETGEN_CACHE/assets by the hash of everything it is made of; a
  // damaged file or a cache that cannot be written only costs time.
  static Result<AssetDatabase> open(const Catalog& catalog);

  // Best first; without a text by kind and id. Errors: input.not_utf8, catalog.unknown_kind (zone,
  // category, style, storage), io.database.
  Result<std::vector<AssetHit>> find(const AssetQuery& query) const;

  const io::SqlDatabase& sql() const { return sql_; }

 private:
  AssetDatabase(io::SqlDatabase sql, SearchLexicon lexicon)
      : sql_(std::move(sql)), lexicon_(std::move(lexicon)) {}

  io::SqlDatabase sql_;
  SearchLexicon lexicon_;
};

}  // namespace marketgen::catalog
