#include <algorithm>
#include <array>
#include <cmath>

#include "perception/placed_surface.h"
#include "perception/pose_source.h"

namespace marketgen::perception {
namespace {

constexpr float min_facing = 0.25F;  // cosine; surface more aslant says little
constexpr float min_tolerance_m = 0.003F;
constexpr double violation_weight = 1.5;
constexpr double color_scale = 0.16;  // error at which the score is down to 1/e
constexpr double enough_seen = 0.35;  // share from which on more does not count
constexpr double enough_area_m2 = 1.2e-3;
constexpr float min_gain = 0.55F, max_gain = 1.7F;  // of light on a side against its picture
constexpr float of_clear = 0.15F;                   // weight of the colour of what one sees into
constexpr std::size_t sides = 6;

std::size_t side_of(Vec3f n) {
  const Vec3f size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  if (size.x >= size.y && size.x >= size.z) return n.x > 0 ? 0 : 1;
  if (size.y >= size.z) return n.y > 0 ? 2 : 3;
  return n.z > 0 ? 4 : 5;
}

// Sums over pairs of a picture's colour m and a seen colour o: the gain that suits best and what
// then remains.
class ColorPairs {
 public:
  void add(std::size_t side, Vec3f model, Vec3f seen, float weight) {
    Sum& s = sums_[side];
    s.mm += weight * dot(model, model);
    s.mo += weight * dot(model, seen);
    s.oo += weight * dot(seen, seen);
    s.count += 3 * weight;
  }
  double error() const {
    double squares = 0, count = 0;
    for (const Sum& s : sums_) {
      if (s.count == 0) continue;
      const double gain = std::clamp(s.mo / std::max(1e-6F, s.mm), min_gain, max_gain);
      squares += std::max(0.0, s.oo - 2 * gain * s.mo + gain * gain * s.mm);
      count += s.count;
    }
    return count > 0 ? std::sqrt(squares / count) : 1;
  }

 private:
  struct Sum {
    float mm = 0, mo = 0, oo = 0, count = 0;
  };
  std::array<Sum, sides> sums_{};
};

double covered_share(const ProductLook& look,
                     const Placed& placed,
                     const SurfacePatch& patch,
                     float covered_m) {
  if (patch.points.empty()) return 1;
  double covered = 0;
  for (const Vec3f& point : patch.points) {
    const Vec3f q = placed.back(point);
    const int nearest = look.nearest(q);
    if (nearest < 0) continue;
    const float off = length(look.surfels()[static_cast<std::size_t>(nearest)].point - q);
    covered += std::clamp(2.0 - static_cast<double>(off / covered_m), 0.0, 1.0);
  }
  return covered / static_cast<double>(patch.points.size());
}

struct Tally {
  double supported = 0, violated = 0, hidden = 0, area_m2 = 0;
  ColorPairs colors;
};

void look_at(const Surfel& surfel,
             const Placed& placed,
             const ViewCloud& cloud,
             double surfel_m2,
             Tally& tally) {
  const Vec3f point = placed(surfel.point), normal = placed.turned(surfel.normal);
  const auto shown = shown_piece(cloud, point, normal, min_facing, min_tolerance_m);
  if (!shown) return;
  if (shown->is_hidden()) {
    tally.hidden += 1;
  } else if (shown->is_missing()) {
    tally.violated += 1;
  } else {
    const double near = shown->agreement();
    tally.supported += near;
    (shown->off_m > 0 ? tally.hidden : tally.violated) += 1 - near;
    tally.area_m2 += near * surfel_m2;
    if (near > 0.5)
      tally.colors.add(side_of(surfel.normal),
                       surfel.color,
                       cloud.color(shown->pixel),
                       surfel.clear ? of_clear : 1.0F);
  }
}

}  // namespace

double PoseEvidence::likeness() const {
  return fit * covered * std::exp(-color_error / color_scale);
}

PoseEvidence evidence_of(const ProductLook& look,
                         const Pose& base_from_product,
                         const SurfacePatch& patch,
                         const std::vector<ViewCloud>& views,
                         std::size_t max_surfels,
                         float covered_m) {
  const Placed placed(base_from_product);
  const std::vector<Surfel>& surfels = look.surfels();
  const std::size_t step = std::max<std::size_t>(1, surfels.size() / max_surfels);
  constexpr double spacing_m = 0.0035;
  const double surfel_m2 = spacing_m * spacing_m * static_cast<double>(step);
  Tally tally;
  for (const ViewCloud& cloud : views)
    for (std::size_t i = 0; i < surfels.size(); i += step)
      look_at(surfels[i], placed, cloud, surfel_m2, tally);
  PoseEvidence e;
  const double shown = tally.supported + tally.violated;
  if (tally.supported < 4) return e;
  e.fit = tally.supported / (tally.supported + violation_weight * tally.violated);
  e.seen = shown / (shown + tally.hidden);
  e.covered = covered_share(look, placed, patch, covered_m);
  e.color_error = tally.colors.error();
  e.area_m2 = tally.area_m2;
  e.score = e.likeness() * std::sqrt(std::min(1.0, e.seen / enough_seen) *
                                     std::min(1.0, e.area_m2 / enough_area_m2));
  return e;
}

}  // namespace marketgen::perception
