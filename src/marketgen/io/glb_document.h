// A glTF 2.0 binary file under construction: the bytes, and the JSON that describes them.
//
// Equal blocks of data are stored once, so packs of one shape share their geometry whatever their
// labels show. (tinygltf's writer needs the whole model beside the file, and shares nothing; see
// docs/architecture.md, "Why our own".)
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen::io {

using GltfJson = nlohmann::ordered_json;

// Shortest JSON number that reads back as this float.
double json_number(float value);
GltfJson json_array(std::span<const float> values);
// glTF writes quaternions x, y, z, w.
std::array<float, 4> gltf_rotation(const Quaternion& q);

// Triangles of one material.
struct GlbPart {
  int material = 0;
  std::vector<std::uint32_t> indices;
};

// Where the copies of a mesh stand.
struct GlbInstances {
  std::vector<std::array<float, 3>> translations;
  std::vector<std::array<float, 4>> rotations;  // x, y, z, w
  std::vector<std::string> ids;                 // one per copy; may be empty
};

class GlbDocument {
 public:
  explicit GlbDocument(std::string_view name);

  // Each returns the index that others refer to it by. Equal materials are one.
  int add_texture(std::string_view png);
  int add_material(const GltfJson& material);
  // `materials[i]` for triangles of surface i. Normals are made unit; UVs are left out when no
  // material has a texture.
  int add_mesh(const std::string& name, const Mesh& mesh, const std::vector<int>& materials);

  // Points alone, without triangles or material.
  int add_points(const std::string& name, const std::vector<Vec3f>& points);

  // Another scene in the store frame; returns its root, a parent for nodes.
  int add_scene(std::string_view name);
  // A node under `parent`; -1 is the store's root, whose children are in the store frame (Z up).
  int add_node(GltfJson node, int parent);
  // One node whose mesh is drawn at every place (EXT_mesh_gpu_instancing); extras.ids says which
  // product each one is.
  int add_instanced_node(GltfJson node, const GlbInstances& instances, int parent);

  // The whole file.
  std::string finish();

 private:
  int add_accessor(std::span<const std::byte> bytes, GltfJson accessor, int target);
  int add_view(std::span<const std::byte> bytes, int target);
  int add_positions(const std::vector<Vec3f>& positions);
  int add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices);

  GltfJson json_;
  std::string buffer_;
  std::map<std::string, int> known_;  // hash of a block and its description -> accessor
  std::map<std::string, int> materials_;
  bool instanced_ = false;
};

}  // namespace marketgen::io
