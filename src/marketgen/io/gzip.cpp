#include "io/gzip.h"

#include <algorithm>
#include <limits>
#include <new>

#include <fmt/format.h>
#include <zlib.h>

#include "base/text.h"

namespace marketgen::io {
namespace {

constexpr int gzip_window = 15 + 16;  // zlib's way to ask for gzip's header and trailer
constexpr int memory_level = 8;       // zlib's default
constexpr int quick_level = 5;        // the first that looks ahead for longer matches
constexpr std::size_t block_bytes = 1 << 16;

// zlib counts in unsigned int; its input is never written to, though it is not const.
Bytef* as_input(std::string_view bytes) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

// Gives the input in pieces that zlib can count.
void feed(z_stream& stream, std::string_view& rest) {
  if (stream.avail_in > 0 || rest.empty()) return;
  const std::size_t piece = std::min<std::size_t>(rest.size(), std::numeric_limits<uInt>::max());
  stream.next_in = as_input(rest);
  stream.avail_in = static_cast<uInt>(piece);
  rest.remove_prefix(piece);
}

// Of zlib's beginnings: with these levels nothing but memory can be missing.
void check_begun(int answer) {
  if (answer != Z_OK) throw std::bad_alloc();
}

// One block of output; zlib's answer.
template <typename Step>
int put_block(z_stream& stream, std::string& out, Step&& step) {
  Bytef block[block_bytes];
  stream.next_out = block;
  stream.avail_out = block_bytes;
  const int answer = step();
  out.append(reinterpret_cast<const char*>(block), block_bytes - stream.avail_out);
  return answer;
}

}  // namespace

std::string gzip(std::string_view bytes, GzipEffort effort) {
  z_stream stream{};
  const int level = effort == GzipEffort::small ? Z_BEST_COMPRESSION : quick_level;
  check_begun(
      deflateInit2(&stream, level, Z_DEFLATED, gzip_window, memory_level, Z_DEFAULT_STRATEGY));
  std::string out;
  for (int answer = Z_OK; answer != Z_STREAM_END;) {
    feed(stream, bytes);
    answer = put_block(
        stream, out, [&] { return deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH); });
  }
  deflateEnd(&stream);
  return out;
}

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> gunzip(std::string_view packed,
                           const std::string& source,
                           std::uint64_t max_bytes) {
  z_stream stream{};
  check_begun(inflateInit2(&stream, gzip_window));
  std::string out;
  int answer = Z_OK;
  while (answer == Z_OK && out.size() <= max_bytes) {
    feed(stream, packed);
    answer = put_block(stream, out, [&] { return inflate(&stream, Z_NO_FLUSH); });
  }
  inflateEnd(&stream);
  if (out.size() > max_bytes)
    return Error{"input.too_large",
                 source,
                 fmt::format("unpacks to more than {} bytes",
                             with_thousands(static_cast<std::int64_t>(max_bytes)))};
  if (answer != Z_STREAM_END || stream.avail_in > 0 || !packed.empty())
    return Error{"input.malformed",
                 source,
                 "is no gzip file, or was cut off or changed: fetch or make it again"};
  return out;
}

}  // namespace marketgen::io
