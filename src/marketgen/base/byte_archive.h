// Values as bytes and back, bit for bit: moments of a simulation that another process goes on from.
//
// Little-endian, without names or versions: whoever keeps such bytes puts those in front. A struct
// with padding, or with private members, says what it holds, once for both directions:
//
//   template <class Archive, class Self>
//   static void bytes(Archive& archive, Self& self) { archive(self.count, self.names); }
//
// Numbers, enumerations and structs without padding need nothing.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace marketgen {

static_assert(std::endian::native == std::endian::little);

class ByteWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }
  // What was written; the writer is empty then.
  std::string take() { return std::move(bytes_); }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (requires { T::bytes(*this, value); }) {
      T::bytes(*this, value);
    } else {
      static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
  }
  template <class T>
  void put_each(const T& values) {
    put(static_cast<std::uint64_t>(values.size()));
    for (const auto& value : values)
      put(value);
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  template <class T>
  void put(const std::vector<T>& values) {
    if constexpr (std::is_same_v<T, std::byte>) {
      put(static_cast<std::uint64_t>(values.size()));
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size());
    } else {
      put_each(values);
    }
  }
  void put(const std::vector<bool>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    for (const bool value : values)
      put(value);
  }
  template <class T, std::size_t count>
  void put(const std::array<T, count>& values) {
    for (const T& value : values)
      put(value);
  }
  template <class T>
  void put(const std::set<T>& values) {
    put_each(values);
  }
  template <class Key, class T>
  void put(const std::map<Key, T>& values) {
    put_each(values);
  }
  template <class A, class B>
  void put(const std::pair<A, B>& value) {
    put(value.first), put(value.second);
  }
  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }

  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  // Bytes that end too soon leave default values; ok() is false from then on.
  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  // Nothing was missing, and nothing is left over.
  bool ok() const { return ok_ && bytes_.empty(); }

 private:
  template <class T>
  void get(T& value) {
    if constexpr (requires { T::bytes(*this, value); }) {
      T::bytes(*this, value);
    } else {
      static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
      if (const char* from = next(sizeof(T))) std::memcpy(&value, from, sizeof(T));
    }
  }
  void get(bool& value) {
    std::uint8_t byte = 0;
    get(byte);
    value = byte != 0;
  }
  // At least a byte each: a length that cannot be true is refused before memory is taken for it.
  std::size_t length() {
    std::uint64_t count = 0;
    get(count);
    if (count <= bytes_.size()) return static_cast<std::size_t>(count);
    ok_ = false;
    return 0;
  }
  const char* next(std::size_t count) {
    if (count > bytes_.size()) ok_ = false, bytes_ = {};
    if (!ok_) return nullptr;
    const char* at = bytes_.data();
    bytes_.remove_prefix(count);
    return at;
  }
  void get(std::string& text) {
    const std::size_t count = length();
    const char* from = next(count);
    text = from == nullptr ? std::string() : std::string(from, count);
  }
  template <class T>
  void get(std::vector<T>& values) {
    values.clear();
    const std::size_t count = length();
    if constexpr (std::is_same_v<T, std::byte>) {
      values.resize(count);
      if (const char* from = next(count)) std::memcpy(values.data(), from, count);
    } else {
      for (std::size_t i = 0; i < count && ok_; ++i)
        get(values.emplace_back());
    }
  }
  void get(std::vector<bool>& values) {
    values.assign(length(), false);
    for (std::size_t i = 0; i < values.size() && ok_; ++i) {
      bool value = false;
      get(value);
      values[i] = value;
    }
  }
  template <class T, std::size_t count>
  void get(std::array<T, count>& values) {
    for (T& value : values)
      get(value);
  }
  template <class T>
  void get(std::set<T>& values) {
    values.clear();
    const std::size_t count = length();
    for (std::size_t i = 0; i < count && ok_; ++i) {
      T value{};
      get(value);
      values.insert(std::move(value));
    }
  }
  template <class Key, class T>
  void get(std::map<Key, T>& values) {
    values.clear();
    const std::size_t count = length();
    for (std::size_t i = 0; i < count && ok_; ++i) {
      std::pair<Key, T> entry{};
      get(entry);
      values.insert(std::move(entry));
    }
  }
  template <class A, class B>
  void get(std::pair<A, B>& value) {
    get(value.first), get(value.second);
  }
  template <class T>
  void get(std::optional<T>& value) {
    bool there = false;
    get(there);
    value.reset();
    if (there && ok_) get(value.emplace());
  }

  std::string_view bytes_;
  bool ok_ = true;
};

}  // namespace marketgen
