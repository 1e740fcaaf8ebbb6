#include "assets/shapes/archetypes/leaf_head.h"

#include "assets/shapes/archetypes/body.h"
#include "assets/shapes/archetypes/foliage.h"

namespace marketgen::assets {
namespace {

constexpr BodyForm heart_body{.outline = {{{0, 0.02},
                                           {0.3, 0.0},
                                           {0.62, 0.08},
                                           {0.91, 0.27},
                                           {1, 0.52},
                                           {0.9, 0.78},
                                           {0.6, 0.95},
                                           {0.28, 1},
                                           {0, 0.995}}},
                              .lobes = 3,
                              .lobe_low = 0.01,
                              .lobe_high = 0.03,
                              .lumps = 0.05};

}  // namespace

void add_leaf_head(PackBuilder& pack,
                   std::uint16_t skin,
                   const LeafHead& form,
                   const PlantFrame& frame,
                   const Seed& seed) {
  const Vec3f half{0.5F * frame.across, 0.5F * frame.thick, 0.5F * frame.length};
  const GrownBody heart(heart_body, half * form.heart, seed.child("heart").stream());
  constexpr int segments = 36, bands = 18;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    return frame.place(heart.point(turn, along));
  });
  Stream draw = seed.child("leaves").stream();
  for (int i = 0; i < form.leaves; ++i) {
    const double rank = form.leaves > 1 ? static_cast<double>(i) / (form.leaves - 1) : 0;
    const auto in = static_cast<float>(rank);  // 0 outermost, 1 innermost
    constexpr double between_leaves = 0.382;   // leaves follow one another at the golden angle
    WrapLeaf leaf;
    leaf.half = half * (form.heart + (1 - in) * 0.05F);
    leaf.middle = {0, 0, half.z * form.heart};
    leaf.turn = i * between_leaves + draw.uniform(-0.03, 0.03);
    leaf.half_turn = form.half_turn * draw.uniform(0.9, 1.1);
    leaf.high = form.low_edge + (form.high_edge - form.low_edge) * rank;
    leaf.off = 0.012F + 0.012F * (1 - in);
    leaf.flare = form.flare_outer + (form.flare_inner - form.flare_outer) * in;
    leaf.ruffle = form.ruffle;
    leaf.ruffles = form.ruffles;
    add_wrap_leaf(pack, {skin}, leaf, form.segments, form.bands, frame.place);
  }
}

}  // namespace marketgen::assets
