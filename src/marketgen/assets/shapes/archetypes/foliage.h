// What grows on fruit and vegetables: leaves, twigs, sepals, stumps, cut stalks. Each is a closed
// shell of its own.
#pragma once
#include "assets/shapes/archetypes/shell.h"
#include "base/seed.h"

namespace marketgen::assets {

// Linear colours of green and dry parts.
inline constexpr Vec3f twig_brown{0.10F, 0.065F, 0.03F};
inline constexpr Vec3f sepal_green{0.10F, 0.22F, 0.035F};
inline constexpr Vec3f leaf_green{0.07F, 0.20F, 0.03F};
inline constexpr Vec3f pale_green{0.42F, 0.52F, 0.18F};
inline constexpr Vec3f straw{0.55F, 0.42F, 0.20F};

Surface plant(Vec3f color);  // matt, as leaves and twigs are

enum class LeafOutline { pointed, oval, strap, spoon };

// A leaf arches from foot to tip. Its upper side is the one that `up` points away from.
struct LeafForm {
  Vec3f foot, tip;
  Vec3f up{0, 0, 1};
  float half_width = 0.01F;
  float arch = 0;      // rise of the middle over the line from foot to tip, in its length
  float curl = 0;      // bend of the tip back down, in its length
  float fold = 0.25F;  // edges over the midrib, in half widths
  float ruffle = 0;    // of the edges, in half widths
  int ruffles = 3;
  float stalk = 0.12F;  // width of the foot, in half widths
  int segments = 8, bands = 5;
  LeafOutline outline = LeafOutline::pointed;
};
void add_leaf(PackBuilder& pack,
              const ShellSkin& skin,
              const LeafForm& form,
              const Placement& place = PartFrame{});

// A leaf that lies on an egg-shaped head and wraps round it: from the foot of the head upwards, its
// edge standing off.
struct WrapLeaf {
  Vec3f middle, half;          // the head's
  double turn = 0;             // where the leaf's midrib lies, as a shell's turns
  double half_turn = 0.2;      // how far it reaches to either side
  double low = 0, high = 0.5;  // from the lower pole (0) to the upper (1) of the head
  float off = 0.02F;           // over the head, in its radii
  float flare = 0.1F;          // how far the edge stands off beyond that
  float ruffle = 0.02F;        // waves of the edge
  int ruffles = 9;             // once along the edge
  float fullness = 0;          // of the head: 0 an ellipsoid, 1 nearly a cylinder
};
void add_wrap_leaf(PackBuilder& pack,
                   const ShellSkin& skin,
                   const WrapLeaf& form,
                   int segments,
                   int bands,
                   const Placement& place = PartFrame{});

// A stalk that stands at `foot` along +Z with flared ends.
struct StalkForm {
  Vec3f foot;
  float length = 0.02F, radius = 0.002F;
  Vec2f lean{};        // how far the tip stands off, in lengths
  float flare = 1.4F;  // of the foot, in radii
  float knob = 1.15F;  // of the tip, in radii
  int segments = 10;
};
void add_stalk(PackBuilder& pack,
               std::uint16_t surface,
               const StalkForm& form,
               const Placement& place = PartFrame{});

// Sepals in a star round `middle`, spread out over a body that falls away by `drop` at their tips,
// with a short stalk.
struct CalyxForm {
  Vec3f middle;
  int sepals = 5;
  float reach = 0.02F, half_width = 0.004F, drop = 0.004F;
  float stalk_length = 0.008F, stalk_radius = 0.0025F;
  int segments = 6;  // of each part
};
void add_calyx(PackBuilder& pack,
               std::uint16_t surface,
               const CalyxForm& form,
               Stream draw,
               const Placement& place = PartFrame{});

}  // namespace marketgen::assets
