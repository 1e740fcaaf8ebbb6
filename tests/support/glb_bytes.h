// GLB files put together by hand, for tests of their readers.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace marketgen {

inline std::string little_endian(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

template <class T>
std::string raw_bytes(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// Header, JSON chunk, binary chunk: glTF 2.0 specification, section 4.4.
inline std::string glb_bytes(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto total = static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size());
  return "glTF" + little_endian(2) + little_endian(total) +
         little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
         little_endian(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) +
         binary;
}

// The corners and triangles of a box from `low` to `high`, outside counter-clockwise.
inline std::vector<float> box_corners(float x0, float y0, float z0, float x1, float y1, float z1) {
  std::vector<float> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back((i & 1) != 0 ? x1 : x0);
    corners.push_back((i & 2) != 0 ? y1 : y0);
    corners.push_back((i & 4) != 0 ? z1 : z0);
  }
  return corners;
}
inline const std::vector<std::uint16_t>& box_triangles() {
  static const std::vector<std::uint16_t> list{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
                                               0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7,
                                               0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return list;
}

// A GLB of one box mesh called "Object"; `more` is put into the JSON's top level, with a comma
// before it. Positions are accessor 0, indices accessor 1.
inline std::string box_glb(float width,
                           float height,
                           float depth,
                           const std::string& node = R"({"mesh": 0, "name": "box"})",
                           const std::string& more = "",
                           std::string binary_after = "") {
  const std::string positions =
      raw_bytes(box_corners(-width / 2, 0, -depth / 2, width / 2, height, depth / 2));
  const std::string indices = raw_bytes(box_triangles());
  const std::string json =
      R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + node +
      R"(], "meshes": [{"name": "Object", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                    {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
    "buffers": [{"byteLength": )" +
      std::to_string(168 + binary_after.size()) + "}]" + more + "}";
  return glb_bytes(json, positions + indices + std::move(binary_after));
}

}  // namespace marketgen
