#include <algorithm>
#include <array>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/pack_builder.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "base/hash.h"
#include "base/seed.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr int leaf_layers = 4;  // one over another from the stalk to the heart
constexpr int leaves_in_layer = 5;
constexpr int segments_of_leaf = 8;
constexpr int head_segments = leaves_in_layer * segments_of_leaf;
constexpr std::array<float, 4> leaf_rows{0, 0.4F, 0.75F, 1};  // from a leaf's foot to its edge
constexpr float leaf_step =
    0.17F;  // share of the radius by which a leaf's edge stands off the next layer
constexpr float leaf_arch =
    0.55F;  // share of a layer's height between the tip of a leaf and its corners
constexpr float leaf_cleft = 0.07F;  // share of the radius by which two leaves sink where they meet
constexpr float leaf_ruffle = 0.022F;  // share of the radius by which the edge waves

// The head's outline: `along` from stalk (0) to heart (1). Tall heads open upwards.
Vec2f head_outline(float along, float tallness) {
  const Vec2 p = unit_circle(-0.22 + 0.47 * static_cast<double>(along));
  const auto out = static_cast<float>(p.x), up = static_cast<float>(p.y);
  return {out * (1 + 0.22F * tallness * up), up};
}

// How near a segment is to the middle of its leaf: 1 there, 0 between two leaves. Layers are
// staggered by half a leaf.
float leaf_middle(int layer, int segment) {
  const int shifted = (segment + (layer % 2) * segments_of_leaf / 2) % segments_of_leaf;
  const float t =
      2.0F * static_cast<float>(shifted) / segments_of_leaf - 1;  // -1..1 across the leaf
  return 1 - t * t;
}

// Where the line between layer - 1 and layer runs: leaves of the lower one arch up over the next.
float layer_line(int layer, int segment) {
  const bool pole = layer == 0 || layer == leaf_layers;
  const float arch = pole ? 0 : leaf_arch * (leaf_middle(layer - 1, segment) - 0.6F);
  return (static_cast<float>(layer) + arch) / leaf_layers;
}

struct LeafPoint {
  float along;   // of the head
  float relief;  // share of the outline's radius
};

LeafPoint leaf_point(int layer, float row, int segment) {
  const float foot = layer_line(layer, segment), edge = layer_line(layer + 1, segment);
  const float middle = leaf_middle(layer, segment);
  const float wave = segment % 2 == 0 ? leaf_ruffle : -leaf_ruffle;
  const float relief =
      1 - leaf_step * (1 - row * row) - leaf_cleft * (1 - middle) + wave * row * row;
  return {foot + (edge - foot) * row, relief};
}

}  // namespace

Result<ProductModel> make_leafy_produce(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t skin = pack.add_print(skin_roughness);
  const double start = Seed(hash64(product.sku)).stream().uniform();
  const float tallness = std::min(1.0F, std::max(0.0F, pack.height() / pack.width() - 1));

  const Panel* panel = pack.panel(PanelKind::skin);

  const auto corner = [&](int layer, float row, int segment) {
    const LeafPoint leaf = leaf_point(layer, row, segment % head_segments);
    const double turn = static_cast<double>(segment % head_segments) / head_segments;
    const Vec2 out = unit_circle(0.25 + turn + start);
    const Vec2f outline = head_outline(leaf.along, tallness);
    const bool heart = layer + 1 == leaf_layers && row >= 1;
    const float radius = heart ? 0 : outline.x * leaf.relief;
    return Corner{
        {radius * static_cast<float>(out.x), radius * static_cast<float>(out.y), outline.y},
        uv_in(panel, static_cast<float>(segment) / head_segments, 1 - leaf.along)};
  };
  const Corner stalk{{0, 0, head_outline(0, tallness).y + 0.03F}, uv_in(panel, 0.5F, 1)};
  for (int segment = 0; segment < head_segments; ++segment) {
    const int next = segment + 1;
    pack.add_triangle(stalk, corner(0, 0, next), corner(0, 0, segment), skin);
    for (int layer = 0; layer < leaf_layers; ++layer) {
      for (std::size_t i = 1; i < leaf_rows.size(); ++i) {
        const float low = leaf_rows[i - 1], high = leaf_rows[i];
        pack.add_quad(corner(layer, low, segment),
                      corner(layer, low, next),
                      corner(layer, high, next),
                      corner(layer, high, segment),
                      skin);
      }
      if (layer + 1 == leaf_layers) continue;
      pack.add_quad(corner(layer, 1, segment),
                    corner(layer, 1, next),
                    corner(layer + 1, 0, next),
                    corner(layer + 1, 0, segment),
                    skin);  // the step inwards behind the leaf's edge
    }
  }
  return pack.finish(0.5F);
}

CollisionPrimitive collision_leafy_produce(const catalog::Product& product) {
  return ellipsoid_around(product);
}

}  // namespace marketgen::assets
