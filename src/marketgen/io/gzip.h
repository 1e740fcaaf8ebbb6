// gzip (RFC 1952) in memory, by zlib.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace marketgen::io {

// small: as small as can be, for files. quick: a fifth of the time, some percent larger, for what
// is sent once.
enum class GzipEffort { small, quick };
// The same bytes for the same input: no name and no time stand in the header.
std::string gzip(std::string_view bytes, GzipEffort effort = GzipEffort::small);

// Whether they begin as gzip does.
bool is_gzip(std::string_view bytes);

// What was packed. `source` is where errors are said to be. Errors: input.malformed for what is
// broken or cut off; input.too_large.
Result<std::string> gunzip(std::string_view packed,
                           const std::string& source,
                           std::uint64_t max_bytes = 256U << 20);

}  // namespace marketgen::io
