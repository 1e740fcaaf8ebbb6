#include "catalog/firm_pack.h"

#include <algorithm>
#include <string>

#include "base/text.h"

namespace marketgen::catalog {
namespace {

// Of packs of a shape, those of a group and with one of the words in their names; empty: all.
struct FirmPacks {
  std::string_view archetype, subcategory, words, because;
};

// What is not here gives way as its row says: slices of sausage and fish, sausages side by side,
// sliced white bread, sponges, tissues, nappies, wipes; and bags and pouches, in which the filling
// moves. Vacuum packs of cheese and tofu are firm as well, but stores bend them as soft packs, and
// of 25 that a cup was to take out of baskets it brought 17.
constexpr FirmPacks firm_packs[] = {
    {"chub", "", "", "a casing filled tight and clipped at both ends"},
    {"bundle", "soap", "", "film shrunk round pieces of soap"},
    {"bundle", "candles & light", "", "film shrunk round boxes of cardboard"},
    {"bundle", "bin bags & foil", "drawstring|compost", "bags wound on a core under a band"},
    {"loaf", "", "pumpernickel", "film drawn tight round a block of dense slices"},
};

bool has_one_of(const std::string& text, std::string_view words) {
  return words.empty() || std::ranges::any_of(split(words, '|'), [&](const std::string& word) {
           return text.find(word) != std::string::npos;
         });
}

}  // namespace

std::string_view firm_because(const Product& product) {
  if (product.rigidity != Rigidity::soft) return {};
  const std::string text = lower_ascii(product.name + " " + product.variant);
  for (const FirmPacks& firm : firm_packs)
    if (product.archetype == firm.archetype &&
        (firm.subcategory.empty() || product.subcategory == firm.subcategory) &&
        has_one_of(text, firm.words))
      return firm.because;
  return {};
}

}  // namespace marketgen::catalog
