// Tables about a scene, for `query` and the planogram file: one described row type per table.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::scene {

struct ProductQueryRow {
  std::string id, sku, ean, name, category, fixture;
  int level = 0;
  std::string zone;
  double x_m = 0, y_m = 0, z_m = 0, yaw_deg = 0, price = 0;
  bool misplaced = false;

  static constexpr auto fields =
      field_list(field("id", &ProductQueryRow::id, "item id"),
                 field("sku", &ProductQueryRow::sku, "SKU"),
                 field("ean", &ProductQueryRow::ean, "EAN-13"),
                 field("name", &ProductQueryRow::name, "brand and name"),
                 field("category", &ProductQueryRow::category, "category"),
                 field("fixture", &ProductQueryRow::fixture, "fixture id"),
                 field("level", &ProductQueryRow::level, "shelf level, 0 = lowest"),
                 field("zone", &ProductQueryRow::zone, "zone id"),
                 field("x_m", &ProductQueryRow::x_m, "east"),
                 field("y_m", &ProductQueryRow::y_m, "north"),
                 field("z_m", &ProductQueryRow::z_m, "up"),
                 field("yaw_deg", &ProductQueryRow::yaw_deg, "0 = front faces south"),
                 field("price", &ProductQueryRow::price, "in the store's money"),
                 field("misplaced", &ProductQueryRow::misplaced, "stands in the wrong place"));
};

// What the cells of a column hold; those of a list, and no others but text, are JSON.
enum class ColumnKind { text, number, boolean, list };

// A table as text cells, ready for CSV or JSON.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<ColumnKind> kinds;  // per column
};

// One column a field of the described rows; `rows` are `count` objects of `row_bytes` each.
Table table_of(const TypeInfo& type, const void* rows, std::size_t count, std::size_t row_bytes);
template <class Row>
Table table_of(const std::vector<Row>& rows) {
  return table_of(type_of<Row>(), rows.data(), rows.size(), sizeof(Row));
}

// `table` is products, fixtures, zones, prices, materials or planogram. `where` keeps rows of which
// every "column=value" (also != < > <= >= ~ for "contains") holds, separated by commas. Errors:
// usage.bad_flag with the nearest name, or for a value that the column cannot have.
Result<Table> query_scene(const Scene& scene, std::string_view name, std::string_view where);
// RFC 4180. Texts that a spreadsheet would take for a formula (= + - @) get an apostrophe before
// them; control characters but line breaks are written out (safe_line). Numbers and JSON stay as
// they are.
std::string to_csv(const Table& table);
std::string to_json(const Table& table);  // array of objects, one per line

}  // namespace marketgen::scene
