#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int folds = 7;             // turns of the rolled dough, the middle one the thickest
constexpr double horn_turn = 0.105;  // each horn bends back by so many turns of a circle
constexpr float step = 0.13F;        // of the radius, by which a fold stands over the next

// Share of the greatest radius at `along` 0..1: it swells to the middle in steps, whose edges face
// the horns.
float rolled_radius(float along) {
  const float from_middle = std::abs(2 * along - 1);
  const float envelope = 1 - 0.80F * from_middle * from_middle;
  const float place = from_middle * (0.5F * folds);
  const float in_fold =
      place - std::floor(place + 0.5F) + 0.5F;  // 0 towards the middle, 1 outwards
  const bool middle = place < 0.5F;
  const float round = middle ? 1 - 4 * (in_fold - 0.5F) * (in_fold - 0.5F)
                             : std::sqrt(std::max(0.0F, 1 - in_fold * in_fold));
  return envelope * (1 - step + step * (middle ? std::sqrt(round) : round));
}

// Closer together where one fold ends and the next begins.
std::vector<double> fold_stations() {
  constexpr int bands_of_fold = 8;
  std::vector<double> stations{0, 0.012};
  for (int i = 1; i < folds * bands_of_fold; ++i)
    stations.push_back(static_cast<double>(i) / (folds * bands_of_fold));
  stations.push_back(0.988);
  stations.push_back(1);
  return stations;
}

}  // namespace

Result<ProductModel> make_croissant(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  Stream draw = growth_seed(product).stream();
  const std::uint16_t skin = pack.add_print(0.45F);
  const float radius = 0.5F * pack.height();
  const double left = horn_turn * draw.uniform(0.85, 1.15),
               right = horn_turn * draw.uniform(0.85, 1.15);
  const float arc = 0.5F * pack.width();
  // The roll's line: an arc whose horns come forward, to the left and to the right.
  const auto line = [&](double along) {
    const double s = 2 * along - 1;
    const Vec2 c = unit_circle((s < 0 ? left : right) * s * 2);
    return std::pair(Vec2f{arc * 1.05F * static_cast<float>(c.y), arc * static_cast<float>(c.x)},
                     Vec2f{static_cast<float>(c.x), -static_cast<float>(c.y)});
  };
  constexpr int segments = 24;
  add_shell(pack, {skin}, {segments, fold_stations()}, [&](double turn, double along) {
    const auto [at, direction] = line(1 - along);  // from the right horn to the left
    const bool end = along <= 0 || along >= 1;
    const float r = end ? 0 : radius * rolled_radius(static_cast<float>(along));
    const Vec2 c = unit_circle(turn + 0.75);  // u = 0.5 is up
    const auto side = static_cast<float>(c.x), up = static_cast<float>(c.y);
    const Vec2f across{direction.y, -direction.x};
    const float lying = std::max(-0.72F, up);  // rests on its flat foot
    return Vec3f{at.x + across.x * side * r * 1.15F, at.y + across.y * side * r * 1.15F, lying * r};
  });
  return pack.finish(0.35F);
}

CollisionPrimitive collision_croissant(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
