#include "assets/people/implicit_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace marketgen::assets {
namespace {

// Corner k of a cell lies at (k & 1, k >> 1 & 1, k >> 2).
constexpr std::array<std::array<int, 2>, 12> cell_edges{{{0, 1},
                                                         {2, 3},
                                                         {4, 5},
                                                         {6, 7},
                                                         {0, 2},
                                                         {1, 3},
                                                         {4, 6},
                                                         {5, 7},
                                                         {0, 4},
                                                         {1, 5},
                                                         {2, 6},
                                                         {3, 7}}};
// Counter-clockwise seen from outside the cell.
constexpr std::array<std::array<int, 4>, 6> cell_faces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e) {
    const auto& edge = cell_edges[static_cast<std::size_t>(e)];
    if ((edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a)) return e;
  }
  return -1;
}

using Loops = std::vector<std::vector<int>>;  // edges, in the order of the surface's outline

// Where the surface leaves each edge of a cell whose corners `inside` (bits) lie within: one step
// along one face. On every face a line runs from where its border enters the inside to where it
// last left it, so that inner corners that lie across stay apart.
std::array<int, 12> steps_of(int inside) {
  std::array<int, 12> next;
  next.fill(-1);
  const auto in = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (const auto& face : cell_faces) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (in(face[i]) || !in(face[(i + 1) % 4])) continue;  // the border enters here
      std::size_t last = (i + 1) % 4;
      while (in(face[(last + 1) % 4]))
        last = (last + 1) % 4;
      next[static_cast<std::size_t>(edge_between(face[last], face[(last + 1) % 4]))] =
          edge_between(face[i], face[(i + 1) % 4]);
    }
  }
  return next;
}

std::array<Loops, 256> make_loops() {
  std::array<Loops, 256> table;
  for (int inside = 0; inside < 256; ++inside) {
    std::array<int, 12> next = steps_of(inside);
    for (std::size_t first = 0; first < 12; ++first) {
      std::vector<int> loop;
      for (int at = static_cast<int>(first); next[static_cast<std::size_t>(at)] >= 0;) {
        loop.push_back(at);
        at = std::exchange(next[static_cast<std::size_t>(at)], -1);
      }
      if (!loop.empty()) table[static_cast<std::size_t>(inside)].push_back(std::move(loop));
    }
  }
  return table;
}

const std::array<Loops, 256>& loops() {
  static const std::array<Loops, 256> table = make_loops();
  return table;
}

constexpr int block_cells = 6;
constexpr float min_share = 0.03F;  // of an edge before its vertex: no two vertices coincide

class Marcher {
 public:
  Marcher(const Field& field, const Bounds3& bounds, float cell_m)
      : field_(field), low_(bounds.low), cell_(cell_m) {
    const Vec3f size = bounds.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float length = axis == 0 ? size.x : axis == 1 ? size.y : size.z;
      blocks_[axis] = static_cast<int>(std::ceil(length / (cell_ * block_cells)));
    }
  }

  Mesh march() {
    for (int z = 0; z < blocks_[2]; ++z) {
      for (int y = 0; y < blocks_[1]; ++y) {
        for (int x = 0; x < blocks_[0]; ++x)
          march_block(x * block_cells, y * block_cells, z * block_cells);
      }
    }
    settle();
    return std::move(mesh_);
  }

 private:
  Vec3f point(int x, int y, int z) const {
    return low_ +
           Vec3f{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)} * cell_;
  }

  void march_block(int x0, int y0, int z0) {
    constexpr int half = block_cells / 2, side = block_cells + 1;
    const float reach = cell_ * block_cells * 0.87F * 2;
    if (std::abs(field_(point(x0 + half, y0 + half, z0 + half))) > reach) return;
    std::array<float, side * side * side> values;
    const auto value = [&](int x, int y, int z) -> float& {
      return values[static_cast<std::size_t>((z * side + y) * side + x)];
    };
    for (int z = 0; z < side; ++z) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x)
          value(x, y, z) = field_(point(x0 + x, y0 + y, z0 + z));
      }
    }
    for (int z = 0; z < block_cells; ++z) {
      for (int y = 0; y < block_cells; ++y) {
        for (int x = 0; x < block_cells; ++x) {
          std::array<float, 8> corners;
          for (int k = 0; k < 8; ++k)
            corners[static_cast<std::size_t>(k)] =
                value(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
          march_cell({x0 + x, y0 + y, z0 + z}, corners);
        }
      }
    }
  }

  void march_cell(const std::array<int, 3>& at, const std::array<float, 8>& corners) {
    int inside = 0;
    for (std::size_t k = 0; k < 8; ++k)
      inside |= corners[k] < 0 ? 1 << k : 0;
    for (const std::vector<int>& loop : loops()[static_cast<std::size_t>(inside)]) {
      std::vector<std::uint32_t> ring;
      for (const int edge : loop)
        ring.push_back(vertex_on(at, cell_edges[static_cast<std::size_t>(edge)], corners));
      fill(ring);
    }
  }

  // Longer rings are closed round their middle: a chord could be another cell's line, too.
  void fill(const std::vector<std::uint32_t>& ring) {
    if (ring.size() <= 4) {
      for (std::size_t i = 2; i < ring.size(); ++i)
        mesh_.add_triangle(ring[0], ring[i], ring[i - 1], 0);
      return;
    }
    Vec3f middle;
    for (const std::uint32_t v : ring)
      middle += mesh_.positions[v];
    const std::uint32_t hub =
        mesh_.add_vertex(middle / static_cast<float>(ring.size()), {0, 0, 1}, {});
    for (std::size_t i = 0; i < ring.size(); ++i)
      mesh_.add_triangle(hub, ring[(i + 1) % ring.size()], ring[i], 0);
  }

  std::uint32_t vertex_on(const std::array<int, 3>& at,
                          const std::array<int, 2>& edge,
                          const std::array<float, 8>& corners) {
    const auto corner = [&](int k) {
      return std::array<int, 3>{at[0] + (k & 1), at[1] + (k >> 1 & 1), at[2] + (k >> 2)};
    };
    const std::array<int, 3> from = corner(edge[0]), to = corner(edge[1]);
    const int axis = from[0] != to[0] ? 0 : from[1] != to[1] ? 1 : 2;
    const auto key = (static_cast<std::uint64_t>(from[0]) << 42) |
                     (static_cast<std::uint64_t>(from[1]) << 22) |
                     (static_cast<std::uint64_t>(from[2]) << 2) | static_cast<std::uint64_t>(axis);
    const auto [row, is_new] =
        vertices_.emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      const float a = corners[static_cast<std::size_t>(edge[0])];
      const float b = corners[static_cast<std::size_t>(edge[1])];
      const float share = std::clamp(a / (a - b), min_share, 1 - min_share);
      const Vec3f p = point(from[0], from[1], from[2]), q = point(to[0], to[1], to[2]);
      mesh_.add_vertex(p + (q - p) * share, {0, 0, 1}, {});
    }
    return row->second;
  }

  Vec3f gradient(Vec3f p) const {
    const float h = cell_ * 0.25F;
    return Vec3f{field_(p + Vec3f{h, 0, 0}) - field_(p - Vec3f{h, 0, 0}),
                 field_(p + Vec3f{0, h, 0}) - field_(p - Vec3f{0, h, 0}),
                 field_(p + Vec3f{0, 0, h}) - field_(p - Vec3f{0, 0, h})} /
           (2 * h);
  }

  // Moves every vertex onto the surface, at most half a cell, and turns its normal.
  void settle() {
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      Vec3f& p = mesh_.positions[i];
      Vec3f slope = gradient(p);
      const float steep = std::max(dot(slope, slope), 0.04F);
      Vec3f step = slope * (-field_(p) / steep);
      const float far = length(step);
      if (far > cell_ * 0.5F) step = step * (cell_ * 0.5F / far);
      p += step;
      const Vec3f normal = normalized(gradient(p));
      mesh_.normals[i] = dot(normal, normal) > 0.5F ? normal : Vec3f{0, 0, 1};
    }
  }

  const Field& field_;
  Vec3f low_;
  float cell_;
  std::array<int, 3> blocks_{};
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
  Mesh mesh_;
};

}  // namespace

Mesh mesh_of_field(const Field& field, const Bounds3& bounds, float cell_m) {
  return Marcher(field, bounds, cell_m).march();
}

}  // namespace marketgen::assets
