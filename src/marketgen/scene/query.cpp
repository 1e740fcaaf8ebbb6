#include "scene/query.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/safe_line.h"
#include "base/text.h"
#include "catalog/country.h"
#include "catalog/full_name.h"
#include "io/csv.h"
#include "io/json.h"
#include "scene/placements.h"
#include "scene/planogram_rows.h"
#include "scene/query_tables.h"

namespace marketgen::scene {
namespace {

// ---- Rows of the tables; ProductQueryRow is in the header because others read it. ----

struct FixtureQueryRow {
  std::string id, run, kind, zone;
  double x_m = 0, y_m = 0;
  int yaw_deg = 0;
  double width_m = 0, depth_m = 0, height_m = 0;
  int levels = 0;
  std::uint64_t products = 0;
  static constexpr auto fields =
      field_list(field("id", &FixtureQueryRow::id, "id"),
                 field("run", &FixtureQueryRow::run, "run"),
                 field("kind", &FixtureQueryRow::kind, "kind"),
                 field("zone", &FixtureQueryRow::zone, "zone"),
                 field("x_m", &FixtureQueryRow::x_m, "east"),
                 field("y_m", &FixtureQueryRow::y_m, "north"),
                 field("yaw_deg", &FixtureQueryRow::yaw_deg, "0 = front faces south"),
                 field("width_m", &FixtureQueryRow::width_m, "width"),
                 field("depth_m", &FixtureQueryRow::depth_m, "depth"),
                 field("height_m", &FixtureQueryRow::height_m, "height"),
                 field("levels", &FixtureQueryRow::levels, "levels"),
                 field("products", &FixtureQueryRow::products, "items on it"));
};

struct ZoneQueryRow {
  std::string id, type, label;
  double area_m2 = 0;
  std::uint64_t fixtures = 0, products = 0;
  static constexpr auto fields = field_list(field("id", &ZoneQueryRow::id, "id"),
                                            field("type", &ZoneQueryRow::type, "type"),
                                            field("label", &ZoneQueryRow::label, "label"),
                                            field("area_m2", &ZoneQueryRow::area_m2, "floor area"),
                                            field("fixtures", &ZoneQueryRow::fixtures, "modules"),
                                            field("products", &ZoneQueryRow::products, "items"));
};

struct PriceQueryRow {
  std::string sku, ean, name, net;
  double price = 0, unit_price = 0;
  std::string per;
  bool promotion = false;
  std::uint64_t labels = 0, products = 0;
  std::string currency;
  static constexpr auto fields =
      field_list(field("sku", &PriceQueryRow::sku, "SKU"),
                 field("ean", &PriceQueryRow::ean, "EAN-13"),
                 field("name", &PriceQueryRow::name, "name"),
                 field("net", &PriceQueryRow::net, "net quantity"),
                 field("price", &PriceQueryRow::price, "in `currency`"),
                 field("unit_price", &PriceQueryRow::unit_price, "in `currency`, a unit"),
                 field("per", &PriceQueryRow::per, "unit"),
                 field("promotion", &PriceQueryRow::promotion, "has a promotion label"),
                 field("labels", &PriceQueryRow::labels, "price labels"),
                 field("products", &PriceQueryRow::products, "items"),
                 field("currency", &PriceQueryRow::currency, "ISO 4217"));
};

double rounded(double value, double step) {
  return std::round(value / step) * step;
}
double to_mm_precision(double metres) {
  return std::round(metres * 1e4) / 1e4;
}

std::vector<ProductQueryRow> product_rows(const Scene& scene) {
  std::vector<ProductQueryRow> rows;
  rows.reserve(scene.products.size());
  for (std::uint32_t i = 0; i < scene.products.size(); ++i) {
    const SceneProduct& item = scene.products[i];
    const catalog::Product& p = scene.catalog[item.sku];
    const Pose pose = world_from_product(item);
    ProductQueryRow row{product_id(scene, i),
                        p.sku,
                        p.ean,
                        catalog::full_name(p),
                        p.category,
                        "",
                        0,
                        "",
                        to_mm_precision(pose.position.x),
                        to_mm_precision(pose.position.y),
                        to_mm_precision(pose.position.z),
                        rounded(yaw_of(pose.rotation) * 180 / std::numbers::pi, 0.01),
                        p.price,
                        (item.flags & product_misplaced) != 0};
    if (item.facing != no_facing) {
      const SceneShelf& shelf = scene.shelves[scene.facings[item.facing].shelf];
      row.fixture = scene.layout.fixtures[shelf.fixture].id;
      row.zone = scene.layout.fixtures[shelf.fixture].zone;
      row.level = shelf.level;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::uint64_t products_on(const Scene& scene, std::uint32_t fixture) {
  std::uint64_t number = 0;
  for (const Facing& f : scene.facings)
    number += scene.shelves[f.shelf].fixture == fixture ? f.product_count : 0;
  return number;
}

std::vector<FixtureQueryRow> fixture_rows(const Scene& scene) {
  std::vector<FixtureQueryRow> rows;
  for (std::uint32_t i = 0; i < scene.fixtures.size(); ++i) {
    const layout::Fixture& f = scene.layout.fixtures[i];
    rows.push_back({f.id,
                    f.run,
                    f.kind,
                    f.zone,
                    f.x_mm * 1e-3,
                    f.y_mm * 1e-3,
                    f.yaw_deg,
                    f.width_mm * 1e-3,
                    f.depth_mm * 1e-3,
                    f.height_mm * 1e-3,
                    f.levels,
                    products_on(scene, i)});
  }
  return rows;
}

std::vector<ZoneQueryRow> zone_rows(const Scene& scene) {
  std::vector<ZoneQueryRow> rows;
  const std::vector<FixtureQueryRow> fixtures = fixture_rows(scene);
  for (const layout::LayoutZone& zone : scene.layout.zones) {
    ZoneQueryRow row{zone.id, zone.type, zone.label, zone.area_m2, 0, 0};
    for (const FixtureQueryRow& f : fixtures) {
      if (f.zone != zone.id) continue;
      ++row.fixtures;
      row.products += f.products;
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<PriceQueryRow> price_rows(const Scene& scene) {
  std::vector<PriceQueryRow> rows;
  for (const catalog::Product& p : scene.catalog) {
    const catalog::UnitPrice unit = catalog::unit_price(p);
    rows.push_back({p.sku,
                    p.ean,
                    catalog::full_name(p),
                    p.net,
                    p.price,
                    rounded(unit.price, 0.01),
                    std::string(unit.per),
                    false,
                    0,
                    0,
                    std::string(catalog::country_of(p).currency)});
  }
  for (const PriceLabel& label : scene.price_labels) {
    ++rows[label.sku].labels;
    rows[label.sku].promotion = rows[label.sku].promotion || label.promotion != 0;
  }
  for (const SceneProduct& item : scene.products)
    ++rows[item.sku].products;
  return rows;
}

// ---- Described rows to a text table. ----

ColumnKind kind_of(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::boolean:
      return ColumnKind::boolean;
    case TypeKind::integer:
    case TypeKind::number:
      return ColumnKind::number;
    case TypeKind::string:
    case TypeKind::enumeration:
      return ColumnKind::text;
    case TypeKind::object:
    case TypeKind::array:
    case TypeKind::optional:
      return ColumnKind::list;
  }
  fatal("no such kind of type");
}

std::string cell_of(const TypeInfo& type, const void* value) {
  if (type.kind == TypeKind::string) return *static_cast<const std::string*>(value);
  std::string json = io::write_json_line_of(type, value);
  if (type.kind != TypeKind::enumeration) return json;
  return json.substr(1, json.size() - 2);  // a plain word between its quotes
}

// ---- Filters. ----

struct Condition {
  std::size_t column;
  ColumnKind kind;
  std::string op, value;
};

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

bool holds(const Condition& condition, const std::string& cell) {
  if (condition.op == "~")
    return lower_ascii(cell).find(lower_ascii(condition.value)) != std::string::npos;
  const bool numbers = condition.kind == ColumnKind::number;
  const auto a = numbers ? number_in(cell) : std::nullopt;
  const auto b = numbers ? number_in(condition.value) : std::nullopt;
  const int order = a && b ? (*a < *b ? -1 : (*a > *b ? 1 : 0)) : cell.compare(condition.value);
  if (condition.op == "=") return order == 0;
  if (condition.op == "!=") return order != 0;
  if (condition.op == "<") return order < 0;
  if (condition.op == "<=") return order <= 0;
  if (condition.op == ">") return order > 0;
  return order >= 0;
}

// The first comparison in the text, the longer one where two start at the same place; empty when
// there is none.
std::string_view first_operator(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const std::string_view op : {"!=", "<=", ">=", "=", "<", ">", "~"}) {
      if (text.substr(at).starts_with(op)) return text.substr(at, op.size());
    }
  }
  return {};
}

// A value that no cell of the column can be compared with is a slip: it would keep nothing, or all.
Result<void> check_value(const Condition& condition,
                         const std::string& column,
                         const std::string& text) {
  if (condition.op == "~") return {};
  std::string expected;
  if (condition.kind == ColumnKind::number && !number_in(condition.value))
    expected = "numbers";
  else if (condition.kind == ColumnKind::boolean && condition.value != "true" &&
           condition.value != "false")
    expected = "true or false";
  else if (condition.kind == ColumnKind::list && condition.op != "=" && condition.op != "!=")
    return Error{"usage.bad_flag",
                 "--where " + text,
                 fmt::format("column \"{0}\" holds lists; ask with {0}~{1} what they contain",
                             column,
                             condition.value)};
  if (expected.empty()) return {};
  return Error{"usage.bad_flag",
               "--where " + text,
               fmt::format("\"{}\" stands at character {}, but column \"{}\" holds {}",
                           condition.value,
                           text.size() - condition.value.size() + 1,
                           column,
                           expected)};
}

Result<Condition> parse_condition(const std::string& text, const Table& table) {
  const std::string_view op = first_operator(text);
  if (op.empty()) {
    return Error{"usage.bad_flag",
                 "--where " + text,
                 "expected column=value (also != < <= > >= and ~ for \"contains\")"};
  }
  const auto at = static_cast<std::size_t>(op.data() - text.data());
  const std::string name = text.substr(0, at);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i] != name) continue;
    Condition condition{i, table.kinds[i], std::string(op), text.substr(at + op.size())};
    MARKETGEN_CHECK(check_value(condition, name, text));
    return condition;
  }
  const std::vector<std::string_view> names(table.columns.begin(), table.columns.end());
  return Error{"usage.bad_flag",
               "--where " + text,
               fmt::format("there is no column \"{}\"; columns are: {}{}",
                           name,
                           fmt::join(names, ", "),
                           did_you_mean(name, names))};
}

Result<void> filter(Table& table, std::string_view where) {
  if (where.empty()) return {};
  std::vector<Condition> conditions;
  for (const std::string& part : split(where, ',')) {
    MARKETGEN_TRY(Condition condition, parse_condition(part, table));
    conditions.push_back(std::move(condition));
  }
  std::erase_if(table.rows, [&](const std::vector<std::string>& row) {
    for (const Condition& c : conditions) {
      if (!holds(c, row[c.column])) return true;
    }
    return false;
  });
  return {};
}

// Text of others, in a table that spreadsheets and terminals open: what a spreadsheet would take
// for a formula gets an apostrophe before it, and nothing but a line break moves a cursor.
std::string text_cell(const std::string& text) {
  constexpr std::string_view formula_signs = "=+-@";
  std::vector<std::string> lines = split(text, '\n');
  for (std::string& line : lines)
    line = safe_line(line, std::string::npos);
  const std::string cell = fmt::format("{}", fmt::join(lines, "\n"));
  const bool formula = !cell.empty() && formula_signs.find(cell[0]) != std::string_view::npos;
  return io::csv_field(formula ? "'" + cell : cell);
}

}  // namespace

Table table_of(const TypeInfo& type, const void* rows, std::size_t count, std::size_t row_bytes) {
  Table table;
  for (const FieldInfo& f : type.fields) {
    table.columns.emplace_back(f.name);
    table.kinds.push_back(kind_of(f.type()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const void* row = static_cast<const std::byte*>(rows) + i * row_bytes;
    std::vector<std::string> cells;
    for (const FieldInfo& f : type.fields)
      cells.push_back(cell_of(f.type(), f.in(row)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Result<Table> query_scene(const Scene& scene, std::string_view name, std::string_view where) {
  Table table;
  if (name == "products")
    table = table_of(product_rows(scene));
  else if (name == "fixtures")
    table = table_of(fixture_rows(scene));
  else if (name == "zones")
    table = table_of(zone_rows(scene));
  else if (name == "prices")
    table = table_of(price_rows(scene));
  else if (name == "materials")
    table = table_of(scene.materials);
  else if (name == "planogram")
    table = table_of(planogram_rows(scene));
  else
    return catalog::unknown_name(
        "usage.bad_flag", "query", "table", name, {query_tables.begin(), query_tables.end()});
  MARKETGEN_CHECK(filter(table, where));
  return table;
}

std::string to_csv(const Table& table) {
  std::string out = fmt::format("{}\r\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool is_text = table.kinds[i] == ColumnKind::text;
      out += (i == 0 ? "" : ",") + (is_text ? text_cell(row[i]) : io::csv_field(row[i]));
    }
    out += "\r\n";
  }
  return out;
}

std::string to_json(const Table& table) {
  std::string out = "[";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    out += r == 0 ? "\n  {" : ",\n  {";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const std::string& cell = table.rows[r][i];
      const std::string text = table.kinds[i] != ColumnKind::text
                                   ? cell
                                   : io::write_json_line_of(type_of<std::string>(), &cell);
      out += fmt::format("{}\"{}\": {}", i == 0 ? "" : ", ", table.columns[i], text);
    }
    out += "}";
  }
  return out + "\n]\n";
}

}  // namespace marketgen::scene
