// A rectangle of a picture that is sent somewhere by itself.
#pragma once
#include <algorithm>

#include "geometry/image.h"

namespace marketgen::perception {

struct PicturePart {
  int left = 0, top = 0, right = -1, bottom = -1;  // pixels, the last ones included

  bool empty() const { return right < left; }
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
  void add(int x, int y) {
    if (empty()) {
      *this = {x, y, x, y};
      return;
    }
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  // With so much round it, as far as the picture goes.
  PicturePart with_margin(int margin_px, int picture_width, int picture_height) const {
    return {std::max(0, left - margin_px),
            std::max(0, top - margin_px),
            std::min(picture_width - 1, right + margin_px),
            std::min(picture_height - 1, bottom + margin_px)};
  }
  // Of three channels.
  Image cut(const Image& whole) const {
    Image part(width(), height(), 3);
    for (int y = 0; y < part.height; ++y)
      for (int x = 0; x < part.width; ++x)
        std::copy_n(whole.at(left + x, top + y), 3, part.at(x, y));
    return part;
  }
};

}  // namespace marketgen::perception
