#include "language/meaning.h"

#include <algorithm>

namespace marketgen::language {
namespace {

template <typename Value>
const Value* value_in(const Meaning& meaning, std::string_view slot) {
  const auto found = meaning.slots.find(slot);
  return found == meaning.slots.end() ? nullptr : std::get_if<Value>(&found->second);
}

bool same_value(const SlotValue& a, const SlotValue& b) {
  if (a.index() != b.index()) return false;
  const Parts *parts = std::get_if<Parts>(&a), *others = std::get_if<Parts>(&b);
  if (parts == nullptr) return a == b;
  return std::ranges::equal(*parts, *others, [](const MeaningPtr& one, const MeaningPtr& other) {
    return one == other || same_meaning(*one, *other);
  });
}

}  // namespace

const std::string& Meaning::text(std::string_view slot) const {
  static const std::string none;
  const auto* value = value_in<std::string>(*this, slot);
  return value == nullptr ? none : *value;
}

double Meaning::number(std::string_view slot, double otherwise) const {
  const auto* value = value_in<double>(*this, slot);
  return value == nullptr ? otherwise : *value;
}

const Parts& Meaning::parts(std::string_view slot) const {
  static const Parts none;
  const auto* value = value_in<Parts>(*this, slot);
  return value == nullptr ? none : *value;
}

bool same_meaning(const Meaning& a, const Meaning& b) {
  return std::ranges::equal(a.slots, b.slots, [](const auto& one, const auto& other) {
    return one.first == other.first && same_value(one.second, other.second);
  });
}

}  // namespace marketgen::language
