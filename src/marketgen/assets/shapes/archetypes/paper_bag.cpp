#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float bag_edge_radius_m = 0.006F;
constexpr float bag_shoulder = 0.84F,
                bag_fold = 0.925F;           // shares of the height: walls end, folded top begins
constexpr float bag_fold_thickness = 0.16F;  // share of the depth: several turns of paper
constexpr float bag_softness = 0.05F;  // share of the depth by which corners lag behind the middle

// Block bottom and upright walls, closing to a flat top that is rolled over.
Vec3f paper_bag_point(Vec3f share, Vec3f size) {
  Vec3f p = rounded_box_point(share, size, bag_edge_radius_m);
  const float across = 2 * share.x - 1, up = 2 * std::min(share.z / bag_shoulder, 1.0F) - 1;
  p.y *= 1 - bag_softness * (1 - (1 - across * across) * (1 - up * up));
  const float closing =
      std::clamp((share.z - bag_shoulder) / (bag_fold - bag_shoulder), 0.0F, 1.0F);
  p.y *= 1 + (bag_fold_thickness - 1) * closing;
  return p;
}

}  // namespace

Result<ProductModel> make_paper_bag(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t side = pack.add_surface(paper(colors.primary));
  const Vec3f size{pack.width(), pack.depth(), pack.height()};

  const float edge = std::min(bag_edge_radius_m / size.z, 0.1F);
  std::vector<float> up{0, 0.41F * edge, edge};
  for (const float share : {0.25F,
                            0.5F,
                            bag_shoulder - 0.03F,
                            bag_shoulder,
                            0.5F * (bag_shoulder + bag_fold),
                            bag_fold}) {
    up.push_back(share);
  }
  up.push_back(1 - 0.4F * edge);
  up.push_back(1);
  const BoxGrid grid{rounded_lines(size.x, bag_edge_radius_m, 2, 6),
                     rounded_lines(size.y, bag_edge_radius_m, 2, 2),
                     up};
  add_panel_box(pack, grid, {print, side, print, side, side, side}, [&](Vec3f share) {
    return paper_bag_point(share, size);
  });
  pack.add_band_feature(FeatureKind::seam, bag_fold * size.z, size.z);
  return pack.finish(0.7F);
}

CollisionPrimitive collision_paper_bag(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
