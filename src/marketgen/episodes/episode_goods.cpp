#include "episodes/episode_goods.h"

#include <string>

#include <fmt/format.h>

#include "base/shared_objects.h"
#include "grasping/grasp_study.h"
#include "io/json.h"
#include "motion/grasp_surface.h"

namespace marketgen::episodes {
namespace {

constexpr int volume_points_a_side = 8;

std::vector<Vec3> points_within(const assets::ProductBody& body) {
  const motion::GraspSurface surface(body.pieces);
  const Vec3 low = to_double(surface.bounds().low), high = to_double(surface.bounds().high);
  const Vec3 step = (high - low) / volume_points_a_side;
  std::vector<Vec3> points;
  for (int i = 0; i < volume_points_a_side; ++i) {
    for (int j = 0; j < volume_points_a_side; ++j) {
      for (int k = 0; k < volume_points_a_side; ++k) {
        const Vec3 at = low + step * Vec3{i + 0.5, j + 0.5, k + 0.5};
        if (surface.gap_to_box({at, {}}, {1e-6, 1e-6, 1e-6}, 0) < 0) points.push_back(at);
      }
    }
  }
  if (points.empty()) points.push_back(to_double(body.center_of_mass));
  return points;
}

Result<SharedEpisodeGoods> made_goods(const catalog::Product& product, double pad_friction) {
  MARKETGEN_TRY(const physics::SharedGoodsBody made,
                physics::goods_body(product, physics::GoodsUse::bulk));
  return SharedEpisodeGoods(std::make_shared<EpisodeGoods>(
      EpisodeGoods{made, made->product, made->body, points_within(made->body), pad_friction}));
}

}  // namespace

Result<SharedEpisodeGoods> episode_goods(const catalog::Product& product,
                                         const std::vector<catalog::FrictionRow>& frictions) {
  static SharedObjects made;
  const double pad_friction = grasping::rubber_friction(frictions, product);
  return made.get<const EpisodeGoods>(
      fmt::format("{} {}", io::write_json_line(product), pad_friction),
      [&] { return made_goods(product, pad_friction); });
}

}  // namespace marketgen::episodes
