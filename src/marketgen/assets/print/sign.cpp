// Hanging signs and wall bands.
#include <algorithm>
#include <string>

#include "assets/print/label.h"
#include "assets/print/lettering.h"
#include "base/text.h"

namespace marketgen::assets {

Result<Image> draw_sign(std::string_view text,
                        std::string_view ground_color,
                        std::string_view text_color,
                        int width_px,
                        int height_px) {
  constexpr int min_px = 8;
  constexpr int max_px = 8192;
  if (std::min(width_px, height_px) < min_px || std::max(width_px, height_px) > max_px) {
    return Error{"assets.bad_row", "sign", "a sign's sides must be 8 to 8192 pixels"};
  }
  if (!is_utf8(text)) return Error{"input.not_utf8", "sign", "the text of a sign must be UTF-8"};
  MARKETGEN_TRY(const Color ground, parse_color(ground_color, "sign/ground_color"));
  MARKETGEN_TRY(const Color type, parse_color(text_color, "sign/text_color"));
  Canvas canvas(width_px, height_px, ground);
  const Area area{0, 0, static_cast<double>(width_px), static_cast<double>(height_px)};
  canvas.rectangle(area).fill(
      Paint::linear(0, 0, 0, area.h, {{0, lighter(ground, 0.06)}, {1, darker(ground, 0.06)}}));
  canvas.rectangle(area.part(0, 0.92, 1, 1)).fill(faded(type, 0.85));
  const int lines = width_px > height_px * 3 ? 1 : 2;
  draw_headline(canvas,
                {std::string(text),
                 {"Lato", 800, false, false, 0.01},
                 type,
                 area.part(0.05, 0.10, 0.95, 0.84),
                 Align::center,
                 VerticalAlign::middle,
                 lines,
                 area.h * 0.62});
  return canvas.image();
}

}  // namespace marketgen::assets
