#include <algorithm>
#include <cmath>

#include "geometry/mesh.h"

namespace marketgen {
inline namespace geometry {
namespace {

// One side of an axis-aligned box: its outward axis, and right and down as seen from outside.
// Indices 0..2 are X Y Z.
struct BoxFace {
  std::size_t axis;
  float side;  // -1 or +1 along `axis`
  Vec3f right, down;
};

constexpr std::array<BoxFace, 6> box_faces{{
    {1, -1.0F, {1, 0, 0}, {0, 0, -1}},
    {0, 1.0F, {0, 1, 0}, {0, 0, -1}},
    {1, 1.0F, {-1, 0, 0}, {0, 0, -1}},
    {0, -1.0F, {0, -1, 0}, {0, 0, -1}},
    {2, 1.0F, {1, 0, 0}, {0, -1, 0}},
    {2, -1.0F, {1, 0, 0}, {0, 1, 0}},
}};

using Signs = std::array<float, 3>;  // which corner of the box: -1 or +1 along each axis

float component(Vec3f v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

Vec3f outward(const BoxFace& face) {
  return cross(face.down, face.right);
}

class BoxBuilder {
 public:
  BoxBuilder(
      Mesh& mesh, Vec3f low, Vec3f high, float bevel, std::uint16_t surface, float uv_per_metre)
      : mesh_(mesh),
        center_((low + high) * 0.5F),
        half_((high - low) * 0.5F),
        bevel_(std::clamp(bevel, 0.0F, 0.99F * std::min({half_.x, half_.y, half_.z}))),
        surface_(surface),
        uv_per_metre_(uv_per_metre) {}

  void add_faces() {
    for (const BoxFace& face : box_faces) {
      const std::size_t r = axis_of(face.right), d = axis_of(face.down);
      Signs signs{};
      signs[face.axis] = face.side;
      std::array<std::uint32_t, 4> corners{};  // bottom left, bottom right, top right, top left
      for (std::size_t i = 0; i < 4; ++i) {
        signs[r] = component(face.right, r) * (i == 1 || i == 2 ? 1.0F : -1.0F);
        signs[d] = component(face.down, d) * (i < 2 ? 1.0F : -1.0F);
        corners[i] = vertex(face, signs, face);
      }
      add_polygon({corners[0], corners[1], corners[2], corners[3]});
    }
  }

  void add_bevels() {
    if (bevel_ <= 0) return;
    for (std::size_t a = 0; a < box_faces.size(); ++a) {
      for (std::size_t b = a + 1; b < box_faces.size(); ++b) {
        if (box_faces[a].axis != box_faces[b].axis) add_edge(box_faces[a], box_faces[b]);
      }
    }
    for (const float x : {-1.0F, 1.0F}) {
      for (const float y : {-1.0F, 1.0F}) {
        for (const float z : {-1.0F, 1.0F})
          add_corner({x, y, z});
      }
    }
  }

 private:
  static std::size_t axis_of(Vec3f unit) { return unit.x != 0 ? 0 : unit.y != 0 ? 1 : 2; }

  // The corner `signs` of `face`'s flat part, textured as part of `owner`'s picture.
  std::uint32_t vertex(const BoxFace& face, const Signs& signs, const BoxFace& owner) {
    std::array<float, 3> offset{};
    for (std::size_t k = 0; k < 3; ++k) {
      offset[k] = signs[k] * (component(half_, k) - (k == face.axis ? 0.0F : bevel_));
    }
    const Vec3f from_center{offset[0], offset[1], offset[2]};
    return mesh_.add_vertex(center_ + from_center, outward(face), uv_on(owner, from_center));
  }

  Vec2f uv_on(const BoxFace& face, Vec3f from_center) const {
    const float width = 2.0F * component(half_, axis_of(face.right));
    const float height = 2.0F * component(half_, axis_of(face.down));
    const float from_left = dot(from_center, face.right) + width / 2;
    const float from_top = dot(from_center, face.down) + height / 2;
    if (uv_per_metre_ > 0) return {from_left * uv_per_metre_, from_top * uv_per_metre_};
    return {from_left / width, from_top / height};
  }

  void add_edge(const BoxFace& a, const BoxFace& b) {
    const std::size_t along = 3 - a.axis - b.axis;
    Signs signs{};
    signs[a.axis] = a.side;
    signs[b.axis] = b.side;
    const auto at = [&](const BoxFace& face, float end) {
      signs[along] = end;
      return vertex(face, signs, a);
    };
    const std::uint32_t a_low = at(a, -1), a_high = at(a, 1), b_high = at(b, 1), b_low = at(b, -1);
    add_polygon({a_low, a_high, b_high, b_low});
  }

  void add_corner(const Signs& signs) {
    std::vector<const BoxFace*> meeting;
    for (const BoxFace& face : box_faces) {
      if (face.side == signs[face.axis]) meeting.push_back(&face);
    }
    std::vector<std::uint32_t> triangle;
    triangle.reserve(meeting.size());
    for (const BoxFace* face : meeting)
      triangle.push_back(vertex(*face, signs, *meeting[0]));
    add_polygon(std::move(triangle));
  }

  // A convex fan, turned so that it faces away from the centre.
  void add_polygon(std::vector<std::uint32_t> corners) {
    const Vec3f a = mesh_.positions[corners[0]];
    const Vec3f normal = cross(mesh_.positions[corners[1]] - a, mesh_.positions[corners[2]] - a);
    if (dot(normal, a - center_) < 0) std::reverse(corners.begin(), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i) {
      mesh_.add_triangle(corners[0], corners[i - 1], corners[i], surface_);
    }
  }

  Mesh& mesh_;
  Vec3f center_, half_;
  float bevel_;
  std::uint16_t surface_;
  float uv_per_metre_;
};

}  // namespace

void add_box(
    Mesh& mesh, Vec3f low, Vec3f high, float bevel, std::uint16_t surface, float uv_per_metre) {
  BoxBuilder builder(mesh, low, high, bevel, surface, uv_per_metre);
  builder.add_faces();
  builder.add_bevels();
}

void add_quad(Mesh& mesh, Vec3f a, Vec3f b, Vec3f c, Vec3f d, std::uint16_t surface) {
  const Vec3f normal = normalized(cross(c - a, d - b));
  const std::uint32_t first = mesh.add_vertex(a, normal, {0, 1});
  mesh.add_vertex(b, normal, {1, 1});
  mesh.add_vertex(c, normal, {1, 0});
  mesh.add_vertex(d, normal, {0, 0});
  mesh.add_triangle(first, first + 1, first + 2, surface);
  mesh.add_triangle(first, first + 2, first + 3, surface);
}

}  // namespace geometry
}  // namespace marketgen
