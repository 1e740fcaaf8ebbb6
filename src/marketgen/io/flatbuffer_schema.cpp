#include <set>

#include <fmt/format.h>

#include "io/flatbuffer.h"
#include "io/flatbuffer_layout.h"

namespace marketgen::io {
namespace flat {

std::string scalar_name(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::boolean:
      return "bool";
    case TypeKind::number:
      return type.size == sizeof(float) ? "float32" : "float64";
    case TypeKind::integer:
      return fmt::format("{}int{}", type.is_signed ? "" : "u", type.size * 8);
    default:
      return type.name;  // enumerations and structs
  }
}

std::string array_struct_name(const TypeInfo& array) {
  return fmt::format("{}x{}", scalar_name(array.element()), array.fixed_count);
}

}  // namespace flat

namespace {

class FlatBufferSchemaWriter {
 public:
  // Appends the definitions that `type` needs, in order of use.
  void define(const TypeInfo& type, bool in_struct) {
    switch (type.kind) {
      case TypeKind::array:
        define(type.element(), in_struct);
        if (type.fixed_count != 0 && !in_struct) define_array_struct(type);
        return;
      case TypeKind::optional:
        define(type.element(), in_struct);
        return;
      case TypeKind::enumeration:
        if (seen_.insert(type.name).second) define_enum(type);
        return;
      case TypeKind::object:
        if (seen_.insert(type.name).second) define_object(type);
        return;
      default:
        return;
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void define_array_struct(const TypeInfo& array) {
    const std::string name = flat::array_struct_name(array);
    if (!seen_.insert(name).second) return;
    text_ += fmt::format("struct {} {{\n  values: [{}:{}];\n}}\n\n",
                         name,
                         flat::scalar_name(array.element()),
                         array.fixed_count);
  }

  void define_enum(const TypeInfo& type) {
    std::string names;
    for (const std::string_view name : type.names) {
      std::string safe(name);
      for (char& c : safe) {
        if (c == '-') c = '_';
      }
      names += (names.empty() ? "" : ", ") + safe;
    }
    text_ += fmt::format("enum {} : int32 {{ {} }}\n\n", type.name, names);
  }

  void define_object(const TypeInfo& type) {
    for (const FieldInfo& f : type.fields)
      define(f.type(), type.plain);
    text_ += fmt::format("{} {} {{\n", type.plain ? "struct" : "table", type.name);
    for (const FieldInfo& f : type.fields) {
      text_ += fmt::format("  {}: {};  // {}\n", f.name, field_type(f.type(), type.plain), f.doc);
    }
    text_ += "}\n\n";
  }

  static std::string field_type(const TypeInfo& type, bool in_struct) {
    switch (type.kind) {
      case TypeKind::string:
        return "string";
      case TypeKind::optional: {
        const TypeInfo& inner = type.element();
        const bool scalar = flat::is_inline(inner) && inner.kind != TypeKind::object &&
                            inner.kind != TypeKind::array;
        return field_type(inner, in_struct) + (scalar ? " = null" : "");
      }
      case TypeKind::array:
        if (type.fixed_count == 0) return fmt::format("[{}]", field_type(type.element(), false));
        return in_struct
                   ? fmt::format("[{}:{}]", flat::scalar_name(type.element()), type.fixed_count)
                   : flat::array_struct_name(type);
      default:
        return flat::scalar_name(type);
    }
  }

  std::string text_;
  std::set<std::string> seen_;
};

}  // namespace

std::string flatbuffer_schema_of(const TypeInfo& type, std::string_view file_identifier) {
  FlatBufferSchemaWriter writer;
  writer.define(type, false);
  return fmt::format(
      "// Written from the field lists of the C++ structs by `marketgen schemas`; do not edit.\n"
      "// The file is size-prefixed: flatc --json --size-prefixed --raw-binary <this> -- <file>\n"
      "namespace marketgen_scene;\n\n{}root_type {};\nfile_identifier \"{}\";\n",
      writer.take(),
      type.name,
      file_identifier);
}

}  // namespace marketgen::io
