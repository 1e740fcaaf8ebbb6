#include "render/mask_runs.h"

namespace marketgen::render {
namespace {

// The runs of one mask while its pixels come along.
struct OpenRuns {
  std::vector<std::uint32_t> runs;  // an even number: outside, inside, ...
  std::uint32_t end = 0;            // past the last pixel inside

  void include(std::uint32_t pixel) {
    if (!runs.empty() && pixel == end) {
      ++runs.back();
    } else {
      runs.push_back(pixel - end);
      runs.push_back(1);
    }
    end = pixel + 1;
  }
  std::string close(std::uint32_t count) {
    if (end < count) runs.push_back(count - end);
    return compressed_runs(runs);
  }
};

}  // namespace

std::string compressed_runs(const std::vector<std::uint32_t>& runs) {
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t rest = std::int64_t{runs[i]} - (i > 2 ? std::int64_t{runs[i - 2]} : 0);
    for (bool more = true; more;) {
      const std::int64_t group = rest & 31;
      rest >>= 5;
      more = (group & 16) != 0 ? rest != -1 : rest != 0;
      text += static_cast<char>('0' + (group | (more ? 32 : 0)));
    }
  }
  return text;
}

MaskRuns mask_runs_of_pixels(const std::vector<std::uint32_t>& pixels, int width, int height) {
  OpenRuns runs;
  for (const std::uint32_t pixel : pixels)
    runs.include(pixel);
  return {{height, width},
          runs.close(static_cast<std::uint32_t>(width) * static_cast<std::uint32_t>(height))};
}

std::map<std::uint32_t, MaskRuns> mask_runs_of(const std::vector<std::uint32_t>& plane,
                                               int width,
                                               int height) {
  std::map<std::uint32_t, OpenRuns> open;
  OpenRuns* last = nullptr;
  std::uint32_t last_number = 0, at = 0;
  for (int x = 0; x < width; ++x) {
    for (int y = 0; y < height; ++y, ++at) {
      const std::uint32_t number =
          plane[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
      if (number == 0) continue;
      if (number != last_number || last == nullptr) {
        last = &open[number];
        last_number = number;
      }
      last->include(at);
    }
  }
  std::map<std::uint32_t, MaskRuns> masks;
  for (auto& [number, runs] : open)
    masks[number] = {{height, width}, runs.close(at)};
  return masks;
}

}  // namespace marketgen::render
