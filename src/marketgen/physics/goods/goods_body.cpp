#include "physics/goods/goods_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "assets/contact_shape.h"
#include "assets/shapes/contact_pieces.h"
#include "base/shared_objects.h"
#include "io/json.h"
#include "scene/shelf_fill.h"

namespace marketgen::physics {
namespace {

// Round packs that lie come to rest in a basket by this (the probe of Checkout Unloading).
constexpr double min_bulk_rolling_m = 0.0015;

// A lean of 7 degrees, or nothing, tips it off the foot that its pieces have.
constexpr double steady_tangent = 0.12;

bool steady(const assets::ProductBody& body) {
  const assets::ContactPiece& foot = body.pieces[0];
  const Vec3f &middle = body.center_of_mass, &half = foot.half_size;
  const double x = half.x - std::abs(middle.x - foot.center.x);
  const double y = half.y - std::abs(middle.y - foot.center.y);
  return std::min(x, y) > steady_tangent * middle.z;
}

GoodsForm form_of(const catalog::Product& product, const assets::ProductBody& pack, GoodsUse use) {
  if (use != GoodsUse::stocked) return GoodsForm::pieces;
  if (scene::lies_as_balls(product)) return GoodsForm::ball;
  if (product.category == "produce") return GoodsForm::produce;
  if (product.stack_max > 1) return GoodsForm::stacked;
  if (static_cast<int>(pack.pieces.size()) > assets::PieceLimits{}.max_pieces)
    return GoodsForm::many_pieces;
  return steady(pack) ? GoodsForm::pieces : GoodsForm::unsteady;
}

// Of an ellipsoid: a fifth of the mass times the squares of the two half axes across.
void spread_evenly(double mass_kg, assets::ProductBody& body) {
  const Vec3f& h = body.pieces[0].half_size;
  const auto fifth = static_cast<float>(mass_kg / 5);
  body.center_of_mass = body.pieces[0].center;
  body.inertia_kg_m2 = {fifth * (h.y * h.y + h.z * h.z),
                        fifth * (h.x * h.x + h.z * h.z),
                        fifth * (h.x * h.x + h.y * h.y),
                        0,
                        0,
                        0};
}

GoodsContact contact_of(const catalog::Product& product,
                        const assets::CollisionPrimitive& solid,
                        GoodsUse use) {
  GoodsContact contact = goods_contact_of(product, solid);
  if (use != GoodsUse::bulk) return contact;
  contact.dimensions = 6;
  contact.rolling_m = std::max(contact.rolling_m, min_bulk_rolling_m);
  return contact;
}

SharedGoodsBody made_body(const catalog::Product& product,
                          const assets::ProductBody& pack,
                          const assets::CollisionPrimitive& solid,
                          GoodsUse use) {
  auto goods = std::make_shared<GoodsBody>(GoodsBody{product, form_of(product, pack, use), pack});
  if (goods->form != GoodsForm::pieces) goods->body.pieces = {assets::piece_of(solid)};
  if (goods->form == GoodsForm::ball) spread_evenly(product.mass_kg, goods->body);
  goods->contact = contact_of(product, solid, use);
  return goods;
}

using BodiesByUse = std::map<GoodsUse, SharedGoodsBody>;

Result<std::shared_ptr<const BodiesByUse>> made_bodies(const catalog::Product& product) {
  MARKETGEN_TRY(const assets::CollisionPrimitive solid, assets::collision_of(product));
  MARKETGEN_TRY(const auto pack, assets::product_body(product));
  MARKETGEN_CHECK(check_has_body(product, *pack));
  BodiesByUse bodies;
  for (const GoodsUse use : {GoodsUse::stocked, GoodsUse::single, GoodsUse::bulk})
    bodies.emplace(use, made_body(product, *pack, solid, use));
  return std::make_shared<const BodiesByUse>(std::move(bodies));
}

}  // namespace

Result<SharedGoodsBody> goods_body(const catalog::Product& product, GoodsUse use) {
  static SharedObjects made;
  MARKETGEN_TRY(const auto bodies, made.get<const BodiesByUse>(io::write_json_line(product), [&] {
    return made_bodies(product);
  }));
  return bodies->at(use);
}

Result<void> check_has_body(const catalog::Product& product, const assets::ProductBody& body) {
  const auto& [width, depth, height] = product.size_mm;
  const bool sized = width > 0 && depth > 0 && height > 0;
  if (product.mass_kg > 0 && std::isfinite(product.mass_kg) && sized && !body.pieces.empty())
    return {};
  return Error{"catalog.bad_row",
               product.sku,
               fmt::format("a product to be held needs a mass and a size greater than 0; it has {} "
                           "kg and {} x {} x {} mm",
                           product.mass_kg,
                           width,
                           depth,
                           height)};
}

}  // namespace marketgen::physics
