#include <algorithm>
#include <array>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/panel_box.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float roll_pitch_m =
    0.11F;  // toilet rolls are 100 to 120 mm across and about 100 mm high
constexpr float bottle_pitch_m = 0.085F;  // bottles of 1 to 2 l
constexpr float bundle_edge_radius_m = 0.012F;
constexpr float film_dip_share = 0.13F;  // of the pitch: how far the film sinks between two pieces
constexpr int max_pieces = 6;            // along one side; more would not be told apart

struct Pieces {
  int across, deep, high;
};

int pieces_along(float length, float pitch) {
  return std::clamp(static_cast<int>(std::lround(length / pitch)), 1, max_pieces);
}

// Bottles stand in one layer, rolls in layers.
Pieces pieces_of(const catalog::Product& product, Vec3f size) {
  const bool bottles = product.unit_of_measure == "l";
  const float pitch = bottles ? bottle_pitch_m : roll_pitch_m;
  return {pieces_along(size.x, pitch),
          pieces_along(size.y, pitch),
          bottles ? 1 : pieces_along(size.z, pitch)};
}

// 0 on the middle of a piece, 1 between two.
float groove(float share, int pieces) {
  const float t = share * static_cast<float>(pieces);
  const float s = 2 * (t - std::floor(std::min(t, static_cast<float>(pieces) - 0.001F))) - 1;
  return 0.4F * s * s + 0.6F * s * s * s * s;
}

// The whole pack is one rounded box, drawn in where pieces meet.
Vec3f bundle_point(Vec3f share, Vec3f size, const Pieces& pieces) {
  Vec3f p = rounded_box_point(share, size, bundle_edge_radius_m);
  const float gx = groove(share.x, pieces.across), gy = groove(share.y, pieces.deep);
  const float gz = pieces.high > 1 ? groove(share.z, pieces.high) : 0;
  const float dip_x = film_dip_share * size.x / static_cast<float>(pieces.across);
  const float dip_y = film_dip_share * size.y / static_cast<float>(pieces.deep);
  const float layer = 0.03F * gz;
  p.x *= 1 - layer - 2 * dip_x / size.x * gy;
  p.y *= 1 - layer - 2 * dip_y / size.y * gx;
  const float top = std::max(0.0F, 2 * p.z / size.z - 1);
  p.z -= 0.05F * size.z / static_cast<float>(pieces.high) * top * (gx + gy) / 2;
  return p;
}

// `cells` to each piece.
std::vector<float> piece_lines(int pieces, int max_cells) {
  return even_lines(pieces * std::clamp(max_cells / pieces, 2, 6));
}

}  // namespace

Result<ProductModel> make_bundle(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const Vec3f size{pack.width(), pack.depth(), pack.height()};
  const Pieces pieces = pieces_of(product, size);
  const BoxGrid grid{
      piece_lines(pieces.across, 14), piece_lines(pieces.deep, 10), piece_lines(pieces.high, 8)};
  add_panel_box(pack, grid, {print, print, print, print, print, print}, [&](Vec3f share) {
    return bundle_point(share, size, pieces);
  });
  return pack.finish(0.4F);
}

CollisionPrimitive collision_bundle(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
