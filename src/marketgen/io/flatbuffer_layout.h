// How described types map to FlatBuffers; shared by the schema writer, the encoder and the decoder.
//
//   scalar, enum (int32)          inline in a table or struct
//   plain struct                  FlatBuffers struct, inline
//   fixed array                   in a struct: array; anywhere else: a generated struct such as
//   int32x3 string, vector, other struct  offset to string, vector, table optional an absent field
#pragma once
#include <string>

#include "base/fields.h"

namespace marketgen::io::flat {

// Stored inside its owner rather than behind an offset.
inline bool is_inline(const TypeInfo& type) {
  return type.plain && type.kind != TypeKind::optional;
}

inline std::size_t alignment_of(const TypeInfo& type) {
  if (type.kind == TypeKind::array) return alignment_of(type.element());
  if (type.kind != TypeKind::object) return type.size;
  std::size_t alignment = 1;
  for (const FieldInfo& f : type.fields)
    alignment = std::max(alignment, alignment_of(f.type()));
  return alignment;
}

// The schema's name of a scalar: "uint16", "float32".
std::string scalar_name(const TypeInfo& type);
// The generated struct that holds a fixed array outside a struct: "float32x3".
std::string array_struct_name(const TypeInfo& array);

}  // namespace marketgen::io::flat
