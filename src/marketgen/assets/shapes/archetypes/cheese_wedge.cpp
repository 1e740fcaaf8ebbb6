#include <algorithm>
#include <cmath>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/outline_wall.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/plate.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"
#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f young_cheese{0.80F, 0.51F, 0.13F};
constexpr float cheese_label_m = 0.0002F;
constexpr int tip_chords = 6, rind_chords = 14;
constexpr float rind_bulge_share = 0.10F;  // of the width: the wheel's curve

// The wedge seen from above: the tip to the left, the rind to the right.
struct Wedge {
  float width, half_depth, tip_radius, bulge;
  Vec2f tip, corner;  // centre of the tip's rounding; where front cut and rind meet
  Vec2f cut_out;      // direction outwards of the front cut
};

Wedge wedge_of(const PackBuilder& pack) {
  Wedge w{};
  w.width = pack.width();
  w.half_depth = pack.depth() / 2;
  w.tip_radius = 0.09F * std::min(w.width, w.half_depth);
  w.bulge = rind_bulge_share * w.width;
  w.tip = {-w.width / 2 + w.tip_radius, 0};
  w.corner = {w.width / 2 - w.bulge, -w.half_depth};
  const Vec2f along = w.corner - w.tip;
  const float length = std::sqrt(along.x * along.x + along.y * along.y);
  w.cut_out = {along.y / length, -along.x / length};
  return w;
}

// From the tip along the front cut, around the rind, back along the rear cut.
OutlineSide outline_of(const Wedge& w) {
  OutlineSide side;
  const auto mirrored = [](Vec2f p) { return Vec2f{p.x, -p.y}; };
  const auto add = [&](Vec2f at, Vec2f out) { side.points.push_back({at, out}); };
  std::vector<OutlinePoint> front;
  for (int i = 0; i <= tip_chords; ++i) {  // from straight left round to the cut's direction
    const float t = static_cast<float>(i) / tip_chords;
    const Vec2f blend{-1 + t * (w.cut_out.x + 1), t * w.cut_out.y};
    const float length = std::sqrt(blend.x * blend.x + blend.y * blend.y);
    const Vec2f out = blend * (1 / length);
    front.push_back({w.tip + out * w.tip_radius, out});
  }
  front.push_back({w.corner, w.cut_out});
  for (const OutlinePoint& p : front)
    add(p.at, p.out);
  for (int i = 0; i <= rind_chords; ++i) {
    const float t = 2 * static_cast<float>(i) / rind_chords - 1;
    const Vec2f out{1, 2 * w.bulge * t / w.half_depth};
    const float length = std::sqrt(1 + out.y * out.y);
    if (i > 0 && i < rind_chords)
      add({w.corner.x + w.bulge * (1 - t * t), w.half_depth * t}, out * (1 / length));
  }
  for (std::size_t i = front.size(); i-- > 0;)
    add(mirrored(front[i].at), mirrored(front[i].out));
  measure(side);
  return side;
}

// One label lies on the upper face, one on the front cut.
void add_labels(PackBuilder& pack,
                const Wedge& w,
                const SleeveFaces& faces,
                std::uint16_t print,
                std::uint16_t edge) {
  const float h = pack.height();
  const PartFrame top{.origin = {0.14F * w.width, -faces.top.height_m / 2, h},
                      .x = {1, 0, 0},
                      .y = {0, 0, -1},
                      .z = {0, 1, 0}};
  add_sticker(pack,
              pack.panel(PanelKind::top),
              {faces.top.width_m, cheese_label_m, faces.top.height_m},
              print,
              edge,
              top);
  const Vec2f along{-w.cut_out.y, w.cut_out.x};
  const Vec2f start = w.tip + w.cut_out * (w.tip_radius + cheese_label_m);
  const Vec2f middle =
      (start + w.corner + w.cut_out * cheese_label_m) * 0.5F + along * (0.06F * w.width);
  const PartFrame front{.origin = {middle.x, middle.y, (h - faces.front.height_m) / 2},
                        .x = {along.x, along.y, 0},
                        .y = {-w.cut_out.x, -w.cut_out.y, 0},
                        .z = {0, 0, 1}};
  add_sticker(pack,
              pack.panel(PanelKind::front),
              {faces.front.width_m, 0.5F * cheese_label_m, faces.front.height_m},
              print,
              edge,
              front);
}

}  // namespace

// A piece cut from a wheel, shrink-wrapped, labelled above and on its cut.
Result<ProductModel> make_cheese_wedge(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t print = pack.add_print(gloss_paper_roughness);
  const std::uint16_t cheese = pack.add_surface(clear_plastic(young_cheese));
  const std::uint16_t edge = pack.add_surface(paper({0.8F, 0.8F, 0.78F}));
  const Wedge w = wedge_of(pack);
  const float h = pack.height() - cheese_label_m,
              round = std::min({0.0030F, 0.12F * h, 0.7F * w.tip_radius});
  const OutlineSide outline = outline_of(w);
  add_outline_wall(pack,
                   {outline},
                   {{0, round, cheese},
                    {0.08F * round, 0.6F * round, cheese},
                    {0.3F * round, 0.28F * round, cheese},
                    {round, 0, cheese},
                    {h - round, 0, cheese},
                    {h - 0.3F * round, 0.28F * round, cheese},
                    {h - 0.08F * round, 0.6F * round, cheese},
                    {h, round, cheese}},
                   {0.12F * w.width, 0});
  add_labels(pack, w, sleeve_faces_of(product), print, edge);
  return pack.finish();
}

CollisionPrimitive collision_cheese_wedge(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
