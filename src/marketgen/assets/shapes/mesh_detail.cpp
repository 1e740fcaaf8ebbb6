#include "assets/shapes/mesh_detail.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "assets/shapes/mesh_wedges.h"

namespace marketgen::assets {
namespace {

constexpr float crease_cos =
    0.55F;                      // of the coarse mesh: the sides of a twelve-sided can are smooth
constexpr float any_error = 1;  // the limits decide, not meshoptimizer's error
// To bring a body's bounds back; more means that a part of it was lost.
constexpr float max_stretch = 0.04F, max_stretch_of_small = 0.4F;
constexpr float min_size_m = 1e-6F;
constexpr float more_triangles = 1.4F;  // on another try
constexpr std::size_t min_of_body = 8;  // triangles
constexpr double small_share = 0.12;    // of the pack's volume: a body with less is a small one
constexpr float speck_share = 0.04F;    // of the pack's size: smaller bodies may vanish

float greatest_size(const Bounds3& bounds) {
  const Vec3f size = bounds.size();
  return std::max({size.x, size.y, size.z});
}

std::size_t next_target(std::size_t triangles) {
  return static_cast<std::size_t>(static_cast<float>(triangles) * more_triangles) + 1;
}

// Vertices for meshoptimizer, each standing for one wedge or several.
struct Vertices {
  WedgeIndices wedges;  // of each vertex, one of those it stands for
  std::vector<Vec3f> positions;
  WedgeIndices triangles;  // of vertices
};

// A vertex for each wedge, or for all wedges of one surface at a place.
Vertices vertices_of(const MeshWedges& wedges, const WedgeIndices& fine, bool seams) {
  Vertices all;
  std::map<std::pair<std::uint32_t, std::uint32_t>, unsigned int> known;
  for (const unsigned int wedge : fine) {
    const auto key = seams ? std::pair<std::uint32_t, std::uint32_t>{wedge, 0}
                           : std::pair<std::uint32_t, std::uint32_t>{wedges.places[wedge],
                                                                     wedges.surfaces[wedge]};
    const auto next = static_cast<unsigned int>(all.wedges.size());
    const auto [found, is_new] = known.try_emplace(key, next);
    if (is_new) {
      all.wedges.push_back(wedge);
      all.positions.push_back(wedges.positions[wedge]);
    }
    all.triangles.push_back(found->second);
  }
  return all;
}

// About so many triangles instead of these, of vertices.
WedgeIndices fewer(const Vertices& vertices, std::size_t triangles) {
  WedgeIndices coarse(vertices.triangles.size());
  coarse.resize(meshopt_simplify(coarse.data(),
                                 vertices.triangles.data(),
                                 vertices.triangles.size(),
                                 &vertices.positions[0].x,
                                 vertices.positions.size(),
                                 sizeof(Vec3f),
                                 3 * triangles,
                                 any_error,
                                 0,
                                 nullptr));
  return coarse;
}

// With the seams of the print: its edges stay where they are.
WedgeIndices fewer_with_seams(const MeshWedges& wedges,
                              const WedgeIndices& fine,
                              std::size_t triangles) {
  const Vertices vertices = vertices_of(wedges, fine, true);
  WedgeIndices coarse = fewer(vertices, triangles);
  for (unsigned int& index : coarse)
    index = vertices.wedges[index];
  return without_folds(wedges, coarse);
}

// Without regard to seams, which would hold a small body's shape fast. Each triangle then takes
// those wedges at its corners that lie nearest to one another on the sheet.
WedgeIndices fewer_across_seams(const MeshWedges& wedges,
                                const WedgeIndices& fine,
                                std::size_t triangles) {
  std::map<std::pair<std::uint32_t, std::uint16_t>, std::vector<unsigned int>> at;
  for (const unsigned int wedge : fine) {
    std::vector<unsigned int>& here = at[{wedges.places[wedge], wedges.surfaces[wedge]}];
    if (std::find(here.begin(), here.end(), wedge) == here.end()) here.push_back(wedge);
  }
  const auto apart = [&](unsigned int a, unsigned int b) {
    const Vec2f d = wedges.uvs[a] - wedges.uvs[b];
    return d.x * d.x + d.y * d.y;
  };
  const Vertices vertices = vertices_of(wedges, fine, false);
  WedgeIndices coarse = fewer(vertices, triangles);
  for (std::size_t i = 0; i < coarse.size(); i += 3) {
    const auto candidates = [&](std::size_t k) -> const std::vector<unsigned int>& {
      const unsigned int wedge = vertices.wedges[coarse[i + k]];
      return at.at({wedges.places[wedge], wedges.surfaces[wedge]});
    };
    std::array<unsigned int, 3> best{};
    float least = 1e30F;
    for (const unsigned int a : candidates(0)) {
      for (const unsigned int b : candidates(1)) {
        for (const unsigned int c : candidates(2)) {
          const float spread = apart(a, b) + apart(b, c) + apart(c, a);
          if (spread < least) least = spread, best = {a, b, c};
        }
      }
    }
    std::copy(best.begin(), best.end(), coarse.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return without_folds(wedges, coarse);
}

// Stretches the mesh to these bounds; false when it would take more than that share.
bool fit_to(Mesh& mesh, const Bounds3& wanted, float share) {
  const Vec3f have = marketgen::bounds_of(mesh).size(), want = wanted.size();
  if (std::min({have.x, have.y, have.z}) < min_size_m) return false;
  const Vec3f scale{want.x / have.x, want.y / have.y, want.z / have.z};
  if (std::max({scale.x, scale.y, scale.z}) > 1 + share) return false;
  const Vec3f low = marketgen::bounds_of(mesh).low;
  for (Vec3f& p : mesh.positions)
    p = wanted.low + (p - low) * scale;
  return true;
}

// Makes the bodies of a pack coarse, each within the limits.
class Coarsener {
 public:
  Coarsener(const MeshWedges& wedges, const DetailLimits& limits)
      : wedges_(wedges),
        limits_(limits),
        pack_volume_(volume_of(wedges, wedges.indices)),
        pack_size_(greatest_size(bounds_of(wedges, wedges.indices))) {}

  // `rough`: what is left of the body of a first try that left so many triangles in all.
  Mesh body(const WedgeIndices& fine, const WedgeIndices& rough, std::size_t triangles) const {
    const Body body{bounds_of(wedges_, fine), volume_of(wedges_, fine)};
    if (rough.empty() && greatest_size(body.bounds) < speck_share * pack_size_) return {};
    const bool small = body.volume < small_share * pack_volume_;
    std::size_t target =
        small ? fine.size() * triangles / wedges_.indices.size() : rough.size() / 3;
    target = std::max(target, min_of_body);
    std::optional<Mesh> mesh;
    if (!small) mesh = within_limits(rough, body, small);
    for (; !mesh && target < fine.size() / 3; target = next_target(target)) {
      mesh = within_limits(small ? fewer_across_seams(wedges_, fine, target)
                                 : fewer_with_seams(wedges_, fine, target),
                           body,
                           small);
    }
    return mesh ? *std::move(mesh) : mesh_of(wedges_, fine);
  }

 private:
  struct Body {
    Bounds3 bounds;
    double volume;
  };

  // Stretched to the body's bounds, unless it lost too much.
  std::optional<Mesh> within_limits(const WedgeIndices& coarse,
                                    const Body& body,
                                    bool small) const {
    if (coarse.empty() || !is_closed(wedges_, coarse)) return std::nullopt;
    Mesh mesh = mesh_of(wedges_, coarse);
    if (!fit_to(mesh, body.bounds, small ? max_stretch_of_small : max_stretch)) return std::nullopt;
    const double may_lose = (small ? limits_.small_loss : limits_.loss) * std::abs(body.volume);
    if (std::abs(marketgen::volume_of(mesh) - body.volume) > may_lose || !is_watertight(mesh))
      return std::nullopt;
    return mesh;
  }

  const MeshWedges& wedges_;
  const DetailLimits& limits_;
  double pack_volume_;
  float pack_size_;
};

bool same_surfaces(const Mesh& a, const Mesh& b) {
  const auto count = [](const Mesh& mesh) {
    std::vector<std::uint16_t> used = mesh.surfaces;
    std::sort(used.begin(), used.end());
    return std::unique(used.begin(), used.end()) - used.begin();
  };
  return count(a) == count(b);
}

}  // namespace

Mesh simplified(const Mesh& mesh, const DetailLimits& limits) {
  const MeshWedges wedges = wedges_of(mesh);
  const WedgeBodies bodies(wedges);
  const std::vector<WedgeIndices> fine = bodies.split(wedges.indices);
  const Coarsener coarsener(wedges, limits);
  for (std::size_t target = limits.triangles; target < mesh.triangles.size();
       target = next_target(target)) {
    const std::vector<WedgeIndices> rough =
        bodies.split(fewer_with_seams(wedges, wedges.indices, target));
    Mesh result;
    for (std::size_t i = 0; i < fine.size(); ++i)
      result.append(coarsener.body(fine[i], rough[i], target));
    if (result.triangles.size() >= mesh.triangles.size()) break;
    if (!same_surfaces(result, mesh) || !is_watertight(result)) continue;
    recompute_normals(result, crease_cos);
    for (Vec3f& normal : result.normals) {  // of slivers whose area is nothing
      if (length(normal) < 0.5F) normal = {0, 0, 1};
    }
    return result;
  }
  return mesh;
}

}  // namespace marketgen::assets
