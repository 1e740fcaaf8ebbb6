#include "assets/shapes/archetypes/foliage.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace marketgen::assets {
namespace {

constexpr float leaf_thickness = 0.045F;  // in half widths
constexpr int leaf_knots = 7;

// Half width of a leaf, in its greatest, at share t of its length.
float leaf_width(const LeafForm& form, float t) {
  const auto hump = [](float x) { return std::max(0.0F, 4 * x * (1 - x)); };
  switch (form.outline) {
    case LeafOutline::pointed:
      return form.stalk * (1 - t) + hump(t) * (1.15F - 0.55F * t) * (1 - 0.6F * form.stalk);
    case LeafOutline::oval:
      return form.stalk * (1 - t) + (1 - 0.5F * form.stalk) * std::min(1.0F, 1.25F * hump(t));
    case LeafOutline::strap:
      return t < 0.75F ? form.stalk + (1 - form.stalk) * std::min(1.0F, t / 0.5F)
                       : std::max(0.0F, 1 - 16 * (t - 0.75F) * (t - 0.75F));
    case LeafOutline::spoon:
      return form.stalk +
             (1 - form.stalk) * (t < 0.3F ? 0.0F : hump(0.12F + 0.88F * (t - 0.3F) / 0.7F));
  }
  return 1;
}

}  // namespace

Surface plant(Vec3f color) {
  return {.color = color, .roughness = 0.75F};
}

void add_leaf(PackBuilder& pack,
              const ShellSkin& skin,
              const LeafForm& form,
              const Placement& place) {
  TubeForm tube;
  tube.up = form.up;
  tube.fold = form.fold;
  tube.ruffle = form.ruffle;
  tube.ruffles = form.ruffles;
  const Vec3f span = form.tip - form.foot;
  const float reach = length(span);
  const float thick = leaf_thickness * form.half_width;
  for (int i = 0; i < leaf_knots; ++i) {
    const float t = static_cast<float>(i) / (leaf_knots - 1);
    const float rise = form.arch * 4 * t * (1 - t) - form.curl * t * t * t;
    const float half = form.half_width * leaf_width(form, t);
    tube.knots.push_back(
        {form.foot + span * t + form.up * (rise * reach),
         std::max(half, 0.02F * form.half_width),
         std::max(thick, 0.35F * std::min(half, form.stalk * form.half_width) * (1 - t))});
  }
  add_tube(pack, skin, form.segments, form.bands, tube, place);
}

void add_wrap_leaf(PackBuilder& pack,
                   const ShellSkin& skin,
                   const WrapLeaf& form,
                   int segments,
                   int bands,
                   const Placement& place) {
  constexpr float thickness = 0.012F;  // in radii of the head
  const ShellPoint point = [&](double turn, double along) {
    const Vec2 side = unit_circle(turn + 0.75);  // x across the leaf, y to its outer side
    // Broad from low down, round at the upper edge.
    const double squared = along * along;
    const double width = along <= 0 || along >= 1
                             ? 0.0
                             : std::min(1.0, 0.35 + 1.5 * along) * std::sqrt(1 - squared * squared);
    const double across = -side.x * width;  // counter-clockwise seen from the tip
    // The edge's corners hang back, so that the outline is an arc.
    const double up = form.low + (form.high - form.low) * (along - 0.22 * across * across * along);
    const Vec2 around = unit_circle(0.25 + form.turn + form.half_turn * across);
    const Vec2 polar = unit_circle(-0.25 + 0.5 * up);
    const double edge = std::max(across * across * along * (2 - along), along * along * along);
    const double wave = unit_circle(form.ruffles * (0.5 * across + along)).x;
    const double off = 1 + static_cast<double>(form.off) +
                       static_cast<double>(form.flare) * edge * edge +
                       static_cast<double>(form.ruffle) * wave * edge +
                       static_cast<double>(thickness) * side.y * (along <= 0 || along >= 1 ? 0 : 1);
    const double ring = polar.x + static_cast<double>(form.fullness) *
                                      (std::sqrt(std::max(polar.x, 0.0)) - polar.x);
    const Vec3f own = to_float({ring * around.x * off, ring * around.y * off, polar.y * off});
    return place(form.middle + own * form.half);
  };
  std::vector<double> stations = even_stations(bands);
  for (double& along : stations)
    along *= 1.5 - 0.5 * along * along;  // closer together towards the edge
  add_shell(pack, skin, {segments, stations}, point);
}

void add_stalk(PackBuilder& pack,
               std::uint16_t surface,
               const StalkForm& form,
               const Placement& place) {
  TubeForm tube;
  tube.up = {0, -1, 0};
  const auto knot = [&](float t, float share) {
    const float off = form.length * t * t;
    tube.knots.push_back({form.foot + Vec3f{form.lean.x * off, form.lean.y * off, form.length * t},
                          form.radius * share,
                          form.radius * share});
  };
  knot(0, form.flare);
  knot(0.2F, 0.5F + 0.5F * form.flare);
  knot(0.5F, 1);
  knot(0.85F, 1);
  knot(1, form.knob);
  tube.high_round_m = 0.12F * form.length;
  add_tube(pack, {surface}, form.segments, 5, tube, place);
}

void add_calyx(PackBuilder& pack,
               std::uint16_t surface,
               const CalyxForm& form,
               Stream draw,
               const Placement& place) {
  const double start = draw.uniform();
  for (int i = 0; i < form.sepals; ++i) {
    const Vec2 out = unit_circle(start + (i + draw.uniform(-0.12, 0.12)) / form.sepals);
    const auto ox = static_cast<float>(out.x), oy = static_cast<float>(out.y);
    const float reach = form.reach * static_cast<float>(draw.uniform(0.8, 1.05));
    LeafForm leaf;
    leaf.foot = form.middle + Vec3f{ox, oy, 0} * (0.08F * reach);
    leaf.tip = form.middle + Vec3f{ox * reach, oy * reach, -form.drop};
    leaf.half_width = form.half_width;
    leaf.arch = 0.10F;
    leaf.curl = -static_cast<float>(draw.uniform(0, 0.18));
    leaf.fold = 0.15F;
    leaf.stalk = 0.7F;
    leaf.segments = form.segments;
    add_leaf(pack, {surface}, leaf, place);
  }
  add_stalk(pack,
            surface,
            {.foot = form.middle - Vec3f{0, 0, 0.2F * form.stalk_length},
             .length = form.stalk_length * 1.2F,
             .radius = form.stalk_radius,
             .lean = {static_cast<float>(draw.uniform(-0.3, 0.3)),
                      static_cast<float>(draw.uniform(-0.3, 0.3))},
             .flare = 2.0F,
             .segments = form.segments},
            place);
}

}  // namespace marketgen::assets
