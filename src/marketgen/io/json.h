// JSON for every described struct: strict reading with nearest-name hints, stable writing, schema
// and docs.
//
// Reading is strict: unknown, duplicate and missing fields, wrong types, values outside their
// limits and texts that are not UTF-8 are errors. Error.where is "<source>:<JSON pointer>". Nothing
// is coerced. A null is read as "absent" for an optional. Writing is canonical: fields in list
// order, two-space indent, short arrays and objects on one line, numbers in their shortest
// round-trip form, absent optionals left out. Reading back gives an equal value.
#pragma once
#include <string>
#include <string_view>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::io {

Result<void> read_json_into(std::string_view text,
                            const std::string& source,
                            const TypeInfo& type,
                            void* object);
std::string write_json_of(const TypeInfo& type, const void* object);
std::string write_json_line_of(const TypeInfo& type, const void* object);  // no line breaks

// Draft 2020-12 schema of a described type, with `$id`, docs as descriptions, limits and
// additionalProperties: false.
std::string json_schema_of(const TypeInfo& type, std::string_view id, std::string_view title);
// A Markdown table per struct reachable from the type: field, type, default, limits, meaning.
std::string markdown_of(const TypeInfo& type);

template <class T>
Result<T> read_json(std::string_view text, const std::string& source) {
  T value{};
  if (auto read = read_json_into(text, source, type_of<T>(), &value); !read.ok())
    return read.error();
  return value;
}
template <class T>
std::string write_json(const T& value) {
  return write_json_of(type_of<T>(), &value);
}
template <class T>
std::string write_json_line(const T& value) {
  return write_json_line_of(type_of<T>(), &value);
}

}  // namespace marketgen::io
