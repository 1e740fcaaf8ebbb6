#include "server/packed_sections.h"

#include <utility>

namespace marketgen::server {
namespace {

constexpr std::size_t alignment = 8;  // of every array, so that a page reads it where it lies

void append_u32(std::string& bytes, std::size_t value) {
  const auto narrow = static_cast<std::uint32_t>(value);  // every machine here is little-endian
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % alignment != 0)
    bytes += with;
}

}  // namespace

void PackedSections::add_bytes(std::string_view name,
                               std::string_view type,
                               std::size_t components,
                               std::size_t count,
                               std::span<const std::byte> bytes) {
  pad(data_, '\0');
  head_["sections"][std::string(name)] = {
      {"type", type}, {"components", components}, {"count", count}, {"offset", data_.size()}};
  data_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void PackedSections::note(const std::string& name, nlohmann::ordered_json value) {
  head_[name] = std::move(value);
}

std::string PackedSections::file() const {
  std::string text = head_.dump();
  if (!members_.empty()) {
    text.back() = ',';
    text.append(members_, 1);
  }
  pad(text, ' ');
  std::string file = "MGV1";
  append_u32(file, text.size());
  file += text;
  file += data_;
  return file;
}

}  // namespace marketgen::server
