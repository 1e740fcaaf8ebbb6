// The binary container of the viewer, "MGV1": arrays of numbers with a JSON head that says where
// each lies. docs/viewer.md describes it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace marketgen::server {

class PackedSections {
 public:
  // `values`: `components` numbers a row, rows one after another.
  template <class Number>
  void add(std::string_view name, std::size_t components, std::span<const Number> values) {
    add_bytes(
        name, type_name<Number>(), components, values.size() / components, std::as_bytes(values));
  }
  // Beside "sections" in the head.
  void note(const std::string& name, nlohmann::ordered_json value);
  // All members of a JSON object, beside what is noted. `object`: its text, with at least one.
  void note_members(std::string object) { members_ = std::move(object); }
  std::string file() const;

 private:
  template <class Number>
  static constexpr std::string_view type_name() {
    if constexpr (std::is_same_v<Number, float>) return "f32";
    if constexpr (std::is_same_v<Number, std::uint32_t>) return "u32";
    if constexpr (std::is_same_v<Number, std::uint16_t>) return "u16";
    if constexpr (std::is_same_v<Number, std::int16_t>) return "i16";
    if constexpr (std::is_same_v<Number, std::uint8_t>) return "u8";
    if constexpr (std::is_same_v<Number, std::int8_t>) return "i8";
  }
  void add_bytes(std::string_view name,
                 std::string_view type,
                 std::size_t components,
                 std::size_t count,
                 std::span<const std::byte> bytes);

  nlohmann::ordered_json head_{{"sections", nlohmann::ordered_json::object()}};
  std::string members_, data_;
};

}  // namespace marketgen::server
