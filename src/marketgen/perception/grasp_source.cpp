#include "perception/grasp_source.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "perception/hidden_room.h"
#include "skills/counter_obstacles.h"
#include "skills/hand_room.h"

namespace marketgen::perception {
namespace {

constexpr float own_m = 0.007F;  // points so near to a product are its own
constexpr float min_x_m = 0.2F;  // before the arm's own body
// Of a grasp's score, for fingers that go where nothing is seen. Chosen by trial on drawn baskets.
constexpr double of_hidden_m = 300, max_hidden_m = 0.06;

double hidden_cost(double hidden_m) {
  return of_hidden_m * std::min(hidden_m, max_hidden_m);
}

}  // namespace

std::vector<Vec3f> thinned_points(const std::vector<ViewCloud>& views,
                                  double spacing_m,
                                  double max_z) {
  std::vector<Vec3f> kept;
  std::unordered_set<std::uint64_t> taken;
  const auto cell = [&](float v) {
    return static_cast<std::uint64_t>(std::lround(static_cast<double>(v) / spacing_m) + (1 << 20)) &
           0x1fffff;
  };
  for (const ViewCloud& cloud : views) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Vec3f p = cloud.point(i);
      if (p.x < min_x_m || static_cast<double>(p.z) > max_z || p.z < -0.05F) continue;
      if (!cloud.is_surface(i)) continue;
      if (taken.insert((cell(p.x) << 42) | (cell(p.y) << 21) | cell(p.z)).second) kept.push_back(p);
    }
  }
  return kept;
}

std::vector<Vec3f> other_points(const std::vector<Vec3f>& points,
                                const ProductLook& look,
                                const Pose& base_from_product) {
  const Pose product_from_base = inverse(base_from_product);
  std::vector<Vec3f> others;
  for (const Vec3f& point : points) {
    const Vec3f at = to_float(product_from_base * to_double(point));
    const int nearest = look.nearest(at);
    if (nearest >= 0) {
      const Surfel& surfel = look.surfels()[static_cast<std::size_t>(nearest)];
      const Vec3f off = at - surfel.point;
      if (length(off) < own_m || dot(off, surfel.normal) < 0) continue;
    }
    others.push_back(point);
  }
  return others;
}

skills::LyingPack lying_pack(const GraspQuestion& question, const agent::Workplace& place) {
  const agent::KnownProduct& known = question.known;
  skills::LyingPack pack{known.product, known.body, known.pad_friction, question.base_from_product};
  if (skills::is_over_basket(place, pack.middle()))
    pack.ground_m = question.base_from_basket.position.z;
  return pack;
}

SeenGrasp with_intrusion(SeenGrasp grasp,
                         const robots::GraspTool& tool,
                         const std::vector<Vec3f>& others) {
  grasp.intrusion_m =
      skills::hand_overlap(skills::open_hand(tool, grasp.opening_m), grasp.base_from_tip, others);
  return grasp;
}

Result<std::vector<SeenGrasp>> FittedGrasps::grasps(const GraspQuestion& question) const {
  agent::Workplace place = place_;
  place.base_from_basket = question.base_from_basket;
  const skills::LyingPack pack = lying_pack(question, place);
  MARKETGEN_TRY(const auto candidates,
                skills::grasps_from_above(pack, tool_, skills::wall_obstacles(place)));
  std::vector<SeenGrasp> grasps;
  for (const motion::GraspCandidate& candidate : candidates) {
    SeenGrasp grasp =
        with_intrusion({skills::lifting_grasp(pack, candidate)}, tool_, question.others);
    grasp.score -=
        skills::overlap_cost(grasp.intrusion_m) +
        hidden_cost(hidden_length_m(
            robots::opened(tool_, grasp.opening_m), grasp.base_from_tip, question.seen_in));
    grasps.push_back(grasp);
  }
  std::ranges::stable_sort(grasps, std::greater<>{}, &SeenGrasp::score);
  return grasps;
}

}  // namespace marketgen::perception
