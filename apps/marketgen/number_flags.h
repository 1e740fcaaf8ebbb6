// Numbers on the command line. Every flag that takes one checks it here: digits that are a number
// of the flag's range and nothing else, so that -1 never wraps, 2^64 never clamps and nan never
// passes.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace marketgen::app {

constexpr std::uint64_t any_seed = std::numeric_limits<std::uint64_t>::max();

// For CLI::Option::check(): empty when `text` is good, otherwise what is wrong and what is
// expected.
using NumberCheck = std::function<std::string(const std::string&)>;

// A whole number from `min` to `max`.
NumberCheck whole_number(std::uint64_t min, std::uint64_t max);
// A finite number from `min` to `max`; a decimal point and an exponent are allowed.
NumberCheck real_number(double min, double max);

}  // namespace marketgen::app
