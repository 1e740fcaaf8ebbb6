// Textures: linear light in square-root encoding, 8 bits a channel, with mip levels; trilinear
// look-up.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/image.h"
#include "geometry/vector.h"

namespace marketgen::raytrace {

class Texture {
 public:
  Texture() = default;
  explicit Texture(const Image& image);

  // Linear RGB at (u, v); (0, 0) is the top left, both axes repeat. `lod` 0 = the image itself, 1 =
  // half its size.
  Vec3f sample(float u, float v, float lod) const;
  Vec3f mean() const { return sample(0.5F, 0.5F, 1e9F); }
  int width() const { return levels_.empty() ? 1 : levels_[0].width; }
  int height() const { return levels_.empty() ? 1 : levels_[0].height; }
  std::size_t bytes() const { return texels_.size() * sizeof(texels_[0]); }

 private:
  struct Level {
    int width = 1, height = 1;
    std::size_t offset = 0;
  };
  void add_level(const Level& finer);

  std::vector<std::uint32_t> texels_;
  std::vector<Level> levels_;
};

}  // namespace marketgen::raytrace
