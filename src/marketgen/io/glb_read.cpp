#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "io/glb_chunks.h"
#include "io/model_parts.h"

// parse_glb: walks the nodes of the shown scene and gathers their triangles in the scene's frame.
namespace marketgen::io {
namespace {

// Numbers of the glTF 2.0 specification.
enum PrimitiveMode : std::size_t { triangles = 4, triangle_strip = 5, triangle_fan = 6 };
constexpr std::size_t max_nodes = 20'000, max_pictures = 32, max_materials = 256;
constexpr int deepest_node = 64;
constexpr std::size_t max_pieces = 256;
constexpr std::uint64_t max_pixels_together = 128'000'000;

// A 3x4 transform, row by row.
struct Affine {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vec3 linear(Vec3 p) const {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z,
            m[4] * p.x + m[5] * p.y + m[6] * p.z,
            m[8] * p.x + m[9] * p.y + m[10] * p.z};
  }
  Vec3 column(std::size_t c) const { return {m[c], m[4 + c], m[8 + c]}; }
  Vec3 apply(Vec3 p) const { return linear(p) + column(3); }
  double determinant() const { return dot(column(0), cross(column(1), column(2))); }
  // Normals turn with the cofactors, which have the inverse transpose's direction.
  Vec3 turn(Vec3 n) const {
    return cross(column(1), column(2)) * n.x + cross(column(2), column(0)) * n.y +
           cross(column(0), column(1)) * n.z;
  }
};

Affine from_columns(Vec3 x, Vec3 y, Vec3 z, Vec3 origin) {
  return {{x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y, x.z, y.z, z.z, origin.z}};
}

Affine operator*(const Affine& a, const Affine& b) {
  return from_columns(
      a.linear(b.column(0)), a.linear(b.column(1)), a.linear(b.column(2)), a.apply(b.column(3)));
}

Vec3 vec3_at(const std::vector<double>& v, std::size_t at) {
  return {v[at], v[at + 1], v[at + 2]};
}

Affine transform_of(const GlbJson& node) {
  if (const auto matrix = glb_numbers(node, "matrix", 16)) {  // column by column
    return from_columns(
        vec3_at(*matrix, 0), vec3_at(*matrix, 4), vec3_at(*matrix, 8), vec3_at(*matrix, 12));
  }
  const auto q =
      glb_numbers(node, "rotation", 4).value_or(std::vector<double>{0, 0, 0, 1});  // x y z w
  const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  const double two = norm > 0 ? 2 / norm : 0;
  const Vec3 scale =
      vec3_at(glb_numbers(node, "scale", 3).value_or(std::vector<double>{1, 1, 1}), 0);
  const Vec3 x{1 - two * (q[1] * q[1] + q[2] * q[2]),
               two * (q[0] * q[1] + q[2] * q[3]),
               two * (q[0] * q[2] - q[1] * q[3])};
  const Vec3 y{two * (q[0] * q[1] - q[2] * q[3]),
               1 - two * (q[0] * q[0] + q[2] * q[2]),
               two * (q[1] * q[2] + q[0] * q[3])};
  const Vec3 z{two * (q[0] * q[2] + q[1] * q[3]),
               two * (q[1] * q[2] - q[0] * q[3]),
               1 - two * (q[0] * q[0] + q[1] * q[1])};
  const Vec3 origin =
      vec3_at(glb_numbers(node, "translation", 3).value_or(std::vector<double>{0, 0, 0}), 0);
  return from_columns(x * scale.x, y * scale.y, z * scale.z, origin);
}

// Corner numbers of a primitive's triangles.
Result<std::vector<std::array<std::uint32_t, 3>>> triangles_of(
    const std::vector<std::uint32_t>& corners,
    std::size_t mode,
    std::size_t vertices,
    const std::string& source) {
  for (const std::uint32_t corner : corners) {
    if (corner >= vertices)
      return bad_model(source, fmt::format("a triangle names vertex {} of {}", corner, vertices));
  }
  std::vector<std::array<std::uint32_t, 3>> list;
  const std::size_t step = mode == triangles ? 3 : 1;
  for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
    if (mode == triangle_fan)
      list.push_back({corners[0], corners[i + 1], corners[i + 2]});
    else if (mode == triangle_strip && i % 2 == 1)
      list.push_back({corners[i + 1], corners[i], corners[i + 2]});
    else
      list.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  return list;
}

Vec3f mean_of(const Image& image) {
  Vec3 sum{};
  const std::size_t pixels = image.pixels.size() / static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* p = &image.pixels[i * static_cast<std::size_t>(image.channels)];
    sum += Vec3{double(p[0]), double(p[1]), double(p[2])};
  }
  return to_float(sum / (255.0 * static_cast<double>(std::max<std::size_t>(1, pixels))));
}

class GlbReader {
 public:
  GlbReader(const GlbChunks& glb, const std::string& source) : glb_(glb), source_(source) {}

  Result<OutsideModel> read() {
    MARKETGEN_CHECK(check_extensions());
    MARKETGEN_CHECK(read_materials());
    const GlbJson& scenes = glb_list(glb_.json, "scenes");
    const std::size_t shown = glb_index(glb_.json, "scene").value_or(0);
    if (shown >= scenes.size())
      return Error{"model.no_mesh", source_, "has no scene to show; export the shape in a scene"};
    MARKETGEN_CHECK(walk_scene(scenes[shown], /*contact=*/false));
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (i != shown && glb_text(scenes[i], "name") == "contact")
        MARKETGEN_CHECK(walk_scene(scenes[i], /*contact=*/true));
    }
    return finished_model(std::move(model_), source_);
  }

 private:
  void remark(const std::string& text) {
    if (std::find(model_.remarks.begin(), model_.remarks.end(), text) == model_.remarks.end())
      model_.remarks.push_back(text);
  }

  Result<void> check_extensions() {
    for (const GlbJson& name : glb_list(glb_.json, "extensionsRequired")) {
      for (const char* unread : {"KHR_draco_mesh_compression",
                                 "EXT_meshopt_compression",
                                 "KHR_texture_basisu",
                                 "EXT_texture_webp"}) {
        if (name == unread)
          return bad_model(
              source_, fmt::format("needs {}, which is not read; export it uncompressed", unread));
      }
    }
    for (const GlbJson& name : glb_list(glb_.json, "extensionsUsed")) {
      if (name == "KHR_texture_transform")
        remark("KHR_texture_transform is ignored: pictures may lie differently");
    }
    return {};
  }

  // The picture behind a texture reference, decoded once. -1: there is none that can be read.
  Result<int> picture_of(const GlbJson& reference) {
    const auto texture = glb_index(reference, "index");
    if (!texture) return -1;
    MARKETGEN_TRY(const GlbJson* row, glb_row(glb_, "textures", *texture, source_));
    const auto image = glb_index(*row, "source");
    if (!image) return -1;
    const auto known = picture_of_image_.find(*image);
    if (known != picture_of_image_.end()) return known->second;
    MARKETGEN_TRY(const GlbJson* described, glb_row(glb_, "images", *image, source_));
    if (described->contains("uri")) {
      return Error{"input.outside_folder",
                   source_,
                   fmt::format("/images/{} is another file, {}; a GLB must hold its pictures "
                               "itself: export it with its data inside",
                               *image,
                               quoted_name(glb_text(*described, "uri")))};
    }
    const auto view = glb_index(*described, "bufferView");
    if (!view) return -1;
    if (model_.pictures.size() >= max_pictures)
      return Error{"input.too_large", source_, "has more than 32 pictures"};
    MARKETGEN_TRY(const std::string_view bytes, glb_view(glb_, *view, source_));
    MARKETGEN_TRY(Image picture,
                  decode_picture(bytes, fmt::format("{}:/images/{}", source_, *image)));
    pixels_ += picture.pixels.size() / static_cast<std::size_t>(picture.channels);
    if (pixels_ > max_pixels_together)
      return Error{"input.too_large", source_, "its pictures have more than 128 megapixels"};
    model_.pictures.push_back(std::move(picture));
    const int index = static_cast<int>(model_.pictures.size()) - 1;
    picture_of_image_.emplace(*image, index);
    return index;
  }

  Result<void> read_materials() {
    const GlbJson& rows = glb_list(glb_.json, "materials");
    if (rows.size() > max_materials)
      return Error{"input.too_large", source_, "has more than 256 materials"};
    for (const GlbJson& row : rows) {
      MARKETGEN_TRY(const ModelMaterial material, material_of(row));
      model_.materials.push_back(material);
      texture_set_.push_back(
          glb_index(glb_object(glb_object(row, "pbrMetallicRoughness"), "baseColorTexture"),
                    "texCoord")
              .value_or(0));
    }
    model_.materials.push_back({});  // of primitives that name none
    texture_set_.push_back(0);
    return {};
  }

  Result<ModelMaterial> material_of(const GlbJson& row) {
    const GlbJson& pbr = glb_object(row, "pbrMetallicRoughness");
    const auto unit = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
    ModelMaterial material;
    material.name = glb_text(row, "name").substr(0, 80);
    const auto color =
        glb_numbers(pbr, "baseColorFactor", 4).value_or(std::vector<double>{1, 1, 1, 1});
    material.color = {unit(color[0]), unit(color[1]), unit(color[2])};
    material.clear = glb_text(row, "alphaMode") == "BLEND" && color[3] < 1;
    material.roughness = unit(glb_number(pbr, "roughnessFactor").value_or(1));
    material.metallic = unit(glb_number(pbr, "metallicFactor").value_or(1));
    MARKETGEN_TRY(material.picture, picture_of(glb_object(pbr, "baseColorTexture")));
    MARKETGEN_TRY(const int surface, picture_of(glb_object(pbr, "metallicRoughnessTexture")));
    if (surface >= 0) {  // green is roughness, blue is metallic; the mean stands for all
      const Vec3f mean = mean_of(model_.pictures[static_cast<std::size_t>(surface)]);
      material.roughness *= mean.y;
      material.metallic *= mean.z;
    }
    return material;
  }

  Result<void> walk_scene(const GlbJson& scene, bool contact) {
    seen_.clear();
    for (const GlbJson& node : glb_list(scene, "nodes"))
      MARKETGEN_CHECK(walk(node, {}, contact, 0));
    return {};
  }

  Result<void> walk(const GlbJson& index,
                    const Affine& scene_from_parent,
                    bool contact,
                    int depth) {
    const GlbJson& nodes = glb_list(glb_.json, "nodes");
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= nodes.size() ||
        !seen_.insert(index.get<std::size_t>()).second)
      return bad_model(source_, "its nodes are no tree; export it again");
    if (depth > deepest_node || seen_.size() > max_nodes)
      return Error{"input.too_large", source_, "has more than 20,000 nodes or 64 levels of them"};
    const GlbJson& node = nodes[index.get<std::size_t>()];
    const Affine scene_from_node = scene_from_parent * transform_of(node);
    if (const auto mesh = glb_index(node, "mesh")) {
      if (!contact) keep_name(model_, glb_text(node, "name"));
      MARKETGEN_CHECK(read_mesh(*mesh, scene_from_node, contact));
    }
    for (const GlbJson& child : glb_list(node, "children"))
      MARKETGEN_CHECK(walk(child, scene_from_node, contact, depth + 1));
    return {};
  }

  Result<void> read_mesh(std::size_t index, const Affine& scene_from_mesh, bool contact) {
    MARKETGEN_TRY(const GlbJson* row, glb_row(glb_, "meshes", index, source_));
    if (!contact) keep_name(model_, glb_text(*row, "name"));
    for (const GlbJson& primitive : glb_list(*row, "primitives")) {
      MARKETGEN_CHECK(contact ? read_piece(primitive, scene_from_mesh)
                              : read_primitive(primitive, scene_from_mesh));
    }
    return {};
  }

  Result<std::vector<float>> attribute(const GlbJson& primitive,
                                       const std::string& name,
                                       std::size_t width) {
    const auto accessor = glb_index(glb_object(primitive, "attributes"), name.c_str());
    if (!accessor) return std::vector<float>{};
    return glb_floats(glb_, *accessor, width, 3 * max_model_triangles, source_);
  }

  Result<std::vector<Vec3f>> positions_of(const GlbJson& primitive, const Affine& scene_from_mesh) {
    MARKETGEN_TRY(const std::vector<float> values, attribute(primitive, "POSITION", 3));
    std::vector<Vec3f> positions;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      positions.push_back(
          to_float(scene_from_mesh.apply({values[i], values[i + 1], values[i + 2]})));
    MARKETGEN_CHECK(check_points(positions, source_));
    return positions;
  }

  Result<void> read_piece(const GlbJson& primitive, const Affine& scene_from_mesh) {
    MARKETGEN_TRY(std::vector<Vec3f> points, positions_of(primitive, scene_from_mesh));
    if (model_.pieces.size() >= max_pieces || points.size() > 4096)
      return Error{"input.too_large", source_, "has more than 256 contact pieces or 4096 points"};
    if (!points.empty()) model_.pieces.push_back(std::move(points));
    return {};
  }

  Result<void> read_primitive(const GlbJson& primitive, const Affine& scene_from_mesh) {
    const std::size_t mode = glb_index(primitive, "mode").value_or(triangles);
    if (mode < triangles || mode > triangle_fan) {
      remark("points and lines are left out");
      return {};
    }
    Mesh mesh;
    MARKETGEN_TRY(mesh.positions, positions_of(primitive, scene_from_mesh));
    std::size_t surface = glb_index(primitive, "material").value_or(model_.materials.size() - 1);
    surface = std::min(surface, model_.materials.size() - 1);
    MARKETGEN_CHECK(read_triangles(primitive, mode, mesh));
    if (scene_from_mesh.determinant() < 0) {  // a mirrored copy: keep the outside outside
      for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    }
    mesh.surfaces.assign(mesh.triangles.size(), static_cast<std::uint16_t>(surface));
    MARKETGEN_CHECK(read_uvs(primitive, texture_set_[surface], mesh));
    MARKETGEN_CHECK(read_normals(primitive, scene_from_mesh, mesh));
    model_.mesh.append(mesh);
    if (model_.mesh.triangles.size() > max_model_triangles ||
        model_.mesh.positions.size() > 3 * max_model_triangles)
      return Error{"input.too_large",
                   source_,
                   "has more than 1,000,000 triangles; export it with fewer (1,000 to 20,000 are "
                   "right for a pack)"};
    return {};
  }

  Result<void> read_triangles(const GlbJson& primitive, std::size_t mode, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    if (const auto accessor = glb_index(primitive, "indices")) {
      MARKETGEN_TRY(corners, glb_indices(glb_, *accessor, 3 * max_model_triangles, source_));
    } else {
      for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        corners.push_back(i);
    }
    MARKETGEN_TRY(mesh.triangles, triangles_of(corners, mode, mesh.positions.size(), source_));
    return {};
  }

  Result<void> read_uvs(const GlbJson& primitive, std::size_t set, Mesh& mesh) {
    MARKETGEN_TRY(const std::vector<float> values,
                  attribute(primitive, fmt::format("TEXCOORD_{}", set), 2));
    mesh.uvs.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.uvs.size() && 2 * i + 1 < values.size(); ++i)
      mesh.uvs[i] = {values[2 * i], values[2 * i + 1]};
    return {};
  }

  Result<void> read_normals(const GlbJson& primitive, const Affine& scene_from_mesh, Mesh& mesh) {
    MARKETGEN_TRY(const std::vector<float> values, attribute(primitive, "NORMAL", 3));
    if (values.size() != 3 * mesh.positions.size()) {
      make_normals(mesh);
      return {};
    }
    const double side = scene_from_mesh.determinant() < 0 ? -1 : 1;
    for (std::size_t i = 0; i < values.size(); i += 3)
      mesh.normals.push_back(to_float(
          normalized(scene_from_mesh.turn({values[i], values[i + 1], values[i + 2]}) * side)));
    return {};
  }

  const GlbChunks& glb_;
  const std::string& source_;
  OutsideModel model_;
  std::vector<std::size_t> texture_set_;  // of each material: which TEXCOORD its picture uses
  std::map<std::size_t, int> picture_of_image_;
  std::set<std::size_t> seen_;
  std::uint64_t pixels_ = 0;
};

}  // namespace

Result<OutsideModel> parse_glb(std::string_view bytes, const std::string& source) {
  MARKETGEN_TRY(const GlbChunks glb, read_glb_chunks(bytes, source));
  return GlbReader(glb, source).read();
}

}  // namespace marketgen::io
