// Reads a planogram back by the names of its columns and holds it against the items of the scene,
// which know nothing of rows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "catalog/gtin.h"
#include "export/exporter.h"
#include "io/csv.h"
#include "io/file.h"
#include "scene/placements.h"

namespace marketgen::exporters {
namespace {

constexpr double price_tolerance = 5e-4;  // euro
constexpr int bay_tolerance_mm = 5;       // rounding of places to millimetres, and of gaps

// What the check needs of a row.
struct ReadPosition {
  std::string place;  // "shop.csv:12"
  std::string fixture, side, gtin, sku;
  double price = 0;
  int bay_width_mm = 0, shelf = 0, position = 0, x_mm = 0, z_mm = 0;
  std::array<int, 3> size_mm{};  // width, depth, height
  int facings_wide = 0, facings_high = 0, facings_deep = 0, capacity = 0, units = 0;
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

  template <class Number>
  Result<Number> number(const io::CsvRow& row, const std::string& column) const {
    MARKETGEN_TRY(const std::string cell, text(row, column));
    Number value = 0;
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
  const std::pair<const char*, std::string*> texts[] = {
      {"fixture", &read.fixture}, {"side", &read.side}, {"gtin", &read.gtin}, {"sku", &read.sku}};
  for (const auto& [column, value] : texts) {
    MARKETGEN_TRY(*value, columns.text(row, column));
  }
  const std::pair<const char*, int*> numbers[] = {{"bay_width_mm", &read.bay_width_mm},
                                                  {"shelf", &read.shelf},
                                                  {"position", &read.position},
                                                  {"x_mm", &read.x_mm},
                                                  {"z_mm", &read.z_mm},
                                                  {"width_mm", &read.size_mm[0]},
                                                  {"depth_mm", &read.size_mm[1]},
                                                  {"height_mm", &read.size_mm[2]},
                                                  {"facings_wide", &read.facings_wide},
                                                  {"facings_high", &read.facings_high},
                                                  {"facings_deep", &read.facings_deep},
                                                  {"capacity", &read.capacity},
                                                  {"units", &read.units}};
  for (const auto& [column, value] : numbers) {
    MARKETGEN_TRY(*value, columns.number<int>(row, column));
  }
  MARKETGEN_TRY(read.price, columns.number<double>(row, "price"));
  return read;
}

Result<void> check_counts(const ReadPosition& row) {
  if (row.units < 0 || row.units > row.capacity)
    return mismatch(row.place,
                    fmt::format("{} units stand where {} have room", row.units, row.capacity));
  const std::int64_t packs = std::int64_t{row.facings_wide} * row.facings_high * row.facings_deep;
  if (std::min({row.facings_wide, row.facings_high, row.facings_deep}) < 1 ||
      row.capacity != std::max<std::int64_t>(packs, row.units))
    return mismatch(row.place,
                    fmt::format("{} x {} x {} packs are no capacity of {}",
                                row.facings_wide,
                                row.facings_high,
                                row.facings_deep,
                                row.capacity));
  return {};
}

// Each row for itself: its product, its numbers and its room in the bay.
Result<void> check_position(const ReadPosition& row,
                            const std::map<std::string_view, const catalog::Product*>& products) {
  const auto found = products.find(row.sku);
  if (found == products.end())
    return mismatch(row.place, "the store has no product \"" + row.sku + "\"");
  const catalog::Product& product = *found->second;
  // None: what is sold by weight has no number.
  const bool is_gtin = row.gtin.empty() || catalog::is_ean13(row.gtin);
  if (!is_gtin || row.gtin != product.ean)
    return mismatch(row.place, "\"" + row.gtin + "\" is not the GTIN of \"" + row.sku + "\"");
  if (!std::ranges::equal(row.size_mm, product.size_mm))
    return mismatch(row.place, "\"" + row.sku + "\" is of another size");
  if (std::abs(row.price - product.price) > price_tolerance)
    return mismatch(row.place, fmt::format("{} is not the price of \"{}\"", row.price, row.sku));
  MARKETGEN_CHECK(check_counts(row));
  const int right = row.x_mm + row.facings_wide * row.size_mm[0];
  if (row.x_mm < -bay_tolerance_mm || right > row.bay_width_mm + bay_tolerance_mm || row.z_mm < 0)
    return mismatch(row.place,
                    fmt::format("it reaches from {} to {} mm in a bay {} mm wide, {} mm up",
                                row.x_mm,
                                right,
                                row.bay_width_mm,
                                row.z_mm));
  return {};
}

// Where goods stand, as both the file and the scene name it: fixture, side, number of the shelf,
// SKU of the block.
using ShelfAndSku = std::tuple<std::string, std::string, int, std::string>;
using UnitsByShelf = std::map<ShelfAndSku, std::int64_t>;

UnitsByShelf items_by_shelf(const scene::Scene& scene) {
  UnitsByShelf items;
  for (const scene::SceneProduct& item : scene.products) {
    if (item.facing == scene::no_facing) continue;
    const scene::Facing& facing = scene.facings[item.facing];
    const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
    ++items[{scene.layout.fixtures[shelf.fixture].id,
             shelf.side == 0 ? "front" : "back",
             shelf.level + 1,
             scene.catalog[facing.sku].sku}];
  }
  return items;
}

std::string in_words(const ShelfAndSku& place) {
  const auto& [fixture, side, shelf, sku] = place;
  return fmt::format("of \"{}\" on shelf {} of \"{}\", {}", sku, shelf, fixture, side);
}

// Empty blocks have rows, but no items.
Result<void> compare_units(const UnitsByShelf& items,
                           const UnitsByShelf& units,
                           const std::string& where) {
  for (const auto& [place, number] : items) {
    const auto read = units.find(place);
    const std::int64_t said = read == units.end() ? 0 : read->second;
    if (said != number)
      return mismatch(
          where,
          fmt::format("it has {} units {}, the store {} items", said, in_words(place), number));
  }
  for (const auto& [place, number] : units) {
    if (number > 0 && !items.contains(place))
      return mismatch(where, fmt::format("the store has nothing {}", in_words(place)));
  }
  return {};
}

// Each position of a shelf is there once.
Result<void> check_order(const std::vector<ReadPosition>& positions) {
  std::map<std::tuple<std::string, std::string, int, int>, std::string> places;
  for (const ReadPosition& row : positions) {
    const auto [first, is_new] =
        places.emplace(std::tuple{row.fixture, row.side, row.shelf, row.position}, row.place);
    if (!is_new || row.shelf < 1 || row.position < 1)
      return mismatch(
          row.place,
          fmt::format(
              "position {} of shelf {} is taken: {}", row.position, row.shelf, first->second));
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
  UnitsByShelf units;
  std::set<std::string> skus, fixtures;
  ExportSummary summary;
  for (const ReadPosition& position : positions) {
    MARKETGEN_CHECK(check_position(position, products));
    units[{position.fixture, position.side, position.shelf, position.sku}] += position.units;
    fixtures.insert(position.fixture);
    summary.units += static_cast<std::uint64_t>(position.units);
    skus.insert(position.sku);
  }
  MARKETGEN_CHECK(check_order(positions));
  MARKETGEN_CHECK(compare_units(items_by_shelf(scene), units, file.string()));
  summary.fixtures = fixtures.size();
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
