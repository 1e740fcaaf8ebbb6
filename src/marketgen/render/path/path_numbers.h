// The random numbers of one path: points of a shuffled, Owen-scrambled (0, 2)-sequence, one pair
// for each decision, so that the samples of a pixel are spread evenly over every decision's square.
//
// After Burley, "Practical hash-based Owen scrambling" (JCGT 2020): the sequence's order and digits
// are scrambled by a hash of the pixel and the decision. The pair is the first two dimensions of
// Sobol's sequence.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "geometry/vector.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {

class PathNumbers {
 public:
  // Of path `number` through pixel `pixel`; the same two always give the same numbers.
  PathNumbers(std::uint32_t pixel, std::uint32_t number) : seed_(hashed(pixel)), number_(number) {}

  // Two numbers in [0, 1) for the next decision.
  Vec2f pair() {
    const std::uint32_t seed = next_seed();
    const std::uint32_t index = scrambled(number_, seed);
    return {unit_float(scrambled(reversed(index), hashed(seed ^ 0x51633e2dU))),
            unit_float(scrambled(second_coordinate(index), hashed(seed ^ 0x68bc21ebU)))};
  }
  float one() {
    const std::uint32_t seed = next_seed();
    return unit_float(scrambled(reversed(scrambled(number_, seed)), hashed(seed ^ 0x51633e2dU)));
  }

 private:
  std::uint32_t next_seed() { return hashed(seed_ ^ (++decision_ * 0x9E3779B9U)); }
  static constexpr std::uint32_t reversed(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = (x & 0x0F0F0F0FU) << 4 | (x >> 4 & 0x0F0F0F0FU);
    x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
    return (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
  }
  // Nested uniform scrambling by the hash of Laine and Karras with Burley's constants.
  static constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x) + seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return reversed(x);
  }
  // Linear over bits: one table of 256 entries for each byte.
  using ByteTables = std::array<std::array<std::uint32_t, 256>, 4>;
  static constexpr ByteTables second_tables() {
    ByteTables tables{};
    for (std::uint32_t byte = 0; byte < 4; ++byte) {
      for (std::uint32_t value = 0; value < 256; ++value) {
        std::uint32_t direction = 1U << 31U, sum = 0;
        for (std::uint32_t rest = value << 8 * byte; rest != 0; rest >>= 1) {
          if ((rest & 1U) != 0) sum ^= direction;
          direction ^= direction >> 1;
        }
        tables[byte][value] = sum;
      }
    }
    return tables;
  }
  static std::uint32_t second_coordinate(std::uint32_t x) {
    static constexpr ByteTables tables = second_tables();
    return tables[0][x & 255U] ^ tables[1][x >> 8 & 255U] ^ tables[2][x >> 16 & 255U] ^
           tables[3][x >> 24];
  }

  std::uint32_t seed_, number_, decision_ = 0;
};

}  // namespace marketgen::render::raytrace
