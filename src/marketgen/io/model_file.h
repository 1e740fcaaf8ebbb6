// Triangle models made by others: GLB (glTF 2.0, binary) and Wavefront OBJ files.
//
// Files are outside input: everything is bounded and checked before it is used, and a model never
// makes the reader open a file outside its own folder (a GLB: any other file).
//
// Neither tinygltf nor tinyobjloader reads them: the first crashes on deeply nested extras and
// hands lengths beyond the file on, the second takes "v 1 abc 0" for three numbers. See
// docs/architecture.md, "Why our own".
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "geometry/image.h"
#include "geometry/mesh.h"

namespace marketgen::io {

// Larger files, or models with more than this, are refused with input.too_large.
constexpr std::uint64_t max_model_bytes = 256U << 20;
constexpr std::size_t max_model_triangles = 1'000'000;

struct ModelMaterial {
  std::string name;
  Vec3f color{0.8F, 0.8F, 0.8F};  // linear; multiplies the picture where there is one
  float roughness = 0.9F, metallic = 0.0F;
  bool clear = false;  // drawn with transparency
  int picture = -1;    // base colour, row of OutsideModel::pictures
};

// Everything in the file's own frame and unit. A GLB has Y up, the front towards +Z, metres; an OBJ
// says neither.
struct OutsideModel {
  Mesh mesh;  // surfaces index `materials`; v of a UV grows downwards
  std::vector<ModelMaterial> materials;
  std::vector<Image> pictures;             // sRGB, 3 or 4 channels
  std::vector<std::string> names;          // of nodes, groups and meshes, once each
  std::vector<std::vector<Vec3f>> pieces;  // points of each mesh in the scene called "contact"
  std::vector<std::string> remarks;        // what was left out and why
};

// Gives the bytes of a file that a model names: its material library, a picture.
using CompanionReader = std::function<Result<std::string>(const std::string& name)>;

// Both parsers: `source` names the bytes in errors. Errors: model.bad_file, model.no_mesh,
// input.too_large, input.outside_folder, image.bad_file.
Result<OutsideModel> parse_glb(std::string_view bytes, const std::string& source);
Result<OutsideModel> parse_obj(std::string_view bytes,
                               const std::string& source,
                               const CompanionReader& companion);

// By its ending, .glb or .obj. Errors: as above; input.not_found, io.cannot_read.
Result<OutsideModel> read_model_file(const std::filesystem::path& file);

// `name` as a file in `folder` or below it, symbolic links followed. Error: input.outside_folder.
Result<std::filesystem::path> path_within(const std::filesystem::path& folder,
                                          const std::string& name,
                                          const std::string& where);

}  // namespace marketgen::io
