#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "io/json.h"

namespace marketgen::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

void add_limits(OrderedJson& schema, const FieldRules& rules) {
  if (std::isfinite(rules.min)) schema["minimum"] = rules.min;
  if (std::isfinite(rules.max)) schema["maximum"] = rules.max;
}

// Rules of a field apply to the elements of an array; structs go to $defs once each.
class JsonSchemaWriter {
 public:
  OrderedJson schema_of(const TypeInfo& type, const FieldRules& rules) {
    OrderedJson schema;
    switch (type.kind) {
      case TypeKind::boolean:
        schema["type"] = "boolean";
        break;
      case TypeKind::integer:
        schema["type"] = "integer";
        add_limits(schema, rules);
        if (!type.is_signed && !schema.contains("minimum")) schema["minimum"] = 0;
        break;
      case TypeKind::number:
        schema["type"] = "number";
        add_limits(schema, rules);
        break;
      case TypeKind::string:
        schema = string_schema(rules);
        break;
      case TypeKind::enumeration:
        schema["enum"] = type.names;
        break;
      case TypeKind::array:
        schema = array_schema(type, rules);
        break;
      case TypeKind::optional:
        schema["anyOf"] =
            OrderedJson::array({schema_of(type.element(), rules), OrderedJson{{"type", "null"}}});
        break;
      case TypeKind::object:
        define(type);
        schema["$ref"] = "#/$defs/" + type.name;
        break;
    }
    return schema;
  }

  OrderedJson object_schema(const TypeInfo& type) {
    OrderedJson schema{{"type", "object"}, {"additionalProperties", false}};
    OrderedJson properties = OrderedJson::object();
    OrderedJson needed = OrderedJson::array();
    for (const FieldInfo& f : type.fields) {
      OrderedJson property = schema_of(f.type(), f.rules);
      property["description"] = f.doc;
      add_default(property, f, type);
      if (f.rules.required) needed.push_back(f.name);
      properties[std::string(f.name)] = std::move(property);
    }
    schema["properties"] = std::move(properties);
    if (!needed.empty()) schema["required"] = std::move(needed);
    return schema;
  }

  const std::map<std::string, OrderedJson>& definitions() const { return definitions_; }

 private:
  static OrderedJson string_schema(const FieldRules& rules) {
    OrderedJson schema{{"type", "string"}};
    if (!rules.constant.empty()) schema["const"] = rules.constant;
    if (rules.identifier)
      schema["pattern"] =
          rules.required ? "^[A-Za-z0-9][A-Za-z0-9_./-]*$" : "^([A-Za-z0-9][A-Za-z0-9_./-]*)?$";
    schema["maxLength"] = rules.max_length;
    return schema;
  }

  OrderedJson array_schema(const TypeInfo& type, FieldRules rules) {
    OrderedJson schema{{"type", "array"}};
    if (type.fixed_count != 0) {
      schema["minItems"] = type.fixed_count;
      schema["maxItems"] = type.fixed_count;
    } else {
      schema["maxItems"] = rules.max_items;
    }
    rules.max_items = FieldRules{}.max_items;
    schema["items"] = schema_of(type.element(), rules);
    return schema;
  }

  static void add_default(OrderedJson& property, const FieldInfo& f, const TypeInfo& owner) {
    const TypeInfo& type = f.type();
    if (f.rules.required || type.kind == TypeKind::object || type.kind == TypeKind::optional)
      return;
    property["default"] = OrderedJson::parse(write_json_line_of(type, f.in(owner.defaults)));
  }

  void define(const TypeInfo& type) {
    if (!seen_.insert(type.name).second) return;
    definitions_[type.name] = object_schema(type);
  }

  std::set<std::string> seen_;
  std::map<std::string, OrderedJson> definitions_;
};

// ---- Markdown ----

std::string type_text(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::boolean:
      return "true or false";
    case TypeKind::integer:
      return "whole number";
    case TypeKind::number:
      return "number";
    case TypeKind::string:
      return "text";
    case TypeKind::enumeration:
      return fmt::format("one of `{}`", fmt::join(type.names, "` `"));
    case TypeKind::object:
      return fmt::format("[{}](#{})", type.name, type.name);
    case TypeKind::optional:
      return type_text(type.element()) + ", may be absent";
    case TypeKind::array:
      return type.fixed_count == 0
                 ? "list of " + type_text(type.element())
                 : fmt::format("{} x {}", type.fixed_count, type_text(type.element()));
  }
  return {};
}

std::string limits_text(const FieldRules& rules) {
  std::string text;
  if (std::isfinite(rules.min) && std::isfinite(rules.max))
    text = fmt::format("{} to {}", rules.min, rules.max);
  else if (std::isfinite(rules.min))
    text = fmt::format("at least {}", rules.min);
  else if (std::isfinite(rules.max))
    text = fmt::format("at most {}", rules.max);
  if (rules.required) text += text.empty() ? "required" : "; required";
  return text;
}

void append_markdown(std::string& out, const TypeInfo& type, std::set<std::string>& seen) {
  if (type.kind == TypeKind::array || type.kind == TypeKind::optional)
    return append_markdown(out, type.element(), seen);
  if (type.kind != TypeKind::object || !seen.insert(type.name).second) return;
  out += fmt::format(
      "### {}\n\n| field | type | default | limits | meaning |\n|---|---|---|---|---|\n",
      type.name);
  for (const FieldInfo& f : type.fields) {
    const TypeInfo& field_type = f.type();
    const bool plain = field_type.kind != TypeKind::object &&
                       field_type.kind != TypeKind::optional && !f.rules.required;
    const std::string fallback =
        plain ? "`" + write_json_line_of(field_type, f.in(type.defaults)) + "`" : "";
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n",
                       f.name,
                       type_text(field_type),
                       fallback,
                       limits_text(f.rules),
                       f.doc);
  }
  out += "\n";
  for (const FieldInfo& f : type.fields)
    append_markdown(out, f.type(), seen);
}

}  // namespace

std::string json_schema_of(const TypeInfo& type, std::string_view id, std::string_view title) {
  JsonSchemaWriter writer;
  OrderedJson schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"$id", id}, {"title", title}};
  schema.update(type.kind == TypeKind::object ? writer.object_schema(type)
                                              : writer.schema_of(type, {}));
  OrderedJson definitions = OrderedJson::object();
  for (const auto& [name, definition] : writer.definitions())
    definitions[name] = definition;
  if (!definitions.empty()) schema["$defs"] = std::move(definitions);
  return schema.dump(2) + "\n";
}

std::string markdown_of(const TypeInfo& type) {
  std::string out;
  std::set<std::string> seen;
  append_markdown(out, type, seen);
  return out;
}

}  // namespace marketgen::io
