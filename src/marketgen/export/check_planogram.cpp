// Reads a planogram back by the names of its columns and holds it against the items of the scene,
// which know nothing of rows.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "export/exporter.h"
#include "io/csv.h"
#include "io/file.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr int bay_tolerance_mm = 5;  // rounding of places to millimetres, and of gaps

// What the check needs of a row.
struct ReadPosition {
  std::string place;  // "shop.csv:12"
  std::string fixture, gtin, sku;
  int bay_width_mm = 0, x_mm = 0, width_mm = 0, facings_wide = 0, capacity = 0, units = 0;
};

class Columns {
 public:
  Columns(const std::vector<std::string>& header, std::string file) : file_(std::move(file)) {
    for (std::size_t i = 0; i < header.size(); ++i)
      places_[header[i]] = i;
  }

  Result<std::string> text(const io::CsvRow& row, const std::string& column) const {
    const auto found = places_.find(column);
    if (found == places_.end()) return mismatch(file_, "it has no column \"" + column + "\"");
    return row.fields[found->second];
  }

  Result<int> number(const io::CsvRow& row, const std::string& column) const {
    MARKETGEN_TRY(const std::string cell, text(row, column));
    int value = 0;
    const auto [end, failed] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (failed != std::errc() || end != cell.data() + cell.size())
      return mismatch(place(row), "\"" + cell + "\" in column \"" + column + "\" is no number");
    return value;
  }

  std::string place(const io::CsvRow& row) const { return fmt::format("{}:{}", file_, row.line); }

 private:
  std::string file_;
  std::map<std::string, std::size_t> places_;
};

Result<ReadPosition> position_in(const io::CsvRow& row, const Columns& columns) {
  ReadPosition read;
  read.place = columns.place(row);
  MARKETGEN_TRY(read.fixture, columns.text(row, "fixture"));
  MARKETGEN_TRY(read.gtin, columns.text(row, "gtin"));
  MARKETGEN_TRY(read.sku, columns.text(row, "sku"));
  MARKETGEN_TRY(read.bay_width_mm, columns.number(row, "bay_width_mm"));
  MARKETGEN_TRY(read.x_mm, columns.number(row, "x_mm"));
  MARKETGEN_TRY(read.width_mm, columns.number(row, "width_mm"));
  MARKETGEN_TRY(read.facings_wide, columns.number(row, "facings_wide"));
  MARKETGEN_TRY(read.capacity, columns.number(row, "capacity"));
  MARKETGEN_TRY(read.units, columns.number(row, "units"));
  return read;
}

// A GTIN-13 whose last digit is right (GS1 General Specifications, 7.9), or none: what is sold by
// weight has no number.
bool is_gtin(const std::string& text) {
  if (text.empty()) return true;
  if (text.size() != 13) return false;
  int sum = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') return false;
    sum += (text[i] - '0') * (i % 2 == 0 ? 1 : 3);
  }
  return sum % 10 == 0;
}

// Each row for itself: its product, its numbers and its room in the bay.
Result<void> check_position(const ReadPosition& row,
                            const std::map<std::string_view, const catalog::Product*>& products) {
  const auto product = products.find(row.sku);
  if (product == products.end())
    return mismatch(row.place, "the store has no product \"" + row.sku + "\"");
  if (!is_gtin(row.gtin) || row.gtin != product->second->ean)
    return mismatch(row.place, "\"" + row.gtin + "\" is not the GTIN of \"" + row.sku + "\"");
  if (row.units < 0 || row.units > row.capacity)
    return mismatch(row.place,
                    fmt::format("{} units stand where {} have room", row.units, row.capacity));
  const int right = row.x_mm + row.facings_wide * row.width_mm;
  if (row.x_mm < -bay_tolerance_mm || right > row.bay_width_mm + bay_tolerance_mm)
    return mismatch(
        row.place,
        fmt::format(
            "it reaches from {} to {} mm in a bay {} mm wide", row.x_mm, right, row.bay_width_mm));
  return {};
}

// Items that stand in blocks, by the fixture that carries them.
std::map<std::string, std::int64_t> items_by_fixture(const scene::Scene& scene) {
  std::map<std::string, std::int64_t> items;
  for (const scene::SceneProduct& item : scene.products) {
    if (item.facing == scene::no_facing) continue;
    const scene::SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
    ++items[scene.layout.fixtures[shelf.fixture].id];
  }
  return items;
}

// Without fixtures of which every block is empty: scenes count items, not rows.
Result<void> compare_units(const std::map<std::string, std::int64_t>& wanted,
                           const std::map<std::string, std::int64_t>& found,
                           const std::string& where) {
  for (const auto& [fixture, units] : wanted) {
    const auto read = found.find(fixture);
    const std::int64_t number = read == found.end() ? 0 : read->second;
    if (number != units)
      return mismatch(
          where,
          fmt::format("it has {} units on \"{}\", the store {} items", number, fixture, units));
  }
  for (const auto& [fixture, units] : found) {
    if (units > 0 && !wanted.contains(fixture))
      return mismatch(where, "the store has nothing on \"" + fixture + "\"");
  }
  return {};
}

Result<std::vector<ReadPosition>> read_positions(const std::filesystem::path& file) {
  const std::string where = file.string();
  MARKETGEN_TRY(const std::string bytes, io::read_file(file));
  if (!bytes.ends_with("\r\n")) return mismatch(where, "its last row is cut off");
  const Result<std::vector<io::CsvRow>> rows = io::parse_csv(bytes, where);
  if (!rows.ok() && rows.error().code == "input.too_large") return rows.error();
  if (!rows.ok()) return mismatch(where, "it is no CSV: " + rows.error().message);
  if (rows->empty()) return mismatch(where, "it has no header");
  const Columns columns(rows->front().fields, where);
  std::vector<ReadPosition> positions;
  for (std::size_t i = 1; i < rows->size(); ++i) {
    MARKETGEN_TRY(ReadPosition position, position_in((*rows)[i], columns));
    positions.push_back(std::move(position));
  }
  return positions;
}

}  // namespace

Result<ExportSummary> check_planogram(const scene::Scene& scene,
                                      const std::filesystem::path& file,
                                      const ExportOptions&) {
  MARKETGEN_TRY(const std::vector<ReadPosition> positions, read_positions(file));
  if (positions.size() != scene.facings.size())
    return mismatch(
        file.string(),
        fmt::format("it has {} rows, the store {} blocks", positions.size(), scene.facings.size()));
  std::map<std::string_view, const catalog::Product*> products;
  for (const catalog::Product& product : scene.catalog)
    products.emplace(product.sku, &product);
  std::map<std::string, std::int64_t> units;
  std::set<std::string> skus;
  ExportSummary summary;
  for (const ReadPosition& position : positions) {
    MARKETGEN_CHECK(check_position(position, products));
    units[position.fixture] += position.units;
    summary.units += static_cast<std::uint64_t>(position.units);
    skus.insert(position.sku);
  }
  MARKETGEN_CHECK(compare_units(items_by_fixture(scene), units, file.string()));
  summary.fixtures = units.size();
  summary.products = summary.units;
  summary.skus = skus.size();
  summary.blocks = positions.size();
  summary.in_words = fmt::format("{} blocks of {} products on {} fixtures; {} items stand in them",
                                 summary.blocks,
                                 summary.skus,
                                 summary.fixtures,
                                 summary.units);
  return summary;
}

}  // namespace marketgen::exporters
