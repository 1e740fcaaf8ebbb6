// The store that the end-to-end tests share: generated once, by the program itself.
#pragma once
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace marketgen {

// Its folder. 12 x 9 m, dairy and frozen too, no previews: they take seconds and have a test of
// their own.
inline const std::filesystem::path& small_store() {
  static const ScratchFolder scratch;
  static const std::filesystem::path folder = [] {
    const std::filesystem::path shop = scratch.path() / "shop";
    const Ran ran =
        marketgen_run({"generate",
                       "a small shop with dairy along the back wall, frozen food and two checkouts",
                       "--size",
                       "12x9m",
                       "--seed",
                       "3",
                       "--no-previews",
                       "--quiet",
                       "-o",
                       shop.string()});
    EXPECT_EQ(ran.status, 0) << ran.err;
    return shop;
  }();
  return folder;
}

}  // namespace marketgen
