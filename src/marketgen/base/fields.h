// One field list per struct, from which JSON, JSON Schema, FlatBuffers and the docs are made.
//
//   struct StockSpec {
//     double fill = 0.95;        // occupied share of the shelf front, 0..1
//     IntRange facings{2, 4};
//     static constexpr auto fields = field_list(
//         field("fill", &StockSpec::fill, "occupied share of the shelf front", range(0.0, 1.0)),
//         field("facings", &StockSpec::facings, "fewest and most facings of one SKU", within(1,
//         40)));
//   };
//
// Supported member types: bool, (u)int8..64, float, double, std::string, enums with `names_of`,
// structs with `fields`, std::vector, std::array and std::optional of those. A member's default is
// that of a default-constructed struct. An enum is described by a constexpr function beside it:
// `constexpr std::array<std::string_view, 2> names_of(Axis)`. Readers and writers work on the
// type-erased TypeInfo, so no JSON library appears in any header.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace marketgen {

// Limits of a field, checked when it is read. Numbers: min..max inclusive, applied to every element
// of an array.
struct FieldRules {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::size_t max_items = 100'000;  // longest array
  std::size_t max_length = 10'000;  // longest string, bytes
  bool required = false;            // must be present; otherwise the default holds
  bool identifier = false;  // [A-Za-z0-9][A-Za-z0-9_./-]*: usable as id and as part of a path
  std::string_view constant = {};  // the only string allowed (schema tags)
};

constexpr FieldRules operator+(FieldRules a, const FieldRules& b) {
  const FieldRules none;
  if (b.min != none.min) a.min = b.min;
  if (b.max != none.max) a.max = b.max;
  if (b.max_items != none.max_items) a.max_items = b.max_items;
  if (b.max_length != none.max_length) a.max_length = b.max_length;
  a.required = a.required || b.required;
  a.identifier = a.identifier || b.identifier;
  if (!b.constant.empty()) a.constant = b.constant;
  return a;
}

constexpr FieldRules range(double min, double max) {
  return {.min = min, .max = max};
}
constexpr FieldRules within(double min, double max) {
  return range(min, max);
}
constexpr FieldRules at_least(double min) {
  return {.min = min};
}
constexpr FieldRules at_most_items(std::size_t count) {
  return {.max_items = count};
}
constexpr FieldRules at_most_bytes(std::size_t count) {
  return {.max_length = count};
}
constexpr FieldRules required() {
  return {.required = true};
}
constexpr FieldRules identifier() {
  return {.max_length = 200, .required = true, .identifier = true};
}
constexpr FieldRules reference() {
  return {.max_length = 200, .identifier = true};
}
constexpr FieldRules constant(std::string_view text) {
  return {.required = true, .constant = text};
}

template <class Struct, class Member>
struct Field {
  std::string_view name;
  Member Struct::*member;
  std::string_view doc;
  FieldRules rules;
};

template <class Struct, class Member, class... Rules>
constexpr Field<Struct, Member> field(std::string_view name,
                                      Member Struct::*member,
                                      std::string_view doc,
                                      const Rules&... rules) {
  return {name, member, doc, (FieldRules{} + ... + rules)};
}

// The list of a struct's fields: called with a visitor, it hands over one Field after the other.
// (A closure, because every file that includes a described struct pays for the type of its list,
// and std::tuple costs ten times as much to compile.)
template <class... Fields>
constexpr auto field_list(Fields... list) {
  return [list...](auto&& visit) { (visit(list), ...); };
}

template <class T>
concept HasFields = requires {
  T::fields;
};
template <class T>
concept HasNames = std::is_enum_v<T> && requires(T value) {
  names_of(value);
};

// The name of an enum value, as written in files.
template <HasNames E>
constexpr std::string_view name_of(E value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

// The enum value called `name`, or nothing.
template <HasNames E>
constexpr std::optional<E> value_named(std::string_view name) {
  const auto names = names_of(E{});
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<E>(i);
  }
  return std::nullopt;
}

enum class TypeKind { boolean, integer, number, string, enumeration, object, array, optional };

struct TypeInfo;

// One member of a struct, type-erased.
struct FieldInfo {
  std::string_view name;
  std::string_view doc;
  FieldRules rules;
  std::size_t offset;         // bytes from the struct's start
  const TypeInfo& (*type)();  // lazy, so that types may refer to themselves through vectors

  const void* in(const void* object) const {
    return static_cast<const std::byte*>(object) + offset;
  }
  void* in(void* object) const { return static_cast<std::byte*>(object) + offset; }
};

// A described type. Only the members that its kind needs are set. All functions take a pointer to
// an object of the type.
struct TypeInfo {
  TypeKind kind;
  std::string name;      // struct or enum name without namespace
  std::size_t size = 0;  // sizeof
  bool plain = false;    // trivially copyable with scalars only: may be stored as raw bytes

  // boolean, integer, number, enumeration
  bool is_signed = false;
  std::int64_t (*get_integer)(const void*) = nullptr;  // booleans and enumerations too
  void (*set_integer)(void*, std::int64_t) = nullptr;
  double (*get_number)(const void*) = nullptr;
  void (*set_number)(void*, double) = nullptr;
  std::span<const std::string_view> names;  // enumeration

  // array, optional
  const TypeInfo& (*element)() = nullptr;
  std::size_t fixed_count = 0;                  // std::array: its length; 0 for a vector
  std::size_t (*count)(const void*) = nullptr;  // an optional counts 0 or 1
  void (*resize)(void*,
                 std::size_t) = nullptr;  // of a vector or an optional; new elements are defaults
  void* (*at)(void*, std::size_t) = nullptr;
  const void* (*at_const)(const void*, std::size_t) = nullptr;

  // object
  std::vector<FieldInfo> fields;
  const void* defaults = nullptr;  // a default-constructed object
};

template <class T>
const TypeInfo& type_of();

namespace detail {

template <class T>
std::string type_name() {
  std::string_view text =
      __PRETTY_FUNCTION__;  // "... [with T = marketgen::Plan; ...]" or "[T = ...]"
  const std::size_t start = text.find("T = ") + 4;
  text = text.substr(start, text.find_first_of(";]", start) - start);
  const std::size_t colon = text.rfind("::");
  return std::string(colon == std::string_view::npos ? text : text.substr(colon + 2));
}

template <class T>
struct ArrayTraits : std::false_type {};
template <class T>
struct ArrayTraits<std::vector<T>> : std::true_type {
  using Element = T;
  static constexpr std::size_t fixed = 0;
};
template <class T, std::size_t N>
struct ArrayTraits<std::array<T, N>> : std::true_type {
  using Element = T;
  static constexpr std::size_t fixed = N;
};
template <class T>
struct OptionalTraits : std::false_type {};
template <class T>
struct OptionalTraits<std::optional<T>> : std::true_type {
  using Element = T;
};

template <class T>
void describe_scalar(TypeInfo& info) {
  if constexpr (std::is_floating_point_v<T>) {
    info.kind = TypeKind::number;
    info.get_number = [](const void* p) { return static_cast<double>(*static_cast<const T*>(p)); };
    info.set_number = [](void* p, double v) { *static_cast<T*>(p) = static_cast<T>(v); };
  } else {
    info.kind = std::is_same_v<T, bool>
                    ? TypeKind::boolean
                    : (std::is_enum_v<T> ? TypeKind::enumeration : TypeKind::integer);
    info.get_integer = [](const void* p) {
      return static_cast<std::int64_t>(*static_cast<const T*>(p));
    };
    info.set_integer = [](void* p, std::int64_t v) { *static_cast<T*>(p) = static_cast<T>(v); };
    if constexpr (std::is_enum_v<T>) {
      static constexpr auto names = names_of(T{});
      info.names = names;
      info.name = type_name<T>();
    } else {
      info.is_signed = std::is_signed_v<T>;
    }
  }
  info.plain = true;
}

template <class T>
void describe_array(TypeInfo& info) {
  using Traits = ArrayTraits<T>;
  info.kind = TypeKind::array;
  info.element = &type_of<typename Traits::Element>;
  info.fixed_count = Traits::fixed;
  info.count = [](const void* p) { return static_cast<const T*>(p)->size(); };
  info.at = [](void* p, std::size_t i) -> void* { return &(*static_cast<T*>(p))[i]; };
  info.at_const = [](const void* p, std::size_t i) -> const void* {
    return &(*static_cast<const T*>(p))[i];
  };
  if constexpr (Traits::fixed == 0) {
    info.resize = [](void* p, std::size_t n) { static_cast<T*>(p)->resize(n); };
  } else {
    info.plain = type_of<typename Traits::Element>().plain;
  }
}

template <class T>
void describe_optional(TypeInfo& info) {
  using Element = typename OptionalTraits<T>::Element;
  info.kind = TypeKind::optional;
  info.element = &type_of<Element>;
  info.count = [](const void* p) { return std::size_t{static_cast<const T*>(p)->has_value()}; };
  info.at = [](void* p, std::size_t) -> void* { return &**static_cast<T*>(p); };
  info.at_const = [](const void* p, std::size_t) -> const void* {
    return &**static_cast<const T*>(p);
  };
  info.resize = [](void* p, std::size_t n) {
    if (n == 0)
      static_cast<T*>(p)->reset();
    else
      static_cast<T*>(p)->emplace();
  };
}

template <class T, class Member>
FieldInfo describe_field(const Field<T, Member>& f, const T& sample) {
  const auto* start = reinterpret_cast<const std::byte*>(&sample);
  const auto* at = reinterpret_cast<const std::byte*>(&(sample.*(f.member)));
  return {f.name, f.doc, f.rules, static_cast<std::size_t>(at - start), &type_of<Member>};
}

template <HasFields T>
void describe_object(TypeInfo& info) {
  static const T sample{};
  info.kind = TypeKind::object;
  info.name = type_name<T>();
  info.defaults = &sample;
  T::fields([&](const auto& f) { info.fields.push_back(describe_field(f, sample)); });
  info.plain = std::is_trivially_copyable_v<T>;
  for (const FieldInfo& f : info.fields) {
    if (info.plain) info.plain = f.type().plain;
  }
}

template <class T>
TypeInfo describe() {
  TypeInfo info{};
  info.size = sizeof(T);
  if constexpr (std::is_same_v<T, std::string>)
    info.kind = TypeKind::string;
  else if constexpr (ArrayTraits<T>::value)
    describe_array<T>(info);
  else if constexpr (OptionalTraits<T>::value)
    describe_optional<T>(info);
  else if constexpr (HasFields<T>)
    describe_object<T>(info);
  else
    describe_scalar<T>(info);
  return info;
}

}  // namespace detail

// The description of T; made once, thread-safe, lives for ever.
template <class T>
const TypeInfo& type_of() {
  static const TypeInfo info = detail::describe<T>();
  return info;
}

// A whole-number interval, written [min, max].
using IntRange = std::array<int, 2>;

}  // namespace marketgen
