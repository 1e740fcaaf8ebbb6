// Where the random numbers of a noisy picture come from. Equal seed and frame number, equal noise,
// for any thread count.
#pragma once
#include <cstdint>

namespace marketgen::render {

struct NoiseSource {
  std::uint64_t seed = 1;
  std::uint64_t frame = 0;  // number of the picture in its sequence
};

}  // namespace marketgen::render
