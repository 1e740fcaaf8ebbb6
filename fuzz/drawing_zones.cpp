// A picture from anywhere as a drawing of zones, up to its words: the first two bytes are its size,
// the third how thick its walls are, the rest its colours.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "drawing/zone_picture.h"
#include "drawing/zone_segments.h"
#include "drawing/zone_shelves.h"
#include "geometry/image.h"
#include "io/png.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace marketgen;
  if (size < 4) return 0;
  constexpr int least = 120, more = 160, margin = 12;
  Image image(least + data[0] % more, least + data[1] % more);
  const int wall = data[2] % 8;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int rim = std::min({x, y, image.width - 1 - x, image.height - 1 - y}) - margin;
      const std::size_t tile = static_cast<std::size_t>(y) / 24 * 16 + x / 24;
      for (int c = 0; c < 3; ++c) {
        const std::uint8_t inside = data[3 + (3 * tile + c) % (size - 3)];
        image.at(x, y)[c] = rim < 0 ? 250 : rim < wall ? 0 : inside;
      }
    }
  }
  const auto picture = drawing::zone_picture(io::encode_png(image).value(), "fuzz", 0);
  if (!picture.ok()) return 0;
  const cv::Mat floor(picture->bgr.size(), CV_8UC1, cv::Scalar(255));
  const drawing::Segments found =
      drawing::segments_of(picture->bgr, picture->ink, floor, picture->longer_side);
  if (found.label.size() != picture->bgr.size()) std::abort();
  const auto shelves = drawing::shelf_strokes(picture->bgr, floor, picture->longer_side, 0);
  const auto runs = drawing::runs_on(found, shelves, picture->longer_side, 0);
  if (runs.size() != found.parts.size()) std::abort();
  return 0;
}
