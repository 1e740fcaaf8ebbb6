#include "catalog/gtin.h"

#include <cstddef>

namespace marketgen::catalog {

bool is_ean13(std::string_view digits) {
  if (digits.size() != 13) return false;
  int sum = 0;
  for (std::size_t i = 0; i < 13; ++i) {
    if (digits[i] < '0' || digits[i] > '9') return false;
    sum += (digits[i] - '0') * (i % 2 == 0 ? 1 : 3);
  }
  return sum % 10 == 0;
}

bool is_restricted_circulation(std::string_view digits) {
  if (digits.size() < 3) return false;
  const std::string_view prefix = digits.substr(0, 2);
  return prefix == "02" || prefix == "04" || digits[0] == '2';
}

}  // namespace marketgen::catalog
