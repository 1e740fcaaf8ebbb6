// The two chunks of a GLB file and the numbers in them, every index and length checked.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.h"

namespace marketgen::io {

using GlbJson = nlohmann::json;

// The JSON chunk parsed, and the binary chunk as it lies in the file's bytes.
struct GlbChunks {
  GlbJson json;
  std::string_view binary;
};

// Errors: model.bad_file, input.too_large.
Result<GlbChunks> read_glb_chunks(std::string_view bytes, const std::string& source);

// Member `key` of an object as what it should be; nothing when it is absent or something else.
std::optional<std::size_t> glb_index(const GlbJson& object, const char* key);
std::optional<double> glb_number(const GlbJson& object, const char* key);
std::string glb_text(const GlbJson& object, const char* key);
// The object or list itself; an empty one when it is absent or something else.
const GlbJson& glb_object(const GlbJson& object, const char* key);
const GlbJson& glb_list(const GlbJson& object, const char* key);
// `count` numbers, or nothing.
std::optional<std::vector<double>> glb_numbers(const GlbJson& object,
                                               const char* key,
                                               std::size_t count);
// Row `index` of the top-level list `key`. Error: model.bad_file.
Result<const GlbJson*> glb_row(const GlbChunks& glb,
                               const char* key,
                               std::size_t index,
                               const std::string& source);

// The bytes of a buffer view. Errors: model.bad_file; input.outside_folder when they are in another
// file.
Result<std::string_view> glb_view(const GlbChunks& glb,
                                  std::size_t index,
                                  const std::string& source);

// Every number of an accessor, `width` an element (1 SCALAR, 2 VEC2, 3 VEC3), normalised integers
// as 0..1 or -1..1. At most `most` elements. Errors: as glb_view; input.too_large.
Result<std::vector<float>> glb_floats(const GlbChunks& glb,
                                      std::size_t accessor,
                                      std::size_t width,
                                      std::size_t most,
                                      const std::string& source);
// Whole numbers of a SCALAR accessor.
Result<std::vector<std::uint32_t>> glb_indices(const GlbChunks& glb,
                                               std::size_t accessor,
                                               std::size_t most,
                                               const std::string& source);

}  // namespace marketgen::io
