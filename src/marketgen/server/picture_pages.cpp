#include "server/picture_pages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/srgb.h"

namespace marketgen::server {
namespace {

// sRGB bytes by linear light, fine enough that none is off by more than one.
constexpr int srgb_steps = 4096;

// At the middle of each step.
std::array<std::uint8_t, srgb_steps> make_srgb_table() {
  std::array<std::uint8_t, srgb_steps> table{};
  for (int i = 0; i < srgb_steps; ++i) {
    // Steps lie evenly over the square root: dark tones need the most.
    const double root = (i + 0.5) / srgb_steps, l = root * root;
    table[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(srgb_encoded(l) * 255));
  }
  return table;
}

// The row of pictures that is being filled.
struct Row {
  int y = 0, height = 0, x = 0;
};

void paste(Image& page, const Image& picture, const PagePlace& place) {
  for (int y = -gutter_px; y < picture.height + gutter_px; ++y) {
    for (int x = -gutter_px; x < picture.width + gutter_px; ++x) {
      const std::uint8_t* from =
          picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
      std::copy_n(from, 3, page.at(place.x + x, place.y + y));
    }
  }
}

}  // namespace

std::uint8_t srgb_byte(float linear) {
  static const auto table = make_srgb_table();
  const float root = std::sqrt(std::clamp(linear, 0.0F, 1.0F));
  return table[static_cast<std::size_t>(
      std::min(static_cast<int>(root * srgb_steps), srgb_steps - 1))];
}

PictureLayout lay_out(std::span<const PictureSize> pictures) {
  PictureLayout layout{std::vector<PagePlace>(pictures.size()), {}};
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, std::ranges::greater{}, [&](std::size_t i) { return pictures[i].height; });
  Row row;
  for (const std::size_t i : order) {
    if (pictures[i].width == 0 || pictures[i].height == 0) continue;
    const int width = pictures[i].width + 2 * gutter_px,
              height = pictures[i].height + 2 * gutter_px;
    if (row.x + width > max_page_px) row = {row.y + row.height, 0, 0};
    if (layout.pages.empty() || row.y + height > max_page_px) {
      layout.pages.push_back({});
      row = {};
    }
    row.height = std::max(row.height, height);
    PictureSize& page = layout.pages.back();
    layout.places[i] = {
        static_cast<int>(layout.pages.size()) - 1, row.x + gutter_px, row.y + gutter_px};
    row.x += width;
    page = {std::max(page.width, row.x), std::max(page.height, row.y + height)};
  }
  return layout;
}

std::array<float, 4> tile_of(const PictureLayout& layout,
                             std::size_t picture,
                             std::span<const PictureSize> sizes) {
  const PagePlace& place = layout.places[picture];
  if (place.page < 0) return {0, 0, 1, 1};
  const PictureSize& page = layout.pages[static_cast<std::size_t>(place.page)];
  const auto across = static_cast<float>(page.width), down = static_cast<float>(page.height);
  return {static_cast<float>(place.x) / across,
          static_cast<float>(place.y) / down,
          static_cast<float>(place.x + sizes[picture].width) / across,
          static_cast<float>(place.y + sizes[picture].height) / down};
}

Image picture_of(const render::raytrace::Texture& texture, PictureSize size) {
  Image image(size.width, size.height);
  const float lod = std::max(
      0.0F, std::log2(static_cast<float>(texture.width()) / static_cast<float>(size.width)));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto linear =
          texture.sample((static_cast<float>(x) + 0.5F) / static_cast<float>(size.width),
                         (static_cast<float>(y) + 0.5F) / static_cast<float>(size.height),
                         lod);
      std::uint8_t* pixel = image.at(x, y);
      pixel[0] = srgb_byte(linear.x);
      pixel[1] = srgb_byte(linear.y);
      pixel[2] = srgb_byte(linear.z);
    }
  }
  return image;
}

Image painted_page(const PictureLayout& layout,
                   std::size_t number,
                   std::span<const PictureSize> sizes,
                   const std::function<const render::raytrace::Texture&(std::size_t)>& texture) {
  Image page(layout.pages[number].width, layout.pages[number].height);
  parallel_for(sizes.size(), [&](std::size_t i) {
    if (layout.places[i].page == static_cast<int>(number))
      paste(page, picture_of(texture(i), sizes[i]), layout.places[i]);
  });
  return page;
}

}  // namespace marketgen::server
