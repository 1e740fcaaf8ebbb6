#include <tiny_gltf.h>

#include <cstring>
#include <set>

#include "export/exporter.h"
#include "io/file.h"

// Reads a GLB export with tinygltf, walks its nodes in glTF's own frame (Y up) and turns the result
// back into the store's.
namespace marketgen::exporters {
namespace {

Pose pose_of(const std::vector<double>& translation, const std::vector<double>& rotation) {
  Pose pose;
  if (translation.size() == 3) pose.position = {translation[0], translation[1], translation[2]};
  if (rotation.size() == 4) pose.rotation = {rotation[3], rotation[0], rotation[1], rotation[2]};
  return pose;
}

Vec3 store_from_gltf(Vec3 p) {
  return {p.x, -p.z, p.y};
}

// tinygltf's decoder, which keeps no pixels: that they decode is all we want to know.
bool decode_and_drop(tinygltf::Image* image,
                     int index,
                     std::string* fault,
                     std::string* warning,
                     int width,
                     int height,
                     const unsigned char* bytes,
                     int size,
                     void* user) {
  const bool decoded =
      tinygltf::LoadImageData(image, index, fault, warning, width, height, bytes, size, user);
  image->image = {};
  return decoded;
}

class Reader {
 public:
  Reader(const tinygltf::Model& model, std::string where)
      : model_(model), where_(std::move(where)) {}

  Result<ExportContents> read() {
    contents_.meshes = model_.meshes.size();
    const int scene = model_.defaultScene;
    if (scene < 0 || scene >= static_cast<int>(model_.scenes.size()))
      return fault("it has no scene to show");
    for (const int node : model_.scenes[static_cast<std::size_t>(scene)].nodes)
      MARKETGEN_CHECK(walk(node, {}));
    return contents_;
  }

 private:
  Error fault(const std::string& what) const {
    return {"export.mismatch", where_, what + "; export the store again"};
  }

  Result<void> walk(int index, const Pose& gltf_from_parent) {
    if (index < 0 || index >= static_cast<int>(model_.nodes.size()) ||
        !seen_.insert(index).second) {
      return fault("its nodes are no tree");
    }
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    if (!node.scale.empty() || !node.matrix.empty())
      return fault("node \"" + node.name + "\" is scaled");
    const Pose pose = gltf_from_parent * pose_of(node.translation, node.rotation);
    if (node.mesh >= 0) MARKETGEN_CHECK(read_mesh_node(node, pose));
    for (const int child : node.children)
      MARKETGEN_CHECK(walk(child, pose));
    return {};
  }

  Result<void> read_mesh_node(const tinygltf::Node& node, const Pose& pose) {
    MARKETGEN_TRY(const Bounds3 local, bounds_of_mesh(node.mesh));
    MARKETGEN_TRY(const std::vector<Pose> places, places_of(node, pose));
    for (const Pose& place : places)
      include_corners(local, place);
    if (node.extras.Has("fixture"))
      contents_.fixtures.insert(node.extras.Get("fixture").Get<std::string>());
    if (!node.extras.Has("sku")) return {};
    const std::string sku = node.extras.Get("sku").Get<std::string>();
    const tinygltf::Value ids = node.extras.Get("ids");
    const bool instanced = node.extras.Has("ids");
    if (instanced && ids.ArrayLen() != places.size())
      return fault("node \"" + node.name + "\" has another number of ids than of places");
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string id =
          instanced ? ids.Get(static_cast<int>(i)).Get<std::string>() : node.name;
      contents_.products.push_back({id, sku, store_from_gltf(places[i].position)});
    }
    return {};
  }

  // Where the node's mesh is drawn: once, or at the places of EXT_mesh_gpu_instancing.
  Result<std::vector<Pose>> places_of(const tinygltf::Node& node, const Pose& pose) const {
    const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == node.extensions.end()) return std::vector<Pose>{pose};
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    MARKETGEN_TRY(const std::vector<double> translations,
                  floats_of(attributes.Get("TRANSLATION").GetNumberAsInt(), TINYGLTF_TYPE_VEC3));
    MARKETGEN_TRY(const std::vector<double> rotations,
                  floats_of(attributes.Get("ROTATION").GetNumberAsInt(), TINYGLTF_TYPE_VEC4));
    if (translations.size() / 3 != rotations.size() / 4)
      return fault("node \"" + node.name + "\" has unequal instance attributes");
    std::vector<Pose> places;
    for (std::size_t i = 0; i < translations.size() / 3; ++i) {
      places.push_back(pose * pose_of({&translations[3 * i], &translations[3 * i] + 3},
                                      {&rotations[4 * i], &rotations[4 * i] + 4}));
    }
    return places;
  }

  // All numbers of a float accessor, bounds checked: tinygltf does not.
  Result<std::vector<double>> floats_of(int index, int type) const {
    if (index < 0 || index >= static_cast<int>(model_.accessors.size()))
      return fault("an accessor is missing");
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    if (accessor.type != type || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
      return fault("an accessor has another type");
    if (accessor.bufferView < 0 ||
        accessor.bufferView >= static_cast<int>(model_.bufferViews.size()))
      return fault("a buffer view is missing");
    const tinygltf::BufferView& view =
        model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || view.buffer >= static_cast<int>(model_.buffers.size()))
      return fault("a buffer is missing");
    const std::vector<unsigned char>& bytes =
        model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const auto components = static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
    const std::size_t stride = view.byteStride > 0 ? view.byteStride : components * sizeof(float);
    const std::size_t start = view.byteOffset + accessor.byteOffset;
    if (accessor.count == 0) return std::vector<double>{};
    if (accessor.count > bytes.size() / stride + 1 ||
        start + (accessor.count - 1) * stride + components * sizeof(float) > bytes.size()) {
      return fault("an accessor reaches beyond its buffer");
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < accessor.count; ++i) {
      for (std::size_t c = 0; c < components; ++c) {
        float value = 0;
        std::memcpy(&value, bytes.data() + start + i * stride + c * sizeof value, sizeof value);
        values.push_back(value);
      }
    }
    return values;
  }

  // From the positions themselves, not from what the accessor says about them.
  Result<Bounds3> bounds_of_mesh(int index) {
    if (index >= static_cast<int>(model_.meshes.size())) return fault("a mesh is missing");
    const auto known = mesh_bounds_.find(index);
    if (known != mesh_bounds_.end()) return known->second;
    Bounds3 bounds;
    for (const tinygltf::Primitive& primitive :
         model_.meshes[static_cast<std::size_t>(index)].primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end()) return fault("a mesh has no positions");
      MARKETGEN_TRY(const std::vector<double> p, floats_of(position->second, TINYGLTF_TYPE_VEC3));
      for (std::size_t i = 0; i + 2 < p.size(); i += 3)
        bounds.include(to_float(Vec3{p[i], p[i + 1], p[i + 2]}));
    }
    mesh_bounds_.emplace(index, bounds);
    return bounds;
  }

  void include_corners(const Bounds3& local, const Pose& place) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p{(corner & 1) != 0 ? local.high.x : local.low.x,
                   (corner & 2) != 0 ? local.high.y : local.low.y,
                   (corner & 4) != 0 ? local.high.z : local.low.z};
      contents_.bounds.include(to_float(store_from_gltf(place * p)));
    }
  }

  const tinygltf::Model& model_;
  std::string where_;
  std::set<int> seen_;
  std::map<int, Bounds3> mesh_bounds_;
  ExportContents contents_;
};

}  // namespace

Result<ExportContents> read_glb(const std::filesystem::path& file,
                                const std::vector<catalog::Product>& /*catalog*/) {
  MARKETGEN_TRY(const std::string bytes, io::read_file(file));
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(decode_and_drop, nullptr);
  tinygltf::Model model;
  std::string fault, warning;
  const bool loaded =
      loader.LoadBinaryFromMemory(&model,
                                  &fault,
                                  &warning,
                                  reinterpret_cast<const unsigned char*>(bytes.data()),
                                  static_cast<unsigned int>(bytes.size()));
  if (!loaded) return Error{"export.mismatch", file.string(), "tinygltf cannot read it: " + fault};
  return Reader(model, file.string()).read();
}

}  // namespace marketgen::exporters
