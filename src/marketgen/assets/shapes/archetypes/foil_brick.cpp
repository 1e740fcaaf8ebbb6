#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "base/seed.h"

namespace marketgen::assets {
namespace {

constexpr float brick_edge_m = 0.0035F;
constexpr float dent_m = 0.0006F;  // foil drawn onto grounds or wrapped by hand is not quite flat
constexpr int dents_along = 6;

// Smooth bumps of the faces, the same for every pack of a row.
class Dents {
 public:
  explicit Dents(const catalog::Product& product) {
    Stream draw = Seed(0).child("foil_brick", product.sku).stream();
    for (auto& plane : height_) {
      for (auto& line : plane) {
        for (float& value : line)
          value = static_cast<float>(draw.uniform(-1, 1));
      }
    }
  }

  float at(Vec3f share) const {
    const auto cell = [](float s, std::size_t& i) {
      const float place = std::clamp(s, 0.0F, 1.0F) * (dents_along - 1.001F);
      i = static_cast<std::size_t>(place);
      const float t = place - static_cast<float>(i);
      return t * t * (3 - 2 * t);
    };
    std::size_t x = 0, y = 0, z = 0;
    const float tx = cell(share.x, x), ty = cell(share.y, y), tz = cell(share.z, z);
    float sum = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const std::size_t dx = corner & 1U, dy = corner >> 1U & 1U, dz = corner >> 2U;
      const float weight = (dx ? tx : 1 - tx) * (dy ? ty : 1 - ty) * (dz ? tz : 1 - tz);
      sum += weight * height_[x + dx][y + dy][z + dz];
    }
    return sum;
  }

 private:
  float height_[dents_along][dents_along][dents_along];
};

// A triangular flap folded onto an end, in the end's frame: from its lower edge up to the point.
void add_flap(PackBuilder& pack,
              float width,
              float reach,
              float thick,
              std::uint16_t surface,
              const Placement& place) {
  const auto at = [&](float x, float y, float z) { return Corner{place({x, y, z}), {}}; };
  const float half = width / 2, bevel = 2 * thick;
  const Corner a = at(-half, 0, 0), b = at(half, 0, 0), c = at(0, 0, reach);
  const Corner d = at(-half + 2 * bevel, -thick, 0.4F * bevel);
  const Corner e = at(half - 2 * bevel, -thick, 0.4F * bevel);
  const Corner f = at(0, -thick, reach - 1.5F * bevel);
  pack.add_triangle(d, e, f, surface);
  pack.add_triangle(a, c, b, surface);
  pack.add_quad(a, b, e, d, surface);
  pack.add_quad(b, c, f, e, surface);
  pack.add_quad(c, a, d, f, surface);
}

// Envelope folds on both ends of the pack, `along` its longest axis.
void add_folds(PackBuilder& pack, bool upright, std::uint16_t surface) {
  const float w = pack.width(), d = pack.depth(), h = pack.height();
  const float thick = std::min(0.0005F, 0.01F * std::min({w, d, h}));
  const float half = (upright ? h : w) / 2;
  const float wide = 0.82F * (upright ? w : d), reach = 0.50F * (upright ? d : h);
  for (const float side : {-1.0F, 1.0F}) {
    for (const float turn : {-1.0F, 1.0F}) {
      // y points into the pack, z from the flap's fold to its tip.
      PartFrame flap;
      if (upright) {
        flap.origin = {0, -0.44F * turn * d, half + side * (half - 1.4F * thick)};
        flap.y = {0, 0, -side};
        flap.z = {0, turn, 0};
      } else {
        flap.origin = {side * (half - 1.4F * thick), 0, h / 2 - 0.44F * turn * h};
        flap.y = {-side, 0, 0};
        flap.z = {0, 0, turn};
      }
      flap.x = cross(flap.y, flap.z);
      add_flap(pack, wide, reach, thick, surface, flap);
    }
  }
}

}  // namespace

// Butter, yeast, marzipan lying; vacuum-packed coffee and rice standing: foil folded over both
// ends.
Result<ProductModel> make_foil_brick(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(0.32F);
  const std::uint16_t foil =
      pack.add_surface({.color = colors.primary, .roughness = 0.32F, .metallic = 0.2F});
  const float w = pack.width(), d = pack.depth(), h = pack.height();
  const bool upright = h > w;
  const float margin = std::min(0.0010F, 0.02F * std::min({w, d, h}));  // where the flaps lie
  const Vec3f size{upright ? w : w - 2 * margin, d, upright ? h - 2 * margin : h};
  const float edge = std::min(brick_edge_m, 0.10F * std::min({w, d, h}));
  const Dents dents(product);
  const float deep = std::min(dent_m, 0.01F * std::min({w, d, h}));

  const BoxGrid grid{rounded_lines(size.x, edge, 2, 9),
                     rounded_lines(size.y, edge, 2, 6),
                     rounded_lines(size.z, edge, 2, 9)};
  add_panel_box(pack, grid, {print, print, print, print, print, print}, [&](Vec3f share) {
    const Vec3f p = rounded_box_point(share, size, edge);
    const Vec3f out{2 * share.x - 1, 2 * share.y - 1, 2 * share.z - 1};
    const float sink = 1 - deep * (1 + dents.at(share)) / std::min({w, d, h}) * 2;
    const auto face = [&](float o) { return std::abs(o) > 0.98F ? sink : 1.0F; };
    const float lift = upright ? margin : 0.0F;
    return Vec3f{
        p.x * face(out.x), p.y * face(out.y), lift + size.z / 2 + (p.z - size.z / 2) * face(out.z)};
  });
  add_folds(pack, upright, foil);
  return pack.finish(0.4F);
}

CollisionPrimitive collision_foil_brick(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
