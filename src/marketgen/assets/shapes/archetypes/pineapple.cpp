#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/foliage.h"
#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr BodyForm pineapple_body{.outline = {{{0, 0},
                                               {0.35, 0.01},
                                               {0.72, 0.06},
                                               {0.95, 0.2},
                                               {1, 0.42},
                                               {0.97, 0.66},
                                               {0.84, 0.87},
                                               {0.6, 0.97},
                                               {0.3, 1},
                                               {0, 1}}},
                                  .lumps = 0.02};
constexpr float body_share = 0.55F;  // of the height; the crown has the rest
constexpr int eye_columns = 8, eye_rows = 11;
constexpr float eye_relief = 0.09F;  // of the radius

// The fruitlets bulge on two crossing spirals: 1 in the middle of one, 0 in the grooves.
float eye_bulge(double turn, double along) {
  const double a = eye_columns * turn + 0.5 * eye_rows * along;
  const double b = eye_columns * turn - 0.5 * eye_rows * along;
  const auto wave = [](double x) { return 0.5 + 0.5 * unit_circle(x).x; };
  return static_cast<float>(wave(a) * wave(b));
}

void add_crown(PackBuilder& pack, const PlantFrame& frame, float foot, Stream draw) {
  const std::uint16_t leaf_surface = pack.add_surface(plant({0.11F, 0.22F, 0.09F}));
  constexpr int whorls = 4;
  constexpr std::array<int, whorls> leaves{8, 7, 5, 2};
  constexpr std::array<float, whorls> reach{0.98F, 0.84F, 0.55F, 0.18F};  // outwards, of the radius
  constexpr std::array<float, whorls> rise{0.30F, 0.62F, 0.9F, 1.0F};     // of the crown's height
  const float radius = 0.5F * std::min(frame.across, frame.thick);
  const float height = frame.length - foot;
  for (std::size_t w = 0; w < whorls; ++w) {
    for (int i = 0; i < leaves[w]; ++i) {
      const Vec2 out =
          unit_circle((i + draw.uniform(-0.2, 0.2)) / leaves[w] + 0.37 * static_cast<double>(w));
      const Vec3f outward{static_cast<float>(out.x), static_cast<float>(out.y), 0};
      const float own = static_cast<float>(draw.uniform(0.85, 1.0));
      LeafForm leaf;
      leaf.foot = outward * (0.16F * radius) + Vec3f{0, 0, foot - 0.03F * height};
      leaf.tip = outward * (reach[w] * radius) + Vec3f{0, 0, foot + rise[w] * own * height};
      leaf.up = -outward;
      leaf.half_width = 0.2F * radius;
      leaf.arch = -0.14F;
      leaf.curl = 0.22F;
      leaf.segments = 6;
      leaf.fold = 0.35F;
      leaf.stalk = 0.9F;
      leaf.bands = 4;
      add_leaf(pack, {leaf_surface}, leaf, frame.place);
    }
  }
}

}  // namespace

Result<ProductModel> make_pineapple(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const Seed seed = growth_seed(product);
  const PlantFrame frame = plant_frame(pack, lies_along_x(product));
  const std::uint16_t skin = pack.add_print(0.7F);
  const float height = body_share * frame.length;
  const Vec3f half{0.48F * frame.across, 0.48F * frame.thick, 0.5F * height};
  const GrownBody body(pineapple_body, half, seed.child("body").stream());
  constexpr int segments = 48, bands = 26;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    const Vec3f p = body.point(turn, along);
    const bool pole = along <= 0 || along >= 1;
    const float bulge = pole ? 1.0F : 1 + eye_relief * (eye_bulge(turn, along) - 0.4F);
    return frame.place({p.x * bulge, p.y * bulge, p.z});
  });
  const std::size_t mark = pack.triangle_count();
  add_crown(pack, frame, height, seed.child("crown").stream());
  pack.add_part_feature(FeatureKind::stem, mark);
  return pack.finish(0.2F);
}

CollisionPrimitive collision_pineapple(const catalog::Product& product) {
  return product.size_mm[0] > product.size_mm[2] ? lying_cylinder_around(product)
                                                 : cylinder_around(product);
}

}  // namespace marketgen::assets
