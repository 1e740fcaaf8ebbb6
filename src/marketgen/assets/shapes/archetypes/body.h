// Bodies of revolution that grew: a smooth outline turned about an axis, with ribs, lumps, a groove
// and a lean of its own. Fruit, bulbs, loaves.
#pragma once
#include <array>

#include "assets/shapes/archetypes/shell.h"
#include "base/seed.h"

namespace marketgen::assets {

// (radius, height) from the lower pole to the upper, both with radius 0, in shares of the greatest
// radius and of the body's length; what follows the upper pole is not read.
using Outline = std::array<Vec2, 14>;

struct BodyForm {
  Outline outline;
  int lobes = 0;                       // ribs once around, valleys between them
  double lobe_low = 0, lobe_high = 0;  // depth of the valleys at the lower and the upper end
  double lumps = 0;                    // swellings and hollows, in radii
  double groove = 0;                   // depth of one seam from pole to pole, in radii
  double lean = 0;                     // most that the upper end strays from the axis, in radii
  double bend = 0;                     // most that the middle stands off the line between the ends
};

// A body with its own lobes, lumps and lean: the same draw gives the same body.
class GrownBody {
 public:
  // `half`: the greatest half width, half depth and half length in metres.
  GrownBody(const BodyForm& form, Vec3f half, Stream draw);

  // About the Z axis from z = 0 up; the ends bend towards +X.
  Vec3f point(double turn, double along) const;
  Vec3f top() const { return point(0, 1); }

 private:
  Vec2f outline_at(double along) const;
  float lobe_wave(double turn) const;
  float lump_at(Vec3f direction) const;
  Vec3f off_axis(float height) const;

  struct Lump {
    Vec3f direction;
    float size;
  };

  BodyForm form_;
  Vec3f half_;
  std::vector<Vec2f> line_;  // the outline at equal lengths
  std::vector<Lump> lumps_;
  std::vector<float> lobe_sizes_;
  double lobe_turn_ = 0, groove_turn_ = 0;
  Vec2f lean_;
  float bend_ = 0;
};

}  // namespace marketgen::assets
