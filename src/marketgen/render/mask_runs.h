// Masks of pictures as run lengths, in COCO's compressed form.
//
// A mask is the lengths of its runs of pixels, column by column from the top left, by turns outside
// and inside, outside first. COCO writes each length (from the third on: less the one two before)
// in groups of five bits, lowest first, as characters from '0' on; bit 5 of a character says that
// more follow. Source: the COCO API's maskApi.c (rleToString),
// https://github.com/cocodataset/cocoapi.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/fields.h"

namespace marketgen::render {

struct MaskRuns {
  std::array<int, 2> size{};  // height, width
  std::string counts;

  static constexpr auto fields =
      field_list(field("size", &MaskRuns::size, "height and width of the picture, pixels"),
                 field("counts",
                       &MaskRuns::counts,
                       "run lengths in COCO's compressed form",
                       at_most_bytes(100'000'000)));
};

// Of every number but 0 that occurs in `plane` (row-major, width x height).
std::map<std::uint32_t, MaskRuns> mask_runs_of(const std::vector<std::uint32_t>& plane,
                                               int width,
                                               int height);
// Of pixels, given by their numbers column by column from the top left (x * height + y), ascending.
MaskRuns mask_runs_of_pixels(const std::vector<std::uint32_t>& pixels, int width, int height);
// COCO's characters for run lengths.
std::string compressed_runs(const std::vector<std::uint32_t>& runs);

}  // namespace marketgen::render
