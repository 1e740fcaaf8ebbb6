#include "server/view_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "base/hash.h"

namespace marketgen::server {
namespace {

constexpr float max_light = 4;  // times white
// The renderer's probes stand 0.6 m apart in the room and 0.45 m along shelves.
constexpr float max_edge_m = 0.6F;

void append(std::string& bytes, const auto& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::uint64_t hash_of(const ViewVertex& v) {
  std::string bytes;
  append(bytes, v.position);
  append(bytes, packed_normal(v.normal));
  append(bytes, v.uv);
  append(bytes, v.color);
  append(bytes, v.finish);
  append(bytes, v.owner);
  append(bytes, v.glow);
  return hash64(bytes);
}

bool same(Vec3f a, Vec3f b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool same(const ViewVertex& a, const ViewVertex& b) {
  return same(a.position, b.position) && packed_normal(a.normal) == packed_normal(b.normal) &&
         a.uv.x == b.uv.x && a.uv.y == b.uv.y && a.color == b.color && a.finish == b.finish &&
         a.owner == b.owner && same(a.glow, b.glow);
}

ViewVertex between(const ViewVertex& a, const ViewVertex& b) {
  ViewVertex middle = a;
  middle.position = (a.position + b.position) * 0.5F;
  const Vec3f normal = a.normal + b.normal;
  middle.normal = length(normal) > 0 ? normalized(normal) : a.normal;
  middle.uv = {(a.uv.x + b.uv.x) / 2, (a.uv.y + b.uv.y) / 2};
  return middle;
}

template <class Number, std::size_t Components, class Of>
void pack_rows(PackedSections& sections,
               std::string_view name,
               const std::vector<ViewVertex>& vertices,
               const Of& of) {
  std::vector<Number> rows;
  rows.reserve(vertices.size() * Components);
  for (const ViewVertex& vertex : vertices) {
    const std::array<Number, Components> row = of(vertex);
    rows.insert(rows.end(), row.begin(), row.end());
  }
  sections.add(name, Components, std::span<const Number>(rows));
}

}  // namespace

void for_short_triangles(const Corners& corners, const std::function<void(const Corners&)>& piece) {
  std::size_t longest = 0;
  float length_m = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float edge = length(corners[(k + 1) % 3].position - corners[k].position);
    if (edge > length_m) std::tie(longest, length_m) = std::pair(k, edge);
  }
  if (length_m <= max_edge_m) return piece(corners);
  const std::size_t next = (longest + 1) % 3;
  Corners first = corners, second = corners;
  first[next] = second[longest] = between(corners[longest], corners[next]);
  for_short_triangles(first, piece);
  for_short_triangles(second, piece);
}

std::uint32_t ViewMesh::add(const ViewVertex& vertex) {
  const std::uint64_t hash = hash_of(vertex);
  const auto [first, last] = known_.equal_range(hash);
  const auto found = std::find_if(
      first, last, [&](const auto& entry) { return same(vertices[entry.second], vertex); });
  if (found != last) return found->second;
  const auto number = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back(vertex);
  known_.emplace(hash, number);
  return number;
}

void ViewMesh::append(const ViewMesh& part) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const std::uint32_t index : part.indices)
    indices.push_back(first + index);
}

void ViewMesh::pack(PackedSections& sections) const {
  pack_rows<float, 3>(sections, "position", vertices, [](const ViewVertex& v) {
    return std::array<float, 3>{v.position.x, v.position.y, v.position.z};
  });
  pack_rows<std::int8_t, 4>(
      sections, "normal", vertices, [](const ViewVertex& v) { return packed_normal(v.normal); });
  pack_rows<float, 2>(sections, "uv", vertices, [](const ViewVertex& v) {
    return std::array<float, 2>{v.uv.x, v.uv.y};
  });
  pack_rows<std::uint8_t, 4>(
      sections, "color", vertices, [](const ViewVertex& v) { return v.color; });
  sections.add("index", 1, std::span<const std::uint32_t>(indices));
}

std::array<std::int8_t, 4> packed_normal(Vec3f normal) {
  const auto byte = [](float value) {
    return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127));
  };
  return {byte(normal.x), byte(normal.y), byte(normal.z), 0};
}

std::array<std::int16_t, 4> packed_rotation(const Quaternion& rotation) {
  const auto whole = [](double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767));
  };
  return {whole(rotation.x), whole(rotation.y), whole(rotation.z), whole(rotation.w)};
}

std::uint8_t packed_light(float light) {
  return static_cast<std::uint8_t>(
      std::lround(std::sqrt(std::clamp(light / max_light, 0.0F, 1.0F)) * 255));
}

}  // namespace marketgen::server
