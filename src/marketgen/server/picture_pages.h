// Many small pictures on few large ones.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "geometry/image.h"
#include "render/stage/texture.h"

namespace marketgen::server {

struct PictureSize {
  int width = 0, height = 0;
};
struct PagePlace {
  int page = -1;  // -1: no picture
  int x = 0, y = 0;
};

constexpr int max_page_px = 4096;  // the largest texture that every browser has
constexpr int gutter_px = 2;       // of its own border around each picture, for mip levels

struct PictureLayout {
  std::vector<PagePlace> places;  // in the pictures' order
  std::vector<PictureSize> pages;
};
// Rows of pictures, the highest first. A size of 0 takes no place. Precondition: none is larger
// than a page without its gutters.
PictureLayout lay_out(std::span<const PictureSize> pictures);

// What (0, 0) to (1, 1) of a picture is on its page: u0, v0, u1, v1.
std::array<float, 4> tile_of(const PictureLayout& layout,
                             std::size_t picture,
                             std::span<const PictureSize> sizes);

// A texture of the renderer as an sRGB picture of this size.
Image picture_of(const render::raytrace::Texture& texture, PictureSize size);
// A page with all pictures that lie on it, each with its border repeated into the gutter.
// `texture`: that of a picture.
Image painted_page(const PictureLayout& layout,
                   std::size_t number,
                   std::span<const PictureSize> sizes,
                   const std::function<const render::raytrace::Texture&(std::size_t)>& texture);

std::uint8_t srgb_byte(float linear);

}  // namespace marketgen::server
