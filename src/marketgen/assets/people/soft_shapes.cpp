#include "assets/people/soft_shapes.h"

namespace marketgen::assets {
namespace {

constexpr float squareness = 0.35F;  // between an ellipse and a superellipse of power 4

float blend(float a, float b, float c, float d, float t) {  // Catmull-Rom from b to c
  return b + 0.5F * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Girth girth_at(const std::vector<Girth>& girths, float z) {
  if (z <= girths.front().z) return girths.front();
  if (z >= girths.back().z) return girths.back();
  std::size_t i = 0;
  while (z > girths[i + 1].z)
    ++i;
  const Girth& b = girths[i];
  const Girth& c = girths[i + 1];
  const Girth& a = girths[i > 0 ? i - 1 : 0];
  const Girth& d = girths[std::min(i + 2, girths.size() - 1)];
  const float t = (z - b.z) / (c.z - b.z);
  return {z,
          blend(a.x, b.x, c.x, d.x, t),
          blend(a.half_x, b.half_x, c.half_x, d.half_x, t),
          blend(a.half_y, b.half_y, c.half_y, d.half_y, t)};
}

}  // namespace

float round_cone(Vec3f p, Vec3f a, Vec3f b, float radius_a, float radius_b) {
  const Vec3f ba = b - a;
  const float l2 = dot(ba, ba), rr = radius_a - radius_b;
  if (l2 <= rr * rr) return length(p - a) - std::max(radius_a, radius_b);
  const float a2 = l2 - rr * rr, il2 = 1 / l2;
  const Vec3f pa = p - a;
  const float y = dot(pa, ba), z = y - l2;
  const Vec3f across = pa * l2 - ba * y;
  const float x2 = dot(across, across), y2 = y * y * l2, z2 = z * z * l2;
  const float k = (rr > 0 ? rr * rr : -rr * rr) * x2;
  const auto sign = [](float v) { return v < 0 ? -1.0F : 1.0F; };
  if (sign(z) * a2 * z2 > k) return std::sqrt(x2 + z2) * il2 - radius_b;
  if (sign(y) * a2 * y2 < k) return std::sqrt(x2 + y2) * il2 - radius_a;
  return (std::sqrt(x2 * a2 * il2) + y * rr) * il2 - radius_a;
}

float ellipsoid(Vec3f p, Vec3f middle, Vec3f half) {
  const Vec3f q = p - middle;
  const Vec3f u{q.x / half.x, q.y / half.y, q.z / half.z};
  const Vec3f w{u.x / half.x, u.y / half.y, u.z / half.z};
  const float k0 = length(u), k1 = length(w);
  if (k1 < 1e-6F) return -std::min({half.x, half.y, half.z});
  return k0 * (k0 - 1) / k1;
}

float round_box(Vec3f p, Vec3f middle, Vec3f half, float edge, float yaw_rad) {
  const Vec3f d = p - middle;
  const float c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  const Vec3f q{std::abs(c * d.x + s * d.y) - half.x + edge,
                std::abs(c * d.y - s * d.x) - half.y + edge,
                std::abs(d.z) - half.z + edge};
  const Vec3f out{std::max(q.x, 0.0F), std::max(q.y, 0.0F), std::max(q.z, 0.0F)};
  return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0F) - edge;
}

float ring(Vec3f p, Vec3f middle, float radius, float bar) {
  const Vec3f d = p - middle;
  const float out = std::sqrt(d.x * d.x + d.y * d.y) - radius;
  return std::sqrt(out * out + d.z * d.z) - bar;
}

float trunk(Vec3f p, const std::vector<Girth>& girths, float end_radius) {
  const Girth g = girth_at(girths, p.z);
  const float u = std::abs(p.x - g.x) / g.half_x, v = std::abs(p.y) / g.half_y;
  const float u2 = u * u, v2 = v * v;
  const float around =
      (1 - squareness) * std::sqrt(u2 + v2) + squareness * std::sqrt(std::sqrt(u2 * u2 + v2 * v2));
  const float side = (around - 1) * std::min(g.half_x, g.half_y);
  const float end = std::max(girths.front().z - p.z, p.z - girths.back().z);
  return soft_max(side, end, 2 * end_radius);
}

}  // namespace marketgen::assets
