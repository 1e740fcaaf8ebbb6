#include "render/visible_parts.h"

#include <algorithm>

namespace marketgen::render {

void VisiblePart::include(int x, int y, float depth_m) {
  if (pixels++ == 0) box = {x, y, x + 1, y + 1};
  box = {
      std::min(box[0], x), std::min(box[1], y), std::max(box[2], x + 1), std::max(box[3], y + 1)};
  depth_sum_m += static_cast<double>(depth_m);
}

std::map<std::uint32_t, VisiblePart> visible_parts(const std::vector<std::uint32_t>& instance,
                                                   const std::vector<float>& depth_m,
                                                   int width) {
  std::map<std::uint32_t, VisiblePart> parts;
  VisiblePart* last = nullptr;  // most pixels show what their left neighbour shows
  std::uint32_t last_number = 0;
  for (std::size_t i = 0; i < instance.size(); ++i) {
    if (instance[i] == 0) continue;
    if (instance[i] != last_number) {
      last = &parts[instance[i]];
      last_number = instance[i];
    }
    const int pixel = static_cast<int>(i);
    last->include(pixel % width, pixel / width, depth_m[i]);
  }
  return parts;
}

}  // namespace marketgen::render
