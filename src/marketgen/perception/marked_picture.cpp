#include "perception/marked_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "perception/picture_part.h"

namespace marketgen::perception {
namespace {

constexpr int digit_width = 5, digit_height = 7;
// A row of a digit is five bits, the leftmost the highest.
constexpr std::array<std::array<std::uint8_t, digit_height>, 10> digits{{
    {0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E},
    {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E},
    {0x0E, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1F},
    {0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E},
    {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02},
    {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E},
    {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E},
    {0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08},
    {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E},
    {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C},
}};
constexpr int digit_px = 2;                 // side of a digit's dot
constexpr int chip_edge_px = 4;             // between the number and the chip's border
constexpr int line_px = 2;                  // thickness of outlines and lines
constexpr int ring_px = 6, ring_ways = 24;  // of places tried round a mask's middle

// Far apart in hue, and all light enough for black digits (after Kelly's colours of most contrast).
constexpr std::array<Rgb8, 8> chip_colors{{{255, 225, 25},
                                           {60, 220, 90},
                                           {70, 200, 255},
                                           {255, 130, 40},
                                           {250, 130, 230},
                                           {180, 255, 60},
                                           {255, 255, 255},
                                           {170, 160, 255}}};
constexpr Rgb8 black{0, 0, 0};

int scale_to(int width, int height, int longer_side_px) {
  const int longer = std::max({1, width, height});
  return std::max(1, (longer_side_px + longer - 1) / longer);
}

Image enlarged(const Image& picture, int scale) {
  Image large(picture.width * scale, picture.height * scale, 3);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      std::copy_n(picture.at(x / scale, y / scale), 3, large.at(x, y));
  return large;
}

void fill(Image& picture, int left, int top, int width, int height, Rgb8 color) {
  for (int y = std::max(0, top); y < std::min(picture.height, top + height); ++y) {
    for (int x = std::max(0, left); x < std::min(picture.width, left + width); ++x) {
      std::uint8_t* at = picture.at(x, y);
      at[0] = color.r, at[1] = color.g, at[2] = color.b;
    }
  }
}

void draw_line(Image& picture, int x0, int y0, int x1, int y1, Rgb8 color) {
  const int steps = std::max({1, std::abs(x1 - x0), std::abs(y1 - y0)});
  for (int i = 0; i <= steps; ++i)
    fill(picture, x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps, line_px, line_px, color);
}

// Inside of every side of a pixel beyond which the mask does not go on.
void draw_outline(Image& picture, const Mask& mask, int scale, Rgb8 color) {
  const int width = picture.width / scale;
  std::vector<std::uint8_t> in(static_cast<std::size_t>(width) *
                               static_cast<std::size_t>(picture.height / scale));
  for (const std::uint32_t pixel : mask.pixels)
    if (pixel < in.size()) in[pixel] = 1;
  const int height = picture.height / scale;
  const auto holds = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height &&
           in[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(x)] != 0;
  };
  for (const std::uint32_t pixel : mask.pixels) {
    if (pixel >= in.size()) continue;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    const int left = x * scale, top = y * scale, far = scale - line_px;
    if (!holds(x, y - 1)) fill(picture, left, top, scale, line_px, color);
    if (!holds(x, y + 1)) fill(picture, left, top + far, scale, line_px, color);
    if (!holds(x - 1, y)) fill(picture, left, top, line_px, scale, color);
    if (!holds(x + 1, y)) fill(picture, left + far, top, line_px, scale, color);
  }
}

// The pixel of the mask that is nearest to its middle: an arc's middle is not on it.
std::array<int, 2> middle_px(const Mask& mask, int width) {
  const auto column = [&](std::uint32_t pixel) { return static_cast<int>(pixel) % width; };
  const auto row = [&](std::uint32_t pixel) { return static_cast<int>(pixel) / width; };
  double x = 0, y = 0;
  for (const std::uint32_t pixel : mask.pixels)
    x += column(pixel), y += row(pixel);
  x /= static_cast<double>(mask.pixels.size());
  y /= static_cast<double>(mask.pixels.size());
  const std::uint32_t nearest =
      *std::ranges::min_element(mask.pixels, {}, [&](std::uint32_t pixel) {
        return std::hypot(column(pixel) - x, row(pixel) - y);
      });
  return {column(nearest), row(nearest)};
}

bool overlap(const Mark& a, const Mark& b) {
  return a.view == b.view && std::abs(a.x_px - b.x_px) <= a.half_width_px + b.half_width_px &&
         std::abs(a.y_px - b.y_px) <= a.half_height_px + b.half_height_px;
}

// On the middle of what it is a mark of.
Mark chip_of(std::size_t number, Mark mark, const std::array<int, 2>& middle) {
  const int letters = static_cast<int>(std::to_string(number).size());
  mark.x_px = middle[0], mark.y_px = middle[1];
  mark.half_width_px = (letters * (digit_width + 1) - 1) * digit_px / 2 + chip_edge_px;
  mark.half_height_px = digit_height * digit_px / 2 + chip_edge_px;
  return mark;
}

// Where the chip has room: at the place, or on the narrowest ring round it.
std::optional<Mark> with_room(Mark chip, const Image& picture, const std::vector<Mark>& others) {
  const Mark wish = chip;
  const auto fits = [&](int x, int y) {
    if (picture.width <= 2 * chip.half_width_px || picture.height <= 2 * chip.half_height_px)
      return false;
    chip.x_px = std::clamp(x, chip.half_width_px, picture.width - 1 - chip.half_width_px);
    chip.y_px = std::clamp(y, chip.half_height_px, picture.height - 1 - chip.half_height_px);
    return std::ranges::none_of(others, [&](const Mark& other) { return overlap(chip, other); });
  };
  if (fits(wish.x_px, wish.y_px)) return chip;
  for (int radius = ring_px; radius < picture.width + picture.height; radius += ring_px) {
    for (int way = 0; way < ring_ways; ++way) {
      const double turn = 2 * std::numbers::pi * way / ring_ways;
      if (fits(wish.x_px + static_cast<int>(std::lround(radius * std::cos(turn))),
               wish.y_px + static_cast<int>(std::lround(radius * std::sin(turn)))))
        return chip;
    }
  }
  return std::nullopt;
}

void draw_chip(Image& picture, const Mark& chip, std::size_t number, Rgb8 color) {
  const int left = chip.x_px - chip.half_width_px, top = chip.y_px - chip.half_height_px;
  const int width = 2 * chip.half_width_px, height = 2 * chip.half_height_px;
  fill(picture, left, top, width, height, black);
  fill(picture, left + 1, top + 1, width - 2, height - 2, color);
  int x = left + chip_edge_px;
  for (const char letter : std::to_string(number)) {
    const auto& rows = digits[static_cast<std::size_t>(letter - '0')];
    for (int row = 0; row < digit_height; ++row)
      for (int column = 0; column < digit_width; ++column)
        if ((rows[static_cast<std::size_t>(row)] >> (digit_width - 1 - column) & 1) != 0)
          fill(picture,
               x + column * digit_px,
               top + chip_edge_px + row * digit_px,
               digit_px,
               digit_px,
               black);
    x += (digit_width + 1) * digit_px;
  }
}

// Largest first, those that can be seen.
std::vector<Mark> largest(const std::vector<ViewCloud>& views,
                          const std::vector<MaskedView>& masked) {
  std::vector<std::pair<std::size_t, Mark>> all;  // by pixels
  for (const MaskedView& of_view : masked) {
    for (std::size_t m = 0; m < of_view.masks.size(); ++m) {
      const std::vector<std::uint32_t>& pixels = of_view.masks[m].pixels;
      if (pixels.size() < min_mark_px) continue;
      if (std::ranges::max(pixels) >= views[of_view.view].size()) continue;
      all.push_back({pixels.size(), {of_view.view, m}});
    }
  }
  std::ranges::stable_sort(all, std::greater<>{}, [](const auto& each) { return each.first; });
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < std::min(max_marks, all.size()); ++i)
    marks.push_back(all[i].second);
  return marks;
}

const Mask& marked_mask(const std::vector<MaskedView>& masked, const Mark& mark) {
  return std::ranges::find(masked, mark.view, &MaskedView::view)->masks[mark.mask];
}

Rgb8 color_of(std::size_t number) {
  return chip_colors[number % chip_colors.size()];
}

// Over all outlines: lines first, so that none crosses a number.
void draw_numbers(const std::vector<std::array<int, 2>>& middles, MarkedPictures& made) {
  for (std::size_t i = 0; i < made.marks.size(); ++i) {
    const auto& [x, y] = middles[i];
    const Mark& mark = made.marks[i];
    draw_line(made.pictures[mark.view], x, y, mark.x_px, mark.y_px, color_of(i + 1));
  }
  for (std::size_t i = 0; i < made.marks.size(); ++i)
    draw_chip(made.pictures[made.marks[i].view], made.marks[i], i + 1, color_of(i + 1));
}

}  // namespace

MarkedPictures marked_pictures(const std::vector<ViewCloud>& views,
                               const std::vector<MaskedView>& masked) {
  MarkedPictures made;
  std::vector<int> scales;
  for (const ViewCloud& view : views) {
    scales.push_back(scale_to(view.width(), view.height(), marked_picture_px));
    made.pictures.push_back(enlarged(view.view().color, scales.back()));
  }
  std::vector<std::array<int, 2>> middles;
  for (const Mark& wish : largest(views, masked)) {
    const Mask& mask = marked_mask(masked, wish);
    Image& picture = made.pictures[wish.view];
    const int width = views[wish.view].width(), scale = scales[wish.view];
    const auto [column, row] = middle_px(mask, width);
    const std::array middle{column * scale + scale / 2, row * scale + scale / 2};
    const auto placed =
        with_room(chip_of(made.marks.size() + 1, wish, middle), picture, made.marks);
    if (!placed) continue;  // a picture smaller than its chips
    draw_outline(picture, mask, scale, color_of(made.marks.size() + 1));
    made.marks.push_back(*placed);
    middles.push_back(middle);
  }
  draw_numbers(middles, made);
  return made;
}

Image picture_of_mask(const ViewCloud& view, const Mask& mask) {
  const Image& whole = view.view().color;
  PicturePart part;
  for (const std::uint32_t pixel : mask.pixels)
    if (pixel < view.size())
      part.add(static_cast<int>(pixel) % whole.width, static_cast<int>(pixel) / whole.width);
  if (part.empty()) return whole;
  constexpr int around_share = 4;  // of its longer side, a quarter
  const int around = std::max(2, (std::max(part.width(), part.height()) - 1) / around_share);
  const Image alone = part.with_margin(around, whole.width, whole.height).cut(whole);
  return enlarged(alone, scale_to(alone.width, alone.height, crop_px));
}

}  // namespace marketgen::perception
