// Triangles as a page draws them: one buffer of vertices, small numbers for all but places.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "geometry/pose.h"
#include "geometry/vector.h"
#include "server/packed_sections.h"

namespace marketgen::server {

constexpr std::uint16_t no_row = 65535;

struct ViewVertex {
  Vec3f position, normal;
  Vec2f uv;
  std::array<std::uint8_t, 4> color{255, 255, 255, 255};  // sRGB; a: 255 = times the texture
  std::array<std::uint8_t, 4> finish{};                   // roughness, metallic
  std::array<std::uint16_t, 2> owner{no_row, no_row};     // fixture, joint
  Vec3f glow;  // light that it gives by itself, exposed; zero: it is lit
};

using Corners = std::array<ViewVertex, 3>;

// Halves a triangle's longest edge until none is too long for light that is stored at corners, and
// hands each piece on.
void for_short_triangles(const Corners& corners, const std::function<void(const Corners&)>& piece);

// Vertices that are alike in everything are one.
class ViewMesh {
 public:
  std::uint32_t add(const ViewVertex& vertex);
  // From now on no vertex is shared with those before.
  void begin_part() { known_.clear(); }

  // Its vertices stay apart from those that are there.
  void append(const ViewMesh& part);

  std::vector<ViewVertex> vertices;
  std::vector<std::uint32_t> indices;

  // Sections position, normal, uv, color, index.
  void pack(PackedSections& sections) const;

 private:
  std::unordered_multimap<std::uint64_t, std::uint32_t> known_;  // by hash
};

std::array<std::int8_t, 4> packed_normal(Vec3f normal);
// x, y, z, w as 32,767ths.
std::array<std::int16_t, 4> packed_rotation(const Quaternion& rotation);
// sqrt(light / 4) in 255ths: dark places keep their tones.
std::uint8_t packed_light(float light);

}  // namespace marketgen::server
