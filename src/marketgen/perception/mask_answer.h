// What a segmentation server says: {"masks": [{"segmentation": ..., ...}]}.
//
// A segmentation is rows of booleans or of 0 and 1, as GenManip's server of SAM 2 sends it (Gao et
// al., "GenManip", CVPR 2025), or run lengths down the columns, counted or packed, as SAM's own
// `output_mode` and COCO have it. Other fields are not read.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"
#include "perception/mask_source.h"

namespace marketgen::perception {

// Memory that an answer may ask for; what is beyond it is no answer.
constexpr std::size_t max_mask_pixels = std::size_t{64} << 20;  // of all masks together

// Masks of a picture of that size, as the server has them. Errors: perception.bad_answer.
Result<std::vector<Mask>> read_masks(const std::string& answer, int width, int height);

}  // namespace marketgen::perception
