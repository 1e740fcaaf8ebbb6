// What a part of a sentence says: named slots that words fill and the rules of a grammar put
// together.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/fields.h"

namespace marketgen::language {

struct Meaning;
using MeaningPtr = std::shared_ptr<const Meaning>;
using Parts = std::vector<MeaningPtr>;  // what "bread, milk and eggs" lists, in its order

// A number, a name of the program's, or what other parts of the sentence say.
using SlotValue = std::variant<double, std::string, Parts>;

struct Meaning {
  std::map<std::string, SlotValue, std::less<>> slots;
  std::vector<int> words;  // tokens that say it, sorted; fillers between them are not among them
  IntRange span{0, 0};     // bytes of the text, from the first of them to the last

  bool has(std::string_view slot) const { return slots.contains(slot); }
  bool is(std::string_view slot, std::string_view value) const { return text(slot) == value; }
  // "" when the slot is empty or holds something else.
  const std::string& text(std::string_view slot) const;
  double number(std::string_view slot, double otherwise = 0) const;
  // No parts when the slot is empty or holds something else.
  const Parts& parts(std::string_view slot) const;
};

// Slots alone: where it was said does not count.
bool same_meaning(const Meaning& a, const Meaning& b);

}  // namespace marketgen::language
