#include "assets/shapes/mesh_wedges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

#include "base/flat_index.h"
#include "geometry/weld.h"

namespace marketgen::assets {
namespace {

constexpr float apart_m = 4e-6F;  // more than that, less than anyone sees

using WedgeKey = std::array<std::uint32_t, 4>;
std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i)
    i = parents[i] = parents[parents[i]];
  return i;
}

void join(std::vector<std::uint32_t>& parents, std::uint32_t a, std::uint32_t b) {
  a = root_of(parents, a), b = root_of(parents, b);
  parents[std::max(a, b)] = std::min(a, b);
}

std::size_t next_corner(std::size_t i) {
  return i - i % 3 + (i + 1) % 3;
}

// For each corner of a triangle the first corner of its fan: of the triangles around a place that
// hang together over edges. Where two sheets touch, a place has two fans.
std::vector<std::uint32_t> fans_of(const MeshWedges& wedges, const WedgeIndices& indices) {
  std::vector<std::uint32_t> fans(indices.size());
  std::iota(fans.begin(), fans.end(), 0U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> open;  // edges
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    const auto after = static_cast<std::uint32_t>(next_corner(i));
    const std::uint32_t a = wedges.places[indices[i]], b = wedges.places[indices[after]];
    std::vector<std::uint32_t>& twins = open[{b, a}];
    if (twins.empty()) {
      open[{a, b}].push_back(i);
      continue;
    }
    join(fans, i, static_cast<std::uint32_t>(next_corner(twins.back())));
    join(fans, after, twins.back());
    twins.pop_back();
  }
  for (std::uint32_t i = 0; i < fans.size(); ++i)
    fans[i] = root_of(fans, i);
  return fans;
}

// By how much each fan gives way: the first at a place stays, the others step towards their own
// triangles.
std::vector<Vec3f> steps_apart(const MeshWedges& wedges,
                               const WedgeIndices& indices,
                               const std::vector<std::uint32_t>& fans) {
  std::vector<Vec3f> inward(indices.size());
  std::map<std::uint32_t, std::vector<std::uint32_t>> fans_at;  // of each place
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto at = [&](std::size_t k) { return wedges.positions[indices[i - i % 3 + k]]; };
    inward[fans[i]] += (at(0) + at(1) + at(2)) / 3.0F - wedges.positions[indices[i]];
    if (fans[i] == i) fans_at[wedges.places[indices[i]]].push_back(fans[i]);
  }
  std::vector<Vec3f> steps(indices.size());
  for (const auto& [place, all] : fans_at) {
    for (std::size_t k = 1; k < all.size(); ++k)
      steps[all[k]] = normalized(inward[all[k]]) * (apart_m * static_cast<float>(k));
  }
  return steps;
}

}  // namespace

MeshWedges wedges_of(const Mesh& mesh) {
  const std::vector<std::uint32_t> welded = weld_positions(mesh.positions, weld_distance_m);
  FlatIndex<WedgeKey> known(3 * mesh.triangles.size());
  MeshWedges wedges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      const Vec2f uv = mesh.uvs[vertex];
      const WedgeKey key{welded[vertex],
                         std::bit_cast<std::uint32_t>(uv.x),
                         std::bit_cast<std::uint32_t>(uv.y),
                         mesh.surfaces[t]};
      const auto next = static_cast<std::uint32_t>(wedges.positions.size());
      const auto [found, is_new] = known.try_emplace(key, next);
      if (is_new) {
        wedges.positions.push_back(mesh.positions[welded[vertex]]);
        wedges.uvs.push_back(uv);
        wedges.surfaces.push_back(mesh.surfaces[t]);
        wedges.places.push_back(welded[vertex]);
      }
      wedges.indices.push_back(found);
    }
  }
  return wedges;
}

Mesh mesh_of(const MeshWedges& wedges, const WedgeIndices& indices) {
  Mesh mesh;
  const std::vector<std::uint32_t> fans = fans_of(wedges, indices);
  const std::vector<Vec3f> steps = steps_apart(wedges, indices, fans);
  std::map<std::pair<unsigned int, std::uint32_t>, std::uint32_t> vertices;  // of wedge and fan
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned int wedge = indices[i + k];
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      const auto [found, is_new] = vertices.try_emplace({wedge, fans[i + k]}, next);
      if (is_new)
        mesh.add_vertex(wedges.positions[wedge] + steps[fans[i + k]], {}, wedges.uvs[wedge]);
      corners[k] = found->second;
    }
    mesh.add_triangle(corners[0], corners[1], corners[2], wedges.surfaces[indices[i]]);
  }
  return mesh;
}

WedgeIndices without_folds(const MeshWedges& wedges, const WedgeIndices& indices) {
  struct Pile {
    std::vector<std::size_t> one_way, other_way;  // first index of each triangle
  };
  std::map<std::array<std::uint32_t, 3>, Pile> piles;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<std::uint32_t, 3> key{
        wedges.places[indices[i]], wedges.places[indices[i + 1]], wedges.places[indices[i + 2]]};
    if (key[0] == key[1] || key[1] == key[2] || key[2] == key[0]) continue;
    std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
    const bool turned = key[1] > key[2];
    if (turned) std::swap(key[1], key[2]);
    Pile& pile = piles[key];
    (turned ? pile.other_way : pile.one_way).push_back(i);
  }
  std::vector<std::size_t> kept;
  for (const auto& [key, pile] : piles) {
    const auto folded =
        static_cast<std::ptrdiff_t>(std::min(pile.one_way.size(), pile.other_way.size()));
    kept.insert(kept.end(), pile.one_way.begin() + folded, pile.one_way.end());
    kept.insert(kept.end(), pile.other_way.begin() + folded, pile.other_way.end());
  }
  std::sort(kept.begin(), kept.end());
  WedgeIndices left;
  for (const std::size_t i : kept)
    left.insert(left.end(), {indices[i], indices[i + 1], indices[i + 2]});
  return left;
}

bool is_closed(const MeshWedges& wedges, const WedgeIndices& indices) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> turns;  // of each edge
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t a = wedges.places[indices[i]], b = wedges.places[indices[next_corner(i)]];
    turns[std::minmax(a, b)] += a < b ? 1 : -1;
  }
  return std::all_of(turns.begin(), turns.end(), [](const auto& edge) { return edge.second == 0; });
}

WedgeBodies::WedgeBodies(const MeshWedges& wedges) : wedges_(wedges) {
  std::size_t places = 0;
  for (const std::uint32_t place : wedges.places)
    places = std::max<std::size_t>(places, place + 1);
  std::vector<std::uint32_t> parents(places);
  std::iota(parents.begin(), parents.end(), 0U);
  const auto place = [&](std::size_t i) { return wedges.places[wedges.indices[i]]; };
  for (std::size_t i = 0; i < wedges.indices.size(); ++i)
    join(parents, place(i), place(next_corner(i)));
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> number(places, none);
  body_of_place_.assign(places, none);
  for (std::size_t i = 0; i < wedges.indices.size(); ++i) {
    std::size_t& own = number[root_of(parents, place(i))];
    if (own == none) own = count_++;
    body_of_place_[place(i)] = own;
  }
}

std::vector<WedgeIndices> WedgeBodies::split(const WedgeIndices& indices) const {
  std::vector<WedgeIndices> bodies(count_);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    WedgeIndices& body = bodies[body_of_place_[wedges_.places[indices[i]]]];
    body.insert(body.end(), {indices[i], indices[i + 1], indices[i + 2]});
  }
  return bodies;
}

double volume_of(const MeshWedges& wedges, const WedgeIndices& indices) {
  double volume = 0;
  const auto at = [&](std::size_t i) { return to_double(wedges.positions[indices[i]]); };
  for (std::size_t i = 0; i < indices.size(); i += 3)
    volume += dot(at(i), cross(at(i + 1), at(i + 2))) / 6;
  return volume;
}

Bounds3 bounds_of(const MeshWedges& wedges, const WedgeIndices& indices) {
  Bounds3 bounds;
  for (const unsigned int wedge : indices)
    bounds.include(wedges.positions[wedge]);
  return bounds;
}

}  // namespace marketgen::assets
