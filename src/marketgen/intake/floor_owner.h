// Whose floor "40 m2" or "5 x 4 m" speaks of: that of the shop, or that of one of its zones.
#pragma once
#include <string>

#include "intake/sentence.h"

namespace marketgen::intake {

// The zone type that the measure from phrase `first` to phrase `last` belongs to: of "a 20 m2
// bakery", "a bakery of 20 m2", "bakery (20 m2)". Empty when it is the shop's, as in "a 40 m2 kiosk
// with snacks", "a kiosk of 40 m2 with snacks", "snacks and drinks, 40 m2", "a 60 m2 wine shop"
// and, where nothing else is named as the shop, "a bakery of 60 m2". `shop_measured`: the shop's
// own size was said already.
std::string zone_of_floor(const Sentence& sentence,
                          std::size_t first,
                          std::size_t last,
                          bool shop_measured);

}  // namespace marketgen::intake
