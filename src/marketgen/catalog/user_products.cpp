#include "catalog/user_products.h"

#include <charconv>
#include <map>

#include <fmt/format.h>

#include "base/inherited_fields.h"
#include "base/text.h"
#include "catalog/asset_file.h"
#include "catalog/catalog.h"
#include "catalog/own_faces.h"
#include "catalog/own_mesh.h"
#include "catalog/usual_pack.h"
#include "io/csv.h"
#include "io/field_check.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::catalog {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t max_bytes = 64U << 20;

// A row as it is written, with nothing where Product has a default that depends on what it is.
constexpr double no_friction = 0;
struct OwnRow : Product {
  OwnRow() {
    material.clear();
    friction = no_friction;
  }
  static constexpr auto fields = inherited_fields<OwnRow>(Product::fields);
};

// ---- CSV: each line becomes the JSON text of a row, so that there is one reader of rows. ----

struct Column {
  std::string parent, name;  // "label" and "primary"; no parent for a field of the row itself
  const TypeInfo* type = nullptr;
};

const FieldInfo* field_called(const TypeInfo& type, std::string_view name) {
  for (const FieldInfo& field : type.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

// The type of the fields within this one: of "label", and of "contents", which may be absent. Null
// when it has none.
const TypeInfo* object_in(const FieldInfo& field) {
  const TypeInfo& type = field.type();
  const TypeInfo& held = type.kind == TypeKind::optional ? type.element() : type;
  return held.kind == TypeKind::object ? &held : nullptr;
}

// Names that a column may have, as "label.primary".
std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const FieldInfo& field : type_of<Product>().fields) {
    const TypeInfo* object = object_in(field);
    if (object == nullptr) {
      names.emplace_back(field.name);
      continue;
    }
    for (const FieldInfo& inner : object->fields)
      names.push_back(std::string(field.name) + "." + std::string(inner.name));
  }
  return names;
}

Result<Column> column_called(const std::string& heading, const std::string& where) {
  Column column;
  const std::size_t dot = heading.find('.');
  const TypeInfo* type = &type_of<Product>();
  if (dot != std::string::npos) {
    column.parent = heading.substr(0, dot);
    const FieldInfo* parent = field_called(*type, column.parent);
    type = parent == nullptr ? nullptr : object_in(*parent);
  }
  column.name = dot == std::string::npos ? heading : heading.substr(dot + 1);
  const FieldInfo* field = type == nullptr ? nullptr : field_called(*type, column.name);
  if (field == nullptr || object_in(*field) != nullptr) {
    const std::vector<std::string> names = column_names();
    Error error =
        unknown_name("json.unknown_field", where, "column", heading, {names.begin(), names.end()});
    return error;
  }
  column.type = &field->type();
  return column;
}

bool is_number(std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && text[0] != '.' &&
         text.find_first_of("infa") == std::string_view::npos;
}

Result<std::string> json_value(const TypeInfo& type,
                               const std::string& text,
                               const std::string& where) {
  if (type.kind == TypeKind::optional) return json_value(type.element(), text, where);
  if (type.kind == TypeKind::string || type.kind == TypeKind::enumeration)
    return io::write_json_line(text);
  if (type.kind == TypeKind::array) {
    std::string list;
    for (const std::string& part : split(text, type.fixed_count > 0 ? 'x' : ';')) {
      const std::string one(trimmed(part));
      if (one.empty()) continue;
      MARKETGEN_TRY(const std::string value, json_value(type.element(), one, where));
      list += (list.empty() ? "" : ", ") + value;
    }
    return "[" + list + "]";
  }
  if (is_number(text)) return text;
  return Error{"json.wrong_type", where, "expected a number, found \"" + text.substr(0, 40) + "\""};
}

Result<Product> product_of(const io::CsvRow& row,
                           const std::vector<Column>& columns,
                           const std::string& source) {
  const std::string where = fmt::format("{}:{}", source, row.line);
  std::map<std::string, std::string> objects;  // fields of the row (""), of its label
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string text(trimmed(row.fields[i]));
    if (text.empty()) continue;  // the field keeps its default
    const Column& column = columns[i];
    MARKETGEN_TRY(const std::string value,
                  json_value(*column.type, text, where + ":/" + column.name));
    std::string& object = objects[column.parent];
    object += fmt::format("{}\"{}\": {}", object.empty() ? "" : ", ", column.name, value);
  }
  std::string& json = objects[""];
  for (const auto& [name, fields] : objects) {
    if (!name.empty())
      json += fmt::format("{}\"{}\": {{{}}}", json.empty() ? "" : ", ", name, fields);
  }
  MARKETGEN_TRY(OwnRow own, io::read_json<OwnRow>("{" + json + "}", where));
  return Product(std::move(own));
}

Result<std::vector<Product>> products_of_csv(std::string_view text, const std::string& source) {
  MARKETGEN_TRY(const std::vector<io::CsvRow> rows, io::parse_csv(text, source));
  std::vector<Product> products;
  if (rows.empty()) return products;
  if (auto fault = io::fault_of_count(rows.size() - 1, {}))
    return Error{std::string(fault->code), source, std::move(fault->message)};
  std::vector<Column> columns;
  for (const std::string& heading : rows[0].fields) {
    MARKETGEN_TRY(const Column column, column_called(std::string(trimmed(heading)), source + ":1"));
    columns.push_back(column);
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    MARKETGEN_TRY(Product product, product_of(rows[i], columns, source));
    products.push_back(std::move(product));
  }
  return products;
}

// ---- JSON. ----

Result<std::vector<Product>> products_of_json(const std::string& text, const std::string& source) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || text[start] != '{') {
    MARKETGEN_TRY(std::vector<OwnRow> rows, io::read_json<std::vector<OwnRow>>(text, source));
    return std::vector<Product>(rows.begin(), rows.end());
  }
  MARKETGEN_TRY(AssetFile asset, io::read_json<AssetFile>(text, source));
  return std::vector<Product>{std::move(asset.product)};
}

Result<void> keep_own_mesh(Product& product, const fs::path& folder, const std::string& source) {
  const std::string where = source + ":" + product.sku;
  if (product.archetype != mesh_archetype) {
    if (product.mesh.empty()) return {};
    return Error{
        "catalog.bad_row",
        where + "/mesh",
        fmt::format("has a mesh, but its archetype is \"{}\"; write \"mesh\"", product.archetype)};
  }
  if (product.mesh.empty())
    return Error{"catalog.bad_row", where + "/mesh", "archetype mesh needs the name of a file"};
  MARKETGEN_TRY(const fs::path file, io::path_within(folder, product.mesh, where + "/mesh"));
  MARKETGEN_TRY(product.mesh, keep_mesh(file, product));
  return {};
}

}  // namespace

void fill_in(Product& own,
             const std::vector<Product>& rows,
             const std::vector<FrictionRow>& frictions) {
  if (own.material.empty()) own.material = usual_material(rows, own);
  if (own.friction != no_friction) return;
  const FrictionRow* row = friction_on_steel(frictions, own.material);
  own.friction = row != nullptr ? row->sliding : Product().friction;
}

Result<std::vector<Product>> read_user_products(const fs::path& file) {
  const std::string source = file.filename().string();
  MARKETGEN_TRY(const std::string text, io::read_file(file, max_bytes));
  const bool csv = lower_ascii(file.extension().string()) == ".csv";
  MARKETGEN_TRY(std::vector<Product> products,
                csv ? products_of_csv(text, source) : products_of_json(text, source));
  for (Product& product : products) {
    MARKETGEN_CHECK(keep_own_mesh(product, file.parent_path(), source));
    MARKETGEN_CHECK(keep_faces(product, file.parent_path(), source + ":" + product.sku));
  }
  return products;
}

}  // namespace marketgen::catalog
