// Rolls and loaves that were cut before the oven: a dome on a flat foot, with crumb in its cuts.
#pragma once
#include <vector>

#include "assets/shapes/archetypes/body.h"
#include "catalog/product.h"

namespace marketgen::assets {

// A straight cut across the top, through a point, in half sizes of the loaf.
struct CrustCut {
  Vec2f through;
  Vec2f along;  // unit
  float half_width = 0.1F;
  float depth = 0.1F;   // of the loaf's height
  float reach = 0.75F;  // half its length
};

// The shape that bread_roll and round_bread have; their skin asks it where the crumb shows.
class CrustyLoaf {
 public:
  explicit CrustyLoaf(const catalog::Product& product);

  Vec3f point(double turn, double along) const;  // of a shell, metres
  float crumb(double turn, double along) const;  // 1 inside a cut, 0 on the crust

 private:
  Vec3f half_;
  std::vector<CrustCut> cuts_;
  GrownBody body_;
};

}  // namespace marketgen::assets
