// The field list of a struct that adds members to another described struct:
//
//   struct ShownProduct : Product {
//     int triangles = 0;
//     static constexpr auto fields = std::tuple_cat(
//         inherited_fields<ShownProduct>(Product::fields),
//         field_list(field("triangles", &ShownProduct::triangles, "of its mesh")));
//   };
#pragma once
#include <tuple>

#include "base/fields.h"

namespace marketgen {

template <class Derived, class Base, class Member>
constexpr Field<Derived, Member> inherited_field(const Field<Base, Member>& field) {
  return {field.name, field.member, field.doc, field.rules};
}

template <class Derived, class... Fields>
constexpr auto inherited_fields(const std::tuple<Fields...>& list) {
  return std::apply(
      [](const auto&... fields) { return std::tuple(inherited_field<Derived>(fields)...); }, list);
}

}  // namespace marketgen
