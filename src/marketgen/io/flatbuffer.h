// FlatBuffers for every described struct, driven by the same field lists as JSON.
//
// A plain struct (scalars and fixed arrays only) becomes a FlatBuffers struct stored inline, so a
// table of 40,000 rows is one block of memory; every other struct becomes a table.
// `flatbuffer_schema_of` writes the .fbs that is committed under schemas/: flatc and every
// FlatBuffers library can read the file with it. Buffers are verified before anything is read.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/fields.h"
#include "base/result.h"

namespace marketgen::io {

// `file_identifier`: four characters. The .fbs text for the type and everything it reaches.
std::string flatbuffer_schema_of(const TypeInfo& type, std::string_view file_identifier);

// The finished buffer. Same value, same bytes.
std::string write_flatbuffer_of(const TypeInfo& type,
                                const void* object,
                                std::string_view file_identifier);

// Verifies bounds, alignment, the identifier and enum values, then copies into *object. `source`
// goes into Error.where. Errors: scene.truncated, scene.corrupt, scene.wrong_version.
Result<void> read_flatbuffer_into(std::span<const std::byte> bytes,
                                  const std::string& source,
                                  std::string_view file_identifier,
                                  const TypeInfo& type,
                                  void* object);

}  // namespace marketgen::io
