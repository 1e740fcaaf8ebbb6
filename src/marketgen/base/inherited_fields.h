// The field list of a struct that adds members to another described struct:
//
//   struct ShownProduct : Product {
//     int triangles = 0;
//     static constexpr auto fields = inherited_fields<ShownProduct>(
//         Product::fields, field_list(field("triangles", &ShownProduct::triangles, "of its
//         mesh")));
//   };
#pragma once
#include "base/fields.h"

namespace marketgen {

template <class Derived, class Base, class Member>
constexpr Field<Derived, Member> inherited_field(const Field<Base, Member>& field) {
  return {field.name, field.member, field.doc, field.rules};
}

// The fields of a base class, seen from `Derived`.
template <class Derived, class BaseList>
constexpr auto inherited_fields(BaseList base) {
  return [base](auto&& visit) {
    base([&](const auto& field) { visit(inherited_field<Derived>(field)); });
  };
}

// The same, then its own.
template <class Derived, class BaseList, class OwnList>
constexpr auto inherited_fields(BaseList base, OwnList own) {
  return [base, own](auto&& visit) {
    inherited_fields<Derived>(base)(visit);
    own(visit);
  };
}

}  // namespace marketgen
