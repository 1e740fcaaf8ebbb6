// What the readers of model files share: pictures, names and the checks at the end.
#pragma once
#include <string>
#include <string_view>

#include "io/model_file.h"

namespace marketgen::io {

Error bad_model(const std::string& source, const std::string& what);

// A name from the file, quoted for a message: short, and control characters escaped.
std::string quoted_name(const std::string& name);

// A PNG or JPEG picture, known by its first bytes. Errors: image.bad_file, input.too_large.
Result<Image> decode_picture(std::string_view bytes, const std::string& where);

// Keeps a name once, unless it is empty; long ones and all after the first few are dropped.
void keep_name(OutsideModel& model, std::string_view name);

// Gives a mesh that came without normals its own: with creases, or plainly smooth when it is large.
void make_normals(Mesh& mesh);

// The farthest that a vertex may lie, in the file's unit.
constexpr float farthest = 1e6F;
// Error model.bad_file when a point is no number or lies farther.
Result<void> check_points(const std::vector<Vec3f>& points, const std::string& source);

// The whole model as it may leave a reader, its points checked: triangles with an area (error
// model.no_mesh), unit normals, finite UVs.
Result<OutsideModel> finished_model(OutsideModel model, const std::string& source);

}  // namespace marketgen::io
