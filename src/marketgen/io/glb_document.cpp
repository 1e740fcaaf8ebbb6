#include "io/glb_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/build_info.h"
#include "base/hash.h"
#include "io/glb_format.h"

namespace marketgen::io {
namespace {

// Numbers of the glTF 2.0 specification.
enum BufferTarget { no_target = 0, array_buffer = 34962, element_array_buffer = 34963 };
constexpr int repeat_wrapping = 10497, linear_filter = 9729, trilinear_filter = 9987;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
  return std::as_bytes(std::span<const T>(values));
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0)
    bytes += with;
}

void append_uint(std::string& bytes, std::size_t value) {
  const auto narrow =
      static_cast<std::uint32_t>(value);  // glTF is little-endian, as every machine we build for
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

void append_chunk(std::string& file, std::uint32_t kind, const std::string& bytes) {
  append_uint(file, bytes.size());
  append_uint(file, kind);
  file += bytes;
}

std::vector<Vec3f> unit_normals(const std::vector<Vec3f>& normals) {
  std::vector<Vec3f> units;
  for (const Vec3f& n : normals)
    units.push_back(length(n) > 0 ? normalized(n) : Vec3f{0, 0, 1});
  return units;
}

// The store frame has Z up, glTF has Y up: a quarter turn about X, backwards.
GltfJson root_node(std::string_view name) {
  const float half = std::sqrt(0.5F);
  return {{"name", name}, {"rotation", json_array(std::array{-half, 0.0F, 0.0F, half})}};
}

// The triangles of every material that has some, in the order of materials.
std::vector<GlbPart> parts_of(const Mesh& mesh, const std::vector<int>& materials) {
  std::map<int, GlbPart> parts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int material = materials[mesh.surfaces[t]];
    GlbPart& part = parts[material];
    part.material = material;
    part.indices.insert(part.indices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  std::vector<GlbPart> list;
  for (auto& [material, part] : parts)
    list.push_back(std::move(part));
  return list;
}

}  // namespace

double json_number(float value) {
  return std::stod(fmt::format("{}", value));
}

GltfJson json_array(std::span<const float> values) {
  GltfJson array = GltfJson::array();
  for (const float value : values)
    array.push_back(json_number(value));
  return array;
}

std::array<float, 4> gltf_rotation(const Quaternion& q) {
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {static_cast<float>(q.x / norm),
          static_cast<float>(q.y / norm),
          static_cast<float>(q.z / norm),
          static_cast<float>(q.w / norm)};
}

GlbDocument::GlbDocument(std::string_view name) {
  json_["asset"] = {{"version", "2.0"}, {"generator", std::string("MarketGen ") + program_version}};
  json_["scene"] = 0;
  json_["scenes"] = GltfJson::array({{{"name", name}, {"nodes", {0}}}});
  json_["nodes"] = GltfJson::array({root_node(name)});
}

int GlbDocument::add_view(std::span<const std::byte> bytes, int target) {
  pad(buffer_, '\0');
  GltfJson view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != no_target) view["target"] = target;
  buffer_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  json_["bufferViews"].push_back(std::move(view));
  return static_cast<int>(json_["bufferViews"].size()) - 1;
}

int GlbDocument::add_accessor(std::span<const std::byte> bytes, GltfJson accessor, int target) {
  Hasher hash;
  hash.add(accessor.dump()).add(target).add_bytes(bytes);
  const auto [entry, is_new] =
      known_.try_emplace(hash.hex(), static_cast<int>(json_["accessors"].size()));
  if (!is_new) return entry->second;
  accessor["bufferView"] = add_view(bytes, target);
  json_["accessors"].push_back(std::move(accessor));
  return entry->second;
}

int GlbDocument::add_positions(const std::vector<Vec3f>& positions) {
  Bounds3 bounds;
  for (const Vec3f& p : positions)
    bounds.include(p);
  // In full, not in shortest form: validators compare with the bits.
  const auto exact = [](Vec3f v) {
    return GltfJson::array({double{v.x}, double{v.y}, double{v.z}});
  };
  return add_accessor(bytes_of(positions),
                      {{"componentType", glb_component::f32},
                       {"count", positions.size()},
                       {"type", "VEC3"},
                       {"min", exact(bounds.low)},
                       {"max", exact(bounds.high)}},
                      array_buffer);
}

int GlbDocument::add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  GltfJson accessor{
      {"componentType", glb_component::uint32}, {"count", indices.size()}, {"type", "SCALAR"}};
  if (vertices > 0xFFFF)
    return add_accessor(bytes_of(indices), std::move(accessor), element_array_buffer);
  accessor["componentType"] = glb_component::uint16;
  const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
  return add_accessor(bytes_of(narrow), std::move(accessor), element_array_buffer);
}

int GlbDocument::add_texture(std::string_view png) {
  if (!json_.contains("samplers")) {
    json_["samplers"] = GltfJson::array({{{"magFilter", linear_filter},
                                          {"minFilter", trilinear_filter},
                                          {"wrapS", repeat_wrapping},
                                          {"wrapT", repeat_wrapping}}});
  }
  const int view = add_view(std::as_bytes(std::span(png)), no_target);
  json_["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
  json_["textures"].push_back({{"sampler", 0}, {"source", json_["images"].size() - 1}});
  return static_cast<int>(json_["textures"].size()) - 1;
}

int GlbDocument::add_material(const GltfJson& material) {
  const auto [entry, is_new] =
      materials_.try_emplace(material.dump(), static_cast<int>(materials_.size()));
  if (is_new) json_["materials"].push_back(material);
  return entry->second;
}

int GlbDocument::add_mesh(const std::string& name,
                          const Mesh& mesh,
                          const std::vector<int>& materials) {
  GltfJson attributes{{"POSITION", add_positions(mesh.positions)}};
  attributes["NORMAL"] = add_accessor(
      bytes_of(unit_normals(mesh.normals)),
      {{"componentType", glb_component::f32}, {"count", mesh.normals.size()}, {"type", "VEC3"}},
      array_buffer);
  const bool textured = std::ranges::any_of(materials, [&](int material) {
    const GltfJson& pbr =
        json_["materials"][static_cast<std::size_t>(material)]["pbrMetallicRoughness"];
    return pbr.contains("baseColorTexture");
  });
  if (textured) {
    attributes["TEXCOORD_0"] = add_accessor(
        bytes_of(mesh.uvs),
        {{"componentType", glb_component::f32}, {"count", mesh.uvs.size()}, {"type", "VEC2"}},
        array_buffer);
  }
  GltfJson primitives = GltfJson::array();
  for (const GlbPart& part : parts_of(mesh, materials)) {
    primitives.push_back({{"attributes", attributes},
                          {"indices", add_indices(part.indices, mesh.positions.size())},
                          {"material", part.material}});
  }
  json_["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
  return static_cast<int>(json_["meshes"].size()) - 1;
}

int GlbDocument::add_points(const std::string& name, const std::vector<Vec3f>& points) {
  constexpr int points_mode = 0;
  GltfJson primitive{{"attributes", {{"POSITION", add_positions(points)}}}, {"mode", points_mode}};
  json_["meshes"].push_back({{"name", name}, {"primitives", GltfJson::array({primitive})}});
  return static_cast<int>(json_["meshes"].size()) - 1;
}

int GlbDocument::add_scene(std::string_view name) {
  const auto root = static_cast<int>(json_["nodes"].size());
  json_["nodes"].push_back(root_node(name));
  json_["scenes"].push_back({{"name", name}, {"nodes", {root}}});
  return root;
}

int GlbDocument::add_node(GltfJson node, int parent) {
  const auto index = static_cast<int>(json_["nodes"].size());
  json_["nodes"][static_cast<std::size_t>(std::max(parent, 0))]["children"].push_back(index);
  json_["nodes"].push_back(std::move(node));
  return index;
}

int GlbDocument::add_instanced_node(GltfJson node, const GlbInstances& instances, int parent) {
  const std::size_t count = instances.translations.size();
  const int translation =
      add_accessor(bytes_of(instances.translations),
                   {{"componentType", glb_component::f32}, {"count", count}, {"type", "VEC3"}},
                   no_target);
  const int rotation =
      add_accessor(bytes_of(instances.rotations),
                   {{"componentType", glb_component::f32}, {"count", count}, {"type", "VEC4"}},
                   no_target);
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translation},
                                                                 {"ROTATION", rotation}};
  if (!instances.ids.empty()) node["extras"]["ids"] = instances.ids;
  instanced_ = true;
  return add_node(std::move(node), parent);
}

std::string GlbDocument::finish() {
  if (instanced_) {
    json_["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    json_["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  }
  pad(buffer_, '\0');
  json_["buffers"] = GltfJson::array({{{"byteLength", buffer_.size()}}});
  std::string json = json_.dump();
  pad(json, ' ');
  std::string file;
  file.reserve(json.size() + buffer_.size() + 64);
  append_uint(file, glb_magic);
  append_uint(file, glb_version);
  append_uint(file, 12 + 8 + json.size() + 8 + buffer_.size());
  append_chunk(file, json_chunk, json);
  append_chunk(file, bin_chunk, buffer_);
  return file;
}

}  // namespace marketgen::io
