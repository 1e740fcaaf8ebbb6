#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "io/field_check.h"
#include "io/json.h"

namespace marketgen::io {
namespace {

using Json = nlohmann::json;

constexpr std::size_t max_nesting = 64;

// Where we are: "<source>:<pointer>".
class Place {
 public:
  explicit Place(const std::string& source) : source_(source) {}

  Place child(std::string_view key) const {
    Place next = *this;
    next.pointer_ += '/';
    for (const char c : key) {  // RFC 6901
      if (c == '~')
        next.pointer_ += "~0";
      else if (c == '/')
        next.pointer_ += "~1";
      else
        next.pointer_ += c;
    }
    return next;
  }
  Place child(std::size_t index) const { return child(std::to_string(index)); }
  Error error(std::string code, std::string message) const {
    return {
        std::move(code), source_ + ":" + (pointer_.empty() ? "/" : pointer_), std::move(message)};
  }

 private:
  const std::string& source_;
  std::string pointer_;
};

std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

Error wrong_type(const Place& place, std::string_view wanted, const Json& value) {
  return place.error(
      "json.wrong_type",
      fmt::format("expected {}, found {} {}", wanted, value.type_name(), shown(value)));
}

Result<void> read_value(
    const Json& json, const Place& place, const TypeInfo& type, const FieldRules& rules, void* out);

Result<void> result_of(const std::optional<FieldFault>& fault, const Place& place) {
  if (!fault) return {};
  return place.error(std::string(fault->code), fault->message);
}

Result<void> check_width(const Json& json, const Place& place, const TypeInfo& type) {
  const int bits = static_cast<int>(type.size) * 8 - (type.is_signed ? 1 : 0);
  const bool fits =
      json.is_number_unsigned()
          ? bits >= 64 || json.get<std::uint64_t>() <= (~0ULL >> (64 - bits))
          : type.is_signed && (bits == 63 || (json.get<std::int64_t>() >> bits) == -1);
  if (fits) return {};
  return place.error("json.out_of_range",
                     fmt::format("{} does not fit into {} bits", shown(json), type.size * 8));
}

Result<void> read_integer(const Json& json,
                          const Place& place,
                          const TypeInfo& type,
                          const FieldRules& rules,
                          void* out) {
  if (!json.is_number_integer()) return wrong_type(place, "a whole number", json);
  MARKETGEN_CHECK(check_width(json, place, type));
  MARKETGEN_CHECK(result_of(fault_of_number(json.get<double>(), type, rules), place));
  type.set_integer(out,
                   json.is_number_unsigned() ? static_cast<std::int64_t>(json.get<std::uint64_t>())
                                             : json.get<std::int64_t>());
  return {};
}

Result<void> read_string(const Json& json,
                         const Place& place,
                         const FieldRules& rules,
                         std::string& out) {
  if (!json.is_string()) return wrong_type(place, "a text", json);
  const auto& text = json.get_ref<const std::string&>();
  MARKETGEN_CHECK(result_of(fault_of_text(text, rules), place));
  out = text;
  return {};
}

Result<void> read_enumeration(const Json& json,
                              const Place& place,
                              const TypeInfo& type,
                              void* out) {
  if (!json.is_string()) return wrong_type(place, "a name", json);
  const auto& text = json.get_ref<const std::string&>();
  for (std::size_t i = 0; i < type.names.size(); ++i) {
    if (type.names[i] == text) {
      type.set_integer(out, static_cast<std::int64_t>(i));
      return {};
    }
  }
  return place.error("json.unknown_name",
                     fmt::format("{} is not one of: {}{}",
                                 shown(json),
                                 fmt::join(type.names, ", "),
                                 did_you_mean(text, type.names)));
}

Result<void> read_array(const Json& json,
                        const Place& place,
                        const TypeInfo& type,
                        const FieldRules& rules,
                        void* out) {
  if (!json.is_array()) return wrong_type(place, "a list", json);
  if (type.fixed_count != 0 && json.size() != type.fixed_count) {
    return place.error(
        "json.wrong_type",
        fmt::format("expected a list of {}, found {}", type.fixed_count, json.size()));
  }
  MARKETGEN_CHECK(result_of(fault_of_count(json.size(), rules), place));
  if (type.fixed_count == 0) type.resize(out, json.size());
  const FieldRules element_rules = rules_of_elements(rules);
  for (std::size_t i = 0; i < json.size(); ++i) {
    MARKETGEN_CHECK(
        read_value(json[i], place.child(i), type.element(), element_rules, type.at(out, i)));
  }
  return {};
}

const FieldInfo* find_field(const TypeInfo& type, std::string_view name) {
  for (const FieldInfo& f : type.fields) {
    if (f.name == name) return &f;
  }
  return nullptr;
}

Error unknown_field(const Place& place, const TypeInfo& type, const std::string& name) {
  std::vector<std::string_view> names;
  for (const FieldInfo& f : type.fields)
    names.push_back(f.name);
  const std::string hint = did_you_mean(name, names);
  return place.child(name).error(
      "json.unknown_field",
      hint.empty() ? fmt::format("no such field; known are: {}", fmt::join(names, ", "))
                   : "no such field" + hint);
}

// First of all: what else a file of another schema lacks would mislead.
Result<void> check_constants(const Json& json, const Place& place, const TypeInfo& type) {
  for (const FieldInfo& f : type.fields) {
    const auto given = json.find(f.name);
    if (f.rules.constant.empty() || given == json.end()) continue;
    std::string text;
    MARKETGEN_CHECK(read_string(*given, place.child(f.name), f.rules, text));
  }
  return {};
}

Result<void> read_object(const Json& json, const Place& place, const TypeInfo& type, void* out) {
  if (!json.is_object()) return wrong_type(place, "an object", json);
  MARKETGEN_CHECK(check_constants(json, place, type));
  for (const auto& [key, value] : json.items()) {
    const FieldInfo* f = find_field(type, key);
    if (f == nullptr) return unknown_field(place, type, key);
    MARKETGEN_CHECK(read_value(value, place.child(key), f->type(), f->rules, f->in(out)));
  }
  for (const FieldInfo& f : type.fields) {
    if (f.rules.required && !json.contains(f.name)) {
      return place.error("json.missing_field",
                         fmt::format("field \"{}\" is missing ({})", f.name, f.doc));
    }
  }
  return {};
}

Result<void> read_value(const Json& json,
                        const Place& place,
                        const TypeInfo& type,
                        const FieldRules& rules,
                        void* out) {
  switch (type.kind) {
    case TypeKind::boolean:
      if (!json.is_boolean()) return wrong_type(place, "true or false", json);
      type.set_integer(out, json.get<bool>() ? 1 : 0);
      return {};
    case TypeKind::integer:
      return read_integer(json, place, type, rules, out);
    case TypeKind::number:
      if (!json.is_number()) return wrong_type(place, "a number", json);
      MARKETGEN_CHECK(result_of(fault_of_number(json.get<double>(), type, rules), place));
      type.set_number(out, json.get<double>());
      return {};
    case TypeKind::string:
      return read_string(json, place, rules, *static_cast<std::string*>(out));
    case TypeKind::enumeration:
      return read_enumeration(json, place, type, out);
    case TypeKind::object:
      return read_object(json, place, type, out);
    case TypeKind::array:
      return read_array(json, place, type, rules, out);
    case TypeKind::optional:
      if (json.is_null()) {
        type.resize(out, 0);
        return {};
      }
      type.resize(out, 1);
      return read_value(json, place, type.element(), rules, type.at(out, 0));
  }
  return {};
}

// What the parser's events say against a text: nesting and keys that stand twice, which nlohmann's
// reader would silently merge. Each event costs the same, however long the list that it stands in:
// the reader's own callback looks through the whole list at the end of every object.
class Watcher : public nlohmann::json_sax<Json> {
 public:
  explicit Watcher(std::string_view text, const std::string& source)
      : text_(text), source_(source) {}

  // Precondition: the text was refused.
  const Error& fault() const { return *fault_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }

  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return deeper();
  }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_object() override {
    keys_.pop_back();
    --depth_;
    return true;
  }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool key(string_t& key) override {
    if (keys_.back().insert(key).second) return true;
    return refuse(
        {"json.duplicate_key", source_, fmt::format("key \"{}\" stands twice in one object", key)});
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& e) override {
    const std::string what = e.what();
    if (dynamic_cast<const Json::parse_error*>(&e) == nullptr) {
      // A number that does not fit: "[json.exception.out_of_range.406] number overflow ..."
      const std::size_t bracket = what.find("] ");
      return refuse(
          {"json.syntax", source_, bracket == std::string::npos ? what : what.substr(bracket + 2)});
    }
    const std::size_t at = std::min<std::size_t>(position == 0 ? 0 : position - 1, text_.size());
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::size_t colon = what.find(": ", what.find("parse error"));
    return refuse({"json.syntax",
                   fmt::format("{}:{}", source_, line),
                   colon == std::string::npos ? what : what.substr(colon + 2)});
  }

 private:
  bool deeper() {
    if (++depth_ <= max_nesting) return true;
    return refuse({"json.too_deep", source_, fmt::format("nested more than {} deep", max_nesting)});
  }
  bool refuse(Error error) {
    fault_ = std::move(error);
    return false;
  }

  std::string_view text_;
  const std::string& source_;
  std::vector<std::set<std::string>> keys_;  // of every open object
  std::size_t depth_ = 0;
  std::optional<Error> fault_;
};

Result<Json> parse(std::string_view text, const std::string& source) {
  Watcher watcher(text, source);
  if (!Json::sax_parse(text, &watcher)) return watcher.fault();
  return Json::parse(text);
}

}  // namespace

Result<void> read_json_into(std::string_view text,
                            const std::string& source,
                            const TypeInfo& type,
                            void* object) {
  if (!is_utf8(text))
    return Error{"input.not_utf8", source, "the text is not UTF-8; save it as UTF-8"};
  MARKETGEN_TRY(const Json json, parse(text, source));
  return read_value(json, Place(source), type, {}, object);
}

}  // namespace marketgen::io
