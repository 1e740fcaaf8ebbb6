// How large the floor of a store is: as it was said, or as shops of its kind have it.
#pragma once
#include <array>

#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Width and depth in mm: of the drawing, the flag, the words, else what the asked zones need or the
// profile has. Error: brief.bad_size, at the words that ask for what cannot be built.
Result<std::array<int, 2>> floor_size_of(const Brief& brief,
                                         const Understanding& found,
                                         const catalog::ProfileRow& profile);

// By a drawing, a flag or in words.
bool floor_size_is_said(const Brief& brief, const Understanding& found);

// The profile's proportions at another area, as far as a shop may be so narrow or so long.
std::array<int, 2> size_with_area(const catalog::ProfileRow& profile, double area_m2);

// Whole decimetres, as builders measure.
int rounded_mm(double mm);

}  // namespace marketgen::intake
