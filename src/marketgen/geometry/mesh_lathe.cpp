#include <algorithm>
#include <cmath>

#include "geometry/circle.h"
#include "geometry/mesh.h"

namespace marketgen {
inline namespace geometry {
namespace {

// A normal of the profile curve: outwards and up.
struct ProfileNormal {
  float out = 0, up = 0;
};

float span_of(float across, float along) {
  return std::sqrt(across * across + along * along);
}

float distance(const ProfilePoint& a, const ProfilePoint& b) {
  return span_of(b.radius - a.radius, b.z - a.z);
}

ProfileNormal normal_of_band(const ProfilePoint& low, const ProfilePoint& high) {
  const float span = distance(low, high);
  if (span <= 0) return {};
  return {(high.z - low.z) / span, (low.radius - high.radius) / span};
}

// Share of the profile's length that lies above each point.
std::vector<float> shares_from_top(const std::vector<ProfilePoint>& profile) {
  std::vector<float> shares(profile.size(), 0.0F);
  for (std::size_t i = profile.size() - 1; i > 0; --i) {
    shares[i - 1] = shares[i] + distance(profile[i - 1], profile[i]);
  }
  const float total = shares[0] > 0 ? shares[0] : 1.0F;
  for (float& share : shares)
    share /= total;
  return shares;
}

class Lathe {
 public:
  Lathe(Mesh& mesh, const std::vector<ProfilePoint>& profile, int segments)
      : mesh_(mesh), profile_(profile), segments_(segments), v_(shares_from_top(profile)) {}

  void add_bands() {
    std::uint32_t lower = 0;
    for (std::size_t i = 0; i + 1 < profile_.size(); ++i) {
      if (i == 0 || profile_[i].crease) lower = add_ring(i, normal_at(i, Side::above));
      const std::uint32_t upper = add_ring(i + 1, normal_at(i + 1, Side::below));
      add_band(i, lower, upper);
      lower = upper;
    }
  }

 private:
  enum class Side { below, above };

  bool on_axis(std::size_t i) const { return profile_[i].radius <= 0; }

  // Of point i as its band below or above sees it.
  ProfileNormal normal_at(std::size_t i, Side side) const {
    const bool first = i == 0, last = i + 1 == profile_.size();
    if (on_axis(i) && (first || last)) return {0, first ? -1.0F : 1.0F};
    const ProfileNormal below =
        first ? ProfileNormal{} : normal_of_band(profile_[i - 1], profile_[i]);
    const ProfileNormal above =
        last ? ProfileNormal{} : normal_of_band(profile_[i], profile_[i + 1]);
    if (profile_[i].crease) return side == Side::below ? below : above;
    const ProfileNormal sum{below.out + above.out, below.up + above.up};
    const float span = span_of(sum.out, sum.up);
    return span > 0 ? ProfileNormal{sum.out / span, sum.up / span} : below;
  }

  std::uint32_t add_ring(std::size_t i, ProfileNormal normal) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    const ProfilePoint& point = profile_[i];
    for (int k = 0; k <= segments_; ++k) {
      const double u = static_cast<double>(k) / segments_;
      // On the axis each triangle has its own vertex, in the middle of its slice of the picture.
      const double u_here = on_axis(i) ? (k + 0.5) / segments_ : u;
      const Vec2 outward = unit_circle(0.25 + (k == segments_ ? 0.0 : u));
      const auto x = static_cast<float>(outward.x), y = static_cast<float>(outward.y);
      mesh_.add_vertex({point.radius * x, point.radius * y, point.z},
                       normalized(Vec3f{normal.out * x, normal.out * y, normal.up}),
                       {static_cast<float>(std::min(u_here, 1.0)), v_[i]});
    }
    return first;
  }

  void add_band(std::size_t i, std::uint32_t lower, std::uint32_t upper) {
    const std::uint16_t s = profile_[i].surface;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(segments_); ++k) {
      if (on_axis(i) && on_axis(i + 1)) continue;
      if (on_axis(i)) {
        mesh_.add_triangle(lower + k, upper + k + 1, upper + k, s);
      } else if (on_axis(i + 1)) {
        mesh_.add_triangle(lower + k, lower + k + 1, upper + k, s);
      } else {
        mesh_.add_triangle(lower + k, lower + k + 1, upper + k + 1, s);
        mesh_.add_triangle(lower + k, upper + k + 1, upper + k, s);
      }
    }
  }

  Mesh& mesh_;
  const std::vector<ProfilePoint>& profile_;
  int segments_;
  std::vector<float> v_;
};

}  // namespace

void add_lathe(Mesh& mesh, const std::vector<ProfilePoint>& profile, int segments) {
  if (profile.size() < 2 || segments < 3) return;
  Lathe(mesh, profile, segments).add_bands();
}

}  // namespace geometry
}  // namespace marketgen
