#include "assets/shapes/archetypes/crusty_loaf.h"

#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/growth.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

constexpr BodyForm loaf_body{.outline = {{{0, 0.01},
                                          {0.5, 0},
                                          {0.82, 0.01},
                                          {0.96, 0.1},
                                          {1, 0.28},
                                          {0.93, 0.54},
                                          {0.73, 0.80},
                                          {0.4, 0.95},
                                          {0, 1}}},
                             .lumps = 0.045};

std::vector<CrustCut> cuts_of(const catalog::Product& product) {
  if (has_word(product, "berliner|bun|milk|cinnamon|ciabatta|focaccia|pide|braided|raisin"))
    return {};
  if (product.archetype == "bread_roll") {
    return {
        {.through = {0, 0}, .along = {1, 0}, .half_width = 0.17F, .depth = 0.13F, .reach = 0.82F}};
  }
  std::vector<CrustCut> cuts;
  constexpr float off = 0.27F;  // of the middle: two pairs of cuts cross
  for (const float side : {-off, off}) {
    cuts.push_back({.through = {side, 0}, .along = {0, 1}, .half_width = 0.075F, .depth = 0.06F});
    cuts.push_back({.through = {0, side}, .along = {1, 0}, .half_width = 0.075F, .depth = 0.06F});
  }
  return cuts;
}

// Where a point lies in a cut: 1 on its line, 0 on its edge, less outside. Cuts narrow to their
// ends.
float in_cut(const CrustCut& cut, Vec2f at) {
  const Vec2f d = at - cut.through;
  const float along = (d.x * cut.along.x + d.y * cut.along.y) / cut.reach;
  const float width = cut.half_width * std::sqrt(std::max(0.0F, 1 - along * along));
  if (width <= 0) return -1;
  const float off = (d.x * cut.along.y - d.y * cut.along.x) / width;
  return 1 - off * off;
}

}  // namespace

CrustyLoaf::CrustyLoaf(const catalog::Product& product)
    : half_{static_cast<float>(product.width_m() / 2),
            static_cast<float>(product.depth_m() / 2),
            static_cast<float>(product.height_m() / 2)},
      cuts_(cuts_of(product)),
      body_(loaf_body, half_, growth_seed(product).child("body").stream()) {}

Vec3f CrustyLoaf::point(double turn, double along) const {
  Vec3f p = body_.point(turn, along);
  const float top = std::clamp(2 * (p.z / half_.z - 1), 0.0F, 1.0F);  // cuts end at the sides
  float depth = 0;
  for (const CrustCut& cut : cuts_) {
    const float inside = in_cut(cut, {p.x / half_.x, p.y / half_.y});
    if (inside > 0) depth = std::max(depth, cut.depth * std::min(1.0F, 2 * inside));
  }
  p.z -= depth * 2 * half_.z * top;
  return p;
}

float CrustyLoaf::crumb(double turn, double along) const {
  const Vec3f p = body_.point(turn, along);
  if (p.z < 1.1F * half_.z) return 0;
  float most = 0;
  for (const CrustCut& cut : cuts_)
    most = std::max(most, in_cut(cut, {p.x / half_.x, p.y / half_.y}));
  return std::clamp(3 * most, 0.0F, 1.0F);
}

namespace {

Result<ProductModel> loaf_model(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(0.65F);
  const CrustyLoaf loaf(product);
  constexpr int segments = 60, bands = 32;
  add_shell(pack, {skin}, {segments, even_stations(bands)}, [&](double turn, double along) {
    return loaf.point(turn, along);
  });
  return pack.finish(0.2F);
}

}  // namespace

Result<ProductModel> make_bread_roll(const catalog::Product& product) {
  return loaf_model(product);
}
CollisionPrimitive collision_bread_roll(const catalog::Product& product) {
  return box_around(product);
}

Result<ProductModel> make_round_bread(const catalog::Product& product) {
  return loaf_model(product);
}
CollisionPrimitive collision_round_bread(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
