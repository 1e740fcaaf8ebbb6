#include "io/field_check.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace marketgen::io {
namespace {

using MaybeFault = std::optional<FieldFault>;

FieldFault out_of_range(std::string message) {
  return {"json.out_of_range", std::move(message)};
}

bool is_identifier(std::string_view text) {
  const auto letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  if (text.empty() || !letter_or_digit(text[0]) || text.find("..") != std::string_view::npos)
    return false;
  for (const char c : text) {
    if (!letter_or_digit(c) && c != '_' && c != '-' && c != '.' && c != '/') return false;
  }
  return true;
}

double largest_of(const TypeInfo& type) {
  const bool single = type.kind == TypeKind::number && type.size == sizeof(float);
  return single ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
}

// A fault and where it is below the value that was asked about.
struct Found {
  FieldFault fault;
  std::string pointer;

  Found below(std::string_view step) && {
    std::string longer = "/";
    longer.append(step).append(pointer);
    return {std::move(fault), std::move(longer)};
  }
};

std::optional<Found> find_fault(const TypeInfo& type, const FieldRules& rules, const void* value);

std::optional<Found> fault_in_fields(const TypeInfo& type, const void* object) {
  for (const FieldInfo& field : type.fields) {
    const TypeInfo& own = field.type();
    const void* value = field.in(object);
    if (own.kind == TypeKind::optional && own.count(value) == 0) {
      if (!field.rules.required) continue;
      return Found{{"json.missing_field",
                    fmt::format("field \"{}\" is missing ({})", field.name, field.doc)},
                   ""};
    }
    if (auto found = find_fault(own, field.rules, value))
      return std::move(*found).below(field.name);
  }
  return std::nullopt;
}

std::optional<Found> fault_in_list(const TypeInfo& type,
                                   const FieldRules& rules,
                                   const void* list) {
  const std::size_t count = type.count(list);
  if (auto fault = fault_of_count(count, rules)) return Found{std::move(*fault), ""};
  const FieldRules of_elements = rules_of_elements(rules);
  for (std::size_t i = 0; i < count; ++i) {
    auto found = find_fault(type.element(), of_elements, type.at_const(list, i));
    if (found) return std::move(*found).below(std::to_string(i));
  }
  return std::nullopt;
}

MaybeFault fault_of_name(const TypeInfo& type, const void* value) {
  const std::int64_t number = type.get_integer(value);
  if (number >= 0 && static_cast<std::size_t>(number) < type.names.size()) return std::nullopt;
  return FieldFault{"json.unknown_name",
                    fmt::format("{} is no {}: there are {}", number, type.name, type.names.size())};
}

double whole_number(const TypeInfo& type, const void* value) {
  const std::int64_t number = type.get_integer(value);
  return type.is_signed ? static_cast<double>(number)
                        : static_cast<double>(static_cast<std::uint64_t>(number));
}

std::optional<Found> find_fault(const TypeInfo& type, const FieldRules& rules, const void* value) {
  MaybeFault fault;
  switch (type.kind) {
    case TypeKind::boolean:
      return std::nullopt;
    case TypeKind::object:
      return fault_in_fields(type, value);
    case TypeKind::array:
      return fault_in_list(type, rules, value);
    case TypeKind::optional:
      if (type.count(value) == 0) return std::nullopt;
      return find_fault(type.element(), rules, type.at_const(value, 0));
    case TypeKind::integer:
      fault = fault_of_number(whole_number(type, value), type, rules);
      break;
    case TypeKind::number:
      fault = fault_of_number(type.get_number(value), type, rules);
      break;
    case TypeKind::string:
      fault = fault_of_text(*static_cast<const std::string*>(value), rules);
      break;
    case TypeKind::enumeration:
      fault = fault_of_name(type, value);
      break;
  }
  if (!fault) return std::nullopt;
  return Found{std::move(*fault), ""};
}

}  // namespace

std::string shown_text(std::string_view text) {
  const nlohmann::json value(text);
  std::string shown = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (shown.size() > 60) shown = shown.substr(0, 57) + "...";
  return shown;
}

MaybeFault fault_of_number(double value, const TypeInfo& type, const FieldRules& rules) {
  if (!std::isfinite(value)) return out_of_range(fmt::format("{} is no finite number", value));
  if (value < rules.min && std::isinf(rules.max))
    return out_of_range(fmt::format("{} is less than {}", value, rules.min));
  if (value > rules.max && std::isinf(rules.min))
    return out_of_range(fmt::format("{} is more than {}", value, rules.max));
  if (value < rules.min || value > rules.max)
    return out_of_range(fmt::format("{} is outside {} to {}", value, rules.min, rules.max));
  if (std::abs(value) > largest_of(type))
    return out_of_range(fmt::format("{} does not fit into {} bits", value, type.size * 8));
  return std::nullopt;
}

MaybeFault fault_of_text(std::string_view text, const FieldRules& rules) {
  if (!is_utf8(text)) return FieldFault{"input.not_utf8", "the text is not UTF-8"};
  if (!rules.constant.empty() && text != rules.constant) {
    return FieldFault{"json.wrong_schema",
                      fmt::format("expected \"{}\", found {}", rules.constant, shown_text(text))};
  }
  if (text.size() > rules.max_length) {
    return out_of_range(fmt::format(
        "the text is {} bytes long; at most {} are allowed", text.size(), rules.max_length));
  }
  const bool may_be_empty = !rules.required;
  if (rules.identifier && !is_identifier(text) && !(text.empty() && may_be_empty)) {
    return FieldFault{
        "json.bad_identifier",
        fmt::format(
            "{} is not an id: use letters, digits, '_', '-', '.' and '/', a letter or digit first",
            shown_text(text))};
  }
  return std::nullopt;
}

MaybeFault fault_of_count(std::size_t count, const FieldRules& rules) {
  if (count <= rules.max_items) return std::nullopt;
  return out_of_range(
      fmt::format("the list has {} entries; at most {} are allowed", count, rules.max_items));
}

MaybeFault fault_of_field_of(const TypeInfo& type, std::string_view name, double value) {
  for (const FieldInfo& field : type.fields) {
    if (field.name != name) continue;
    const TypeInfo& own = field.type();
    return fault_of_number(
        value, own.kind == TypeKind::optional ? own.element() : own, field.rules);
  }
  fatal("fault_of_field() of a field that the type does not have");
}

FieldRules rules_of_elements(FieldRules rules) {
  rules.max_items = FieldRules{}.max_items;
  return rules;
}

Result<void> check_fields_of(const TypeInfo& type, const void* object, const std::string& source) {
  const std::optional<Found> found = find_fault(type, {}, object);
  if (!found) return {};
  return Error{std::string(found->fault.code),
               source + ":" + (found->pointer.empty() ? "/" : found->pointer),
               found->fault.message};
}

}  // namespace marketgen::io
