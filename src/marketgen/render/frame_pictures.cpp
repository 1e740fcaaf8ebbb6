// Frame planes as pictures for people.
#include <algorithm>

#include "render/render.h"
#include "render/shading_math.h"

namespace marketgen::render {

std::array<std::uint8_t, 3> object_color(std::uint32_t object) {
  const std::uint32_t color =
      object == 0 ? 0 : raytrace::hashed(object) | 0x404040U;  // never as dark as nothing
  return {static_cast<std::uint8_t>(color),
          static_cast<std::uint8_t>(color >> 8),
          static_cast<std::uint8_t>(color >> 16)};
}

Image draw_instances(const Frame& frame, int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    const std::array<std::uint8_t, 3> color = object_color(frame.instance[i]);
    std::copy(color.begin(), color.end(), &image.pixels[3 * i]);
  }
  return image;
}

Image draw_normals(const Frame& frame, int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size() && i < frame.normals.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(
        std::clamp(frame.normals[i] * 0.5F + 0.5F, 0.0F, 1.0F) * 255 + 0.5F);
  }
  return image;
}

}  // namespace marketgen::render
