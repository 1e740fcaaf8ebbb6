#include "export/usd_geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "base/hash.h"
#include "export/obj_text.h"
#include "geometry/weld.h"

namespace marketgen::exporters {
namespace {

constexpr std::size_t shape_hash_letters = 12;  // no two of a store's shapes share them
constexpr float min_area_m2 = 1e-12F;           // thinner triangles show nothing
constexpr float normal_steps = 1 << 14;         // normals nearer than a step are one

template <class T>
void add_to(Hasher& hash, const std::vector<T>& values) {
  hash.add(static_cast<std::int64_t>(values.size()));
  hash.add_bytes(std::as_bytes(std::span<const T>(values)));
}

std::string hash_of(const std::vector<UsdMesh>& meshes) {
  Hasher hash;
  for (const UsdMesh& mesh : meshes) {
    hash.add(static_cast<std::int64_t>(mesh.surface)).add(static_cast<std::int64_t>(mesh.sheet));
    add_to(hash, mesh.points);
    add_to(hash, mesh.normals);
    add_to(hash, mesh.st);
    add_to(hash, mesh.corners);
    add_to(hash, mesh.corner_normals);
    add_to(hash, mesh.corner_st);
  }
  return hash.hex().substr(0, shape_hash_letters);
}

// The values of one list, each once, by the order in which they came.
template <class Key, class Value>
class UsdList {
 public:
  std::int32_t row(const Key& key, const Value& value, std::vector<Value>& list) {
    const auto [entry, is_new] = known_.try_emplace(key, static_cast<std::int32_t>(list.size()));
    if (is_new) list.push_back(value);
    return entry->second;
  }

  bool has(const Key& key) const { return known_.contains(key); }

 private:
  std::map<Key, std::int32_t> known_;
};

// Builds the mesh of one surface.
class SurfaceMesh {
 public:
  SurfaceMesh(const Mesh& mesh,
              const std::vector<std::uint32_t>& welded,
              std::uint16_t surface,
              std::uint16_t sheet,
              bool textured)
      : mesh_(mesh), welded_(welded), textured_(textured) {
    made_.surface = surface;
    made_.sheet = sheet;
  }

  bool touches(const std::set<std::uint32_t>& corners) const {
    return std::ranges::any_of(corners, [&](std::uint32_t c) { return points_.has(c); });
  }

  void add(const std::array<std::uint32_t, 3>& triangle) {
    const Vec3f a = at(triangle[0]), b = at(triangle[1]), c = at(triangle[2]);
    const Vec3f across = cross(b - a, c - a);
    if (!(length(across) / 2 > min_area_m2)) return;
    for (const std::uint32_t v : triangle) {
      made_.corners.push_back(points_.row(welded_[v], at(v), made_.points));
      const Vec3f given = mesh_.normals[v];
      const Vec3f n = normalized(length(given) > 0 ? given : across);
      made_.corner_normals.push_back(
          normals_.row({step(n.x), step(n.y), step(n.z)}, n, made_.normals));
      if (!textured_) continue;
      const Vec2f uv{mesh_.uvs[v].x, 1 - mesh_.uvs[v].y};
      made_.corner_st.push_back(st_.row(
          {std::bit_cast<std::uint32_t>(uv.x), std::bit_cast<std::uint32_t>(uv.y)}, uv, made_.st));
    }
  }

  UsdMesh take() { return std::move(made_); }

 private:
  Vec3f at(std::uint32_t vertex) const { return mesh_.positions[welded_[vertex]]; }
  static int step(float part) { return static_cast<int>(std::lround(part * normal_steps)); }

  const Mesh& mesh_;
  const std::vector<std::uint32_t>& welded_;
  bool textured_;
  UsdMesh made_;
  UsdList<std::uint32_t, Vec3f> points_;
  UsdList<std::tuple<int, int, int>, Vec3f> normals_;
  UsdList<std::pair<std::uint32_t, std::uint32_t>, Vec2f> st_;
};

}  // namespace

std::vector<UsdMesh> usd_meshes(const Mesh& mesh,
                                const std::vector<bool>& textured,
                                const std::vector<std::uint32_t>& pieces) {
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_distance_m);
  std::map<std::pair<std::uint16_t, std::size_t>, std::vector<std::size_t>> triangles;  // by piece
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto after = std::ranges::upper_bound(pieces, mesh.triangles[t][0]);
    triangles[{mesh.surfaces[t], static_cast<std::size_t>(after - pieces.begin())}].push_back(t);
  }
  std::map<std::uint16_t, std::vector<SurfaceMesh>> sheets;  // by surface
  for (const auto& [place, rows] : triangles) {
    std::set<std::uint32_t> corners;
    for (const std::size_t t : rows) {
      for (const std::uint32_t v : mesh.triangles[t])
        corners.insert(welded[v]);
    }
    const std::uint16_t surface = place.first;
    std::vector<SurfaceMesh>& of = sheets[surface];
    auto sheet =
        std::ranges::find_if(of, [&](const SurfaceMesh& s) { return !s.touches(corners); });
    if (sheet == of.end()) {
      of.emplace_back(
          mesh, welded, surface, static_cast<std::uint16_t>(of.size()), textured[surface]);
      sheet = of.end() - 1;
    }
    for (const std::size_t t : rows)
      sheet->add(mesh.triangles[t]);
  }
  std::vector<UsdMesh> made;
  for (auto& [surface, of] : sheets) {
    for (SurfaceMesh& sheet : of) {
      UsdMesh one = sheet.take();
      if (!one.corners.empty()) made.push_back(std::move(one));
    }
  }
  return made;
}

UsdShape UsdGeometry::add(std::string_view kind, const std::vector<UsdMesh>& meshes) {
  const std::string name = fmt::format("{}_{}", kind, hash_of(meshes));
  const auto [entry, is_new] = known_.try_emplace(name);
  if (!is_new) return entry->second;
  const int prim = crate_.add_prim(0, name, "Xform");
  entry->second.reference = fmt::format("@./{}@</Geometry/{}>", usd_geometry_file, name);
  for (const UsdMesh& mesh : meshes) {
    const std::string part = mesh.sheet == 0 ? fmt::format("part_{}", mesh.surface)
                                             : fmt::format("part_{}_{}", mesh.surface, mesh.sheet);
    entry->second.parts.push_back({part, mesh.surface});
    add_mesh(crate_.add_prim(prim, part, "Mesh"), mesh);
  }
  meshes_ += meshes.size();
  return entry->second;
}

UsdShape UsdGeometry::add_hull(const std::vector<Vec3f>& points) {
  return add("hull", usd_meshes(hull_mesh(points), {false}));
}

void UsdGeometry::add_mesh(int prim, const UsdMesh& mesh) {
  Bounds3 bounds;
  for (const Vec3f& p : mesh.points)
    bounds.include(p);
  const auto add = [&](const io::UsdAttribute& attribute) {
    crate_.add_attribute(prim, attribute);
  };
  add({"extent", "float3[]", std::vector{bounds.low, bounds.high}, false, ""});
  add({"faceVertexCounts",
       "int[]",
       std::vector<std::int32_t>(mesh.corners.size() / 3, 3),
       false,
       ""});
  add({"faceVertexIndices", "int[]", mesh.corners, false, ""});
  add({"points", "point3f[]", mesh.points, false, ""});
  add({"primvars:normals", "normal3f[]", mesh.normals, false, "faceVarying"});
  add({"primvars:normals:indices", "int[]", mesh.corner_normals, false, ""});
  if (!mesh.st.empty()) {
    add({"primvars:st", "texCoord2f[]", mesh.st, false, "faceVarying"});
    add({"primvars:st:indices", "int[]", mesh.corner_st, false, ""});
  }
  add({"subdivisionScheme", "token", std::string("none"), true, ""});
}

}  // namespace marketgen::exporters
