#include "scene/planogram_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/text.h"
#include "io/csv.h"
#include "scene/shelf_fill.h"
#include "scene/standing_shelf.h"
#include "scene/store_catalog.h"

namespace marketgen::scene {
namespace {

constexpr std::array<std::string_view, 10> read_columns = {"fixture",
                                                           "side",
                                                           "shelf",
                                                           "position",
                                                           "sku",
                                                           "gtin",
                                                           "x_mm",
                                                           "facings_wide",
                                                           "facings_high",
                                                           "facings_deep"};

Error bad_row(const std::string& where, std::string message) {
  return {"planogram.bad_row", where, std::move(message)};
}

// Where the columns stand that are read.
class PlanogramColumns {
 public:
  static Result<PlanogramColumns> of(const std::vector<std::string>& header,
                                     const std::string& source) {
    PlanogramColumns columns;
    for (std::size_t i = 0; i < header.size(); ++i) {
      const std::string name(trimmed(header[i]));
      const bool read = std::ranges::find(read_columns, name) != read_columns.end();
      if (read && !columns.places_.emplace(name, i).second)
        return bad_row(source + ":1", "two columns are called \"" + name + "\"; keep one");
    }
    for (const std::string_view needed : {"fixture", "shelf", "facings_wide"}) {
      if (!columns.places_.contains(std::string(needed)))
        return bad_row(source + ":1",
                       fmt::format("has no column \"{}\"; the columns are those of `marketgen "
                                   "export --format planogram`",
                                   needed));
    }
    if (!columns.places_.contains("sku") && !columns.places_.contains("gtin"))
      return bad_row(source + ":1", "has neither a column \"sku\" nor \"gtin\"");
    MARKETGEN_CHECK(columns.check_spelling(header, source));
    return columns;
  }

  // Empty where there is no such column.
  std::string cell(const io::CsvRow& row, std::string_view column) const {
    const auto place = places_.find(std::string(column));
    return place == places_.end() ? std::string() : std::string(trimmed(row.fields[place->second]));
  }

 private:
  // A column that looks like one which is read and is not there: a slip that would be passed over.
  Result<void> check_spelling(const std::vector<std::string>& header,
                              const std::string& source) const {
    std::vector<std::string_view> absent;
    for (const std::string_view name : read_columns) {
      if (!places_.contains(std::string(name))) absent.push_back(name);
    }
    const std::string place = source + ":1";
    for (const std::string& heading : header) {
      const std::string name(trimmed(heading));
      if (name.empty() || places_.contains(name)) continue;
      const std::string meant = did_you_mean(name, absent);
      if (!meant.empty())
        return bad_row(place, fmt::format("there is no column \"{}\"{}", name, meant));
    }
    return {};
  }

  std::map<std::string, std::size_t> places_;
};

// "351", "351.5" and "351,5", rounded; nothing when it is no number.
std::optional<int> number_of(std::string text) {
  std::ranges::replace(text, ',', '.');
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc() && end == text.data() + text.size();
  if (!whole || !(std::abs(value) <= 1e6)) return std::nullopt;
  return static_cast<int>(std::lround(value));
}

// A row, as a plan says it.
plan::ShelfBlock shelf_block(const PlanogramBlock& row, const catalog::Catalog& catalog) {
  return said_block({catalog.products[row.product].sku,
                     row.facings,
                     row.x_mm,
                     row.facings_high,
                     row.facings_deep},
                    catalog);
}

class PlanogramReader {
 public:
  PlanogramReader(const std::string& source,
                  const PlanogramColumns& columns,
                  const ShelfFinder& finder,
                  const catalog::Catalog& catalog)
      : source_(source), columns_(columns), finder_(finder), catalog_(catalog) {
    for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
      if (!catalog.products[i].ean.empty()) by_gtin_[catalog.products[i].ean] = i;
    }
  }

  void take(const io::CsvRow& row) {
    const std::size_t before = file_.refused.size();
    const std::string where = fmt::format("{}:{}:/", source_, row.line);
    PlanogramShelf* shelf = shelf_of(row, where);
    if (shelf == nullptr) return;
    const bool empty = columns_.cell(row, "sku").empty() && columns_.cell(row, "gtin").empty();
    const std::string facings = columns_.cell(row, "facings_wide");
    if (empty && (facings.empty() || facings == "0")) return;  // the shelf stays empty
    PlanogramBlock block;
    block.line = row.line;
    block.product = product_of(row, where);
    block.facings = whole(row, where, "facings_wide", {1, 200}).value_or(0);
    block.x_mm = whole(row, where, "x_mm", {-500, 10000});
    block.facings_high = whole(row, where, "facings_high", {1, 100});
    block.facings_deep = whole(row, where, "facings_deep", {1, 200});
    block.position = whole(row, where, "position", {1, 1000})
                         .value_or(static_cast<int>(shelf->blocks.size()) + 1);
    if (facings.empty())
      refuse(where + "facings_wide", "is empty; say how many stand side by side");
    check_position(*shelf, block.position, where);
    if (file_.refused.size() == before) shelf->blocks.push_back(block);
  }

  PlanogramFile finish() {
    for (auto& [place, shelf] : shelves_) {
      std::ranges::stable_sort(shelf.blocks, {}, &PlanogramBlock::position);
      plan_shelf(shelf);
      file_.shelves.push_back(std::move(shelf));
    }
    return std::move(file_);
  }

 private:
  void refuse(const std::string& where, std::string message) {
    file_.refused.push_back(bad_row(where, std::move(message)));
  }

  PlanogramShelf* shelf_of(const io::CsvRow& row, const std::string& where) {
    const std::string side = columns_.cell(row, "side");
    const std::optional<int> number = whole(row, where, "shelf", {1, 100});
    if (side != "front" && side != "back" && !side.empty()) {
      refuse(where + "side", "\"" + side + "\" is neither front nor back");
      return nullptr;
    }
    if (!number) {
      if (columns_.cell(row, "shelf").empty())
        refuse(where + "shelf", "is empty; shelves count from 1, the lowest");
      return nullptr;
    }
    const std::string fixture = columns_.cell(row, "fixture");
    const plan::ShelfSide of = side == "back" ? plan::ShelfSide::back : plan::ShelfSide::front;
    const Result<ShelfFinder::Found> found = finder_.find(fixture, of, *number, where);
    if (!found.ok()) {
      file_.refused.push_back(found.error());
      return nullptr;
    }
    const std::uint32_t index = finder_.bays()[found->bay].shelves[found->shelf];
    const auto [entry, is_new] = shelves_.try_emplace(index);
    if (is_new)
      entry->second = {index, fixture, of, *number, row.line, finder_.place(*found), {}, {}};
    return &entry->second;
  }

  // Nothing where the cell is empty; a fault is refused.
  std::optional<int> whole(const io::CsvRow& row,
                           const std::string& where,
                           std::string_view column,
                           IntRange range) {
    const std::string cell = columns_.cell(row, column);
    if (cell.empty()) return std::nullopt;
    const std::optional<int> number = number_of(cell);
    if (number && *number >= range[0] && *number <= range[1]) return number;
    refuse(where + std::string(column),
           fmt::format("\"{}\" is no number from {} to {}", cell, range[0], range[1]));
    return std::nullopt;
  }

  std::uint32_t product_of(const io::CsvRow& row, const std::string& where) {
    const std::string sku = columns_.cell(row, "sku"), gtin = columns_.cell(row, "gtin");
    const auto of_gtin = by_gtin_.find(gtin);
    if (sku.empty() && of_gtin != by_gtin_.end()) return of_gtin->second;
    if (sku.empty()) {
      refuse(where + "gtin",
             gtin.empty() ? "no product is named; give its sku or its gtin"
                          : "no product has the GTIN \"" + gtin +
                                "\"; name it by its sku, or bring its row with --catalog when "
                                "the store is generated");
      return 0;
    }
    const catalog::Product* product = catalog_.product(sku);
    if (product == nullptr) {
      std::vector<std::string_view> known;
      for (const catalog::Product& p : catalog_.products)
        known.push_back(p.sku);
      file_.refused.push_back(
          catalog::unknown_name("catalog.unknown_sku", where + "sku", "product", sku, known));
      return 0;
    }
    if (!gtin.empty() && gtin != product->ean)
      refuse(where + "gtin",
             fmt::format("{} is not the GTIN of \"{}\", which is {}; empty the one that is wrong",
                         gtin,
                         sku,
                         product->ean.empty() ? "none" : product->ean));
    return static_cast<std::uint32_t>(product - catalog_.products.data());
  }

  void check_position(const PlanogramShelf& shelf, int position, const std::string& where) {
    for (const PlanogramBlock& other : shelf.blocks) {
      if (other.position != position) continue;
      refuse(where + "position",
             fmt::format("{} is the position of line {}, too; count them from the left",
                         position,
                         other.line));
      return;
    }
  }

  void plan_shelf(PlanogramShelf& shelf) {
    std::vector<plan::ShelfBlock> blocks;
    for (const PlanogramBlock& block : shelf.blocks)
      blocks.push_back(shelf_block(block, catalog_));
    StockedShelf made = stocked_shelf(blocks, shelf.place, catalog_);
    for (ShelfFault& fault : made.faults) {
      const std::string column = fault.field == "facings" ? "facings_wide" : fault.field;
      file_.refused.push_back(
          {"planogram.does_not_fit",
           fmt::format("{}:{}:/{}", source_, shelf.blocks[fault.block].line, column),
           std::move(fault.message)});
    }
    shelf.planned = std::move(made.shelf);
  }

  const std::string& source_;
  const PlanogramColumns& columns_;
  const ShelfFinder& finder_;
  const catalog::Catalog& catalog_;
  std::map<std::string, std::uint32_t> by_gtin_;
  std::map<std::uint32_t, PlanogramShelf> shelves_;
  PlanogramFile file_;
};

// Facings of the scene by shelf, from left to right.
std::map<std::uint32_t, std::vector<const Facing*>> facings_by_shelf(const Scene& scene) {
  std::map<std::uint32_t, std::vector<const Facing*>> shelves;
  for (const Facing& facing : scene.facings)
    shelves[facing.shelf].push_back(&facing);
  return shelves;
}

bool stands_so(const PlanogramShelf& shelf,
               const std::vector<const Facing*>& facings,
               const Scene& scene,
               const catalog::Catalog& catalog) {
  const auto same = [&](const PlanogramBlock& said, const Facing* is) {
    const catalog::Product& product = catalog.products[said.product];
    const bool loose = lies_in_a_heap(product);
    return scene.catalog[is->sku].sku == product.sku && is->facings == said.facings &&
           (!said.x_mm || is_at(*said.x_mm, is->x_m + shelf.place.left_m)) &&
           (loose || !said.facings_high || *said.facings_high == is->stack) &&
           (loose || !said.facings_deep || *said.facings_deep == is->rows_deep);
  };
  return std::ranges::equal(shelf.blocks, facings, same);
}

}  // namespace

Result<PlanogramFile> read_planogram(std::string_view text,
                                     const std::string& source,
                                     const Scene& scene,
                                     const plan::Plan& plan,
                                     const catalog::Catalog& catalog) {
  MARKETGEN_TRY(const std::vector<io::CsvRow> rows, io::parse_csv(text, source));
  if (rows.size() < 2) return bad_row(source, "has no rows; the first line names the columns");
  MARKETGEN_TRY(const PlanogramColumns columns, PlanogramColumns::of(rows.front().fields, source));
  const StoreCatalog of_store(catalog, plan);
  const ShelfFinder finder(scene, plan, of_store.get());
  PlanogramReader reader(source, columns, finder, of_store.get());
  for (std::size_t i = 1; i < rows.size(); ++i)
    reader.take(rows[i]);
  return reader.finish();
}

Error refusal_of(const std::vector<Error>& refused) {
  Error error = refused.front();
  if (refused.size() > 1)
    error.message += fmt::format(" ({} more rows are refused)", refused.size() - 1);
  return error;
}

PlanogramChanges changes_by(const PlanogramFile& file,
                            const Scene& scene,
                            const plan::Plan& plan,
                            const catalog::Catalog& catalog) {
  PlanogramChanges changes;
  const StoreCatalog of_store(catalog, plan);
  auto facings = facings_by_shelf(scene);
  plan::StockShelves patch;
  for (const PlanogramShelf& shelf : file.shelves) {
    if (stands_so(shelf, facings[shelf.shelf], scene, catalog)) {
      ++changes.as_they_were;
      continue;
    }
    std::vector<plan::ShelfBlock> blocks;
    for (const PlanogramBlock& block : shelf.blocks)
      blocks.push_back(shelf_block(block, catalog));
    const plan::StockSpec& stock = stock_of(scene, shelf.shelf, plan);
    patch.shelves.push_back({shelf.fixture,
                             shelf.side,
                             shelf.number,
                             least_pinned(std::move(blocks), shelf.place, stock, of_store.get())});
  }
  if (patch.shelves.empty()) return changes;
  changes.patches.patches.emplace_back();
  changes.patches.patches.back().stock_shelves = std::move(patch);
  return changes;
}

}  // namespace marketgen::scene
