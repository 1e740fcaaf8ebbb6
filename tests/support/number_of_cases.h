// How many cases a property test tries: what an environment variable says, for a long run, or the
// usual number.
#pragma once
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace marketgen {

inline std::size_t number_of_cases(const char* variable, std::size_t usual) {
  const char* wanted = std::getenv(variable);
  std::size_t number = usual;
  if (wanted != nullptr) std::from_chars(wanted, wanted + std::string_view(wanted).size(), number);
  return number;
}

}  // namespace marketgen
