// Pictures with numbered outlines, by which a model that sees pictures can say which part it means
// (Set-of-Mark: Yang et al., 2023, arXiv 2310.11441).
#pragma once
#include <cstddef>
#include <vector>

#include "geometry/image.h"
#include "perception/target_choice.h"

namespace marketgen::perception {

constexpr std::size_t max_marks = 40;    // of all pictures together
constexpr std::size_t min_mark_px = 24;  // of the camera's; what shows less cannot be read
constexpr int marked_picture_px = 1024;  // longer side at least, so that numbers can be read
constexpr int crop_px = 512;             // longer side of a part alone, at least

// What a number stands for.
struct Mark {
  std::size_t view = 0, mask = 0;  // number of the mask among those of this view
  int x_px = 0, y_px = 0;          // middle of the chip with the number, on the marked picture
  int half_width_px = 0, half_height_px = 0;  // of the chip
};

struct MarkedPictures {
  std::vector<Image> pictures;  // one a view, in their order
  std::vector<Mark> marks;      // number N is marks[N - 1]
};

// The largest `max_marks` masks with `min_mark_px` pixels and more, numbered from the largest to
// the smallest, from 1 over all views. Each is outlined and has its number on a chip of the same
// colour at its middle, or beside it with a line to it where another chip stands; chips overlap
// nowhere. Pixels that a view does not have are left out.
MarkedPictures marked_pictures(const std::vector<ViewCloud>& views,
                               const std::vector<MaskedView>& masked);

// What is round a mask, without marks. Of a mask without pixels: the whole picture.
Image picture_of_mask(const ViewCloud& view, const Mask& mask);

}  // namespace marketgen::perception
