// Frame planes as pictures for people.
#include <algorithm>

#include "render/render.h"
#include "render/shading_math.h"

namespace marketgen {

Image draw_instances(const Frame& frame, int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < frame.instance.size(); ++i) {
    const std::uint32_t id = frame.instance[i];
    const std::uint32_t color =
        id == 0 ? 0 : raytrace::hashed(id) | 0x404040U;  // never as dark as nothing
    for (std::size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(color >> (8 * c));
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

}  // namespace marketgen
