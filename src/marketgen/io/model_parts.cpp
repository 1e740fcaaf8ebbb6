#include "io/model_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "io/jpeg.h"
#include "io/png.h"

namespace marketgen::io {
namespace {

constexpr std::size_t max_names = 64, longest_name = 80;
// Creases cost the square of the triangles round a point, and a hostile file puts all into one.
constexpr std::size_t max_creased_triangles = 20'000;

void make_smooth_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3f{});
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3f p = mesh.positions[a];
    const Vec3f n = cross(mesh.positions[b] - p, mesh.positions[c] - p);
    for (const std::uint32_t vertex : {a, b, c})
      mesh.normals[vertex] += n;
  }
}

// A triangle without an area has no side to see or to touch.
void drop_flat_triangles(Mesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const Vec3 p = to_double(mesh.positions[a]);
    const Vec3 n = cross(to_double(mesh.positions[b]) - p, to_double(mesh.positions[c]) - p);
    if (!(dot(n, n) > 0)) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.surfaces[kept++] = mesh.surfaces[t];
  }
  mesh.triangles.resize(kept);
  mesh.surfaces.resize(kept);
}

}  // namespace

Error bad_model(const std::string& source, const std::string& what) {
  return {"model.bad_file", source, what};
}

std::string quoted_name(const std::string& name) {
  using Json = nlohmann::json;
  constexpr std::size_t longest = 60;
  const std::string text = Json(name).dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= longest ? text : text.substr(0, longest) + "...\"";
}

Result<Image> decode_picture(std::string_view bytes, const std::string& where) {
  if (is_png(bytes)) return decode_png(bytes, where);
  if (bytes.starts_with("\xFF\xD8\xFF")) return decode_jpeg(bytes, where);
  return Error{"image.bad_file", where, "is neither a PNG nor a JPEG picture"};
}

void keep_name(OutsideModel& model, std::string_view name) {
  const std::string text(name.substr(0, longest_name));
  if (text.empty() || model.names.size() >= max_names || !is_utf8(text)) return;
  if (std::find(model.names.begin(), model.names.end(), text) == model.names.end())
    model.names.push_back(text);
}

Result<void> check_points(const std::vector<Vec3f>& points, const std::string& source) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3f p = points[i];
    if (std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest)
      continue;
    return bad_model(source,
                     fmt::format("vertex {} lies at ({}, {}, {}); each must be a number between "
                                 "-1,000,000 and 1,000,000: export the model again",
                                 i,
                                 p.x,
                                 p.y,
                                 p.z));
  }
  return {};
}

void make_normals(Mesh& mesh) {
  make_smooth_normals(mesh);
  if (mesh.triangles.size() <= max_creased_triangles) recompute_normals(mesh);
}

Result<OutsideModel> finished_model(OutsideModel model, const std::string& source) {
  Mesh& mesh = model.mesh;
  drop_flat_triangles(mesh);
  if (mesh.triangles.empty())
    return Error{"model.no_mesh", source, "has no triangles; export the shape as a triangle mesh"};
  for (Vec3f& n : mesh.normals)
    n = std::isfinite(dot(n, n)) && dot(n, n) > 0 ? normalized(n) : Vec3f{0, 0, 1};
  for (Vec2f& uv : mesh.uvs) {
    if (!(std::abs(uv.x) <= farthest && std::abs(uv.y) <= farthest)) uv = {};
  }
  return model;
}

}  // namespace marketgen::io
