// Which of the renderer's textures a room shows, and how a page gets them: those that repeat each
// by itself, prints together on pages.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.h"
#include "geometry/vector.h"
#include "render/stage/world.h"
#include "server/picture_pages.h"
#include "server/view_files.h"

namespace marketgen::server {

class RoomTextures {
 public:
  explicit RoomTextures(const render::raytrace::World& world);

  // Number of the file that has a material's texture, -1 for none; where its UVs lie in there.
  int file_of(std::uint16_t material) const;
  Vec2f uv_in_file(std::uint16_t material, Vec2f uv) const;

  // In the order of their numbers: "textures/0.jpg" and on. Errors: image.*; those of
  // what draws a material.
  Result<std::vector<ViewFile>> files() const;
  nlohmann::ordered_json list() const;  // of the head of room.bin

 private:
  enum class Use { none, repeats, print };
  void look_at(const render::raytrace::TriangleSet& set);
  int texture_of(std::uint16_t material) const;
  PictureSize tile_size(std::size_t texture) const;
  Result<Image> tile_picture(std::size_t texture) const;

  const render::raytrace::World& world_;
  std::vector<Use> uses_;            // by texture
  std::vector<int> file_of_;         // by texture
  std::vector<int> repeating_;       // textures, by file
  std::vector<PictureSize> prints_;  // by texture; 0: not on a page
  PictureLayout pages_;
};

}  // namespace marketgen::server
