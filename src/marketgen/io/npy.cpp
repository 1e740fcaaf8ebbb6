#include "io/npy.h"

#include <bit>
#include <string>

#include "io/file.h"

namespace marketgen::io {

Result<void> write_npy(const std::filesystem::path& path,
                       std::span<const float> values,
                       const std::vector<int>& shape) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t alignment = 64, preamble = 10;
  std::string sides;
  for (const int side : shape)
    sides += std::to_string(side) + ",";
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + sides + "), }";
  header.append((alignment - (preamble + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFF);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return write_file(path, bytes);
}

}  // namespace marketgen::io
