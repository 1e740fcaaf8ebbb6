// NumPy's array files, for planes of numbers that a picture would round.
#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

// float32, row-major, format version 1.0 (NumPy Enhancement Proposal 1): np.load() reads it.
// Precondition: `shape` multiplies to the number of values. Errors: io.*.
Result<void> write_npy(const std::filesystem::path& path,
                       std::span<const float> values,
                       const std::vector<int>& shape);

}  // namespace marketgen::io
