// GTIN-13 (EAN-13) numbers: check digit and the prefixes that GS1 leaves to a shop's own use.
#pragma once
#include <string_view>

namespace marketgen::catalog {

// True for 13 digits whose last is the check digit (GS1 General Specifications, 7.9).
bool is_ean13(std::string_view digits);
// True for the restricted-circulation prefixes 020-029, 040-049 and 200-299: such a number is
// nobody's.
bool is_restricted_circulation(std::string_view digits);

}  // namespace marketgen::catalog
