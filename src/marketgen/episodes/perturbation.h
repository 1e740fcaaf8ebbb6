// A world that is a little other than its episode says: where things lie, how they rub, and how
// heavy they are. Given to a TrackWorld when it is reset; policies and oracles go on being told the
// rows' friction and masses, and oracles see things where they truly lie.
//
// SI units. Immutable; any number of threads may ask.
#pragma once
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/seed.h"
#include "catalog/product.h"
#include "catalog/rows.h"
#include "geometry/pose.h"

namespace marketgen::episodes {

// Each is drawn evenly from minus as much to plus as much.
struct PerturbationSizes {
  double place_m = 0.005, turn_deg = 1;
  double friction = 0.2, mass = 0.1;
  static constexpr auto fields = field_list(
      field("place_m", &PerturbationSizes::place_m, "to each side, of things", range(0, 0.1)),
      field("turn_deg", &PerturbationSizes::turn_deg, "about their upright", range(0, 45)),
      field(
          "friction", &PerturbationSizes::friction, "share, of pairs of materials", range(0, 0.9)),
      field("mass", &PerturbationSizes::mass, "share, of products", range(0, 0.9)));
};

// What is drawn for a thing depends on the seed and on its own name only.
class Perturbation {
 public:
  Perturbation(const PerturbationSizes& sizes, Seed seed) : sizes_(sizes), seed_(seed) {}

  const PerturbationSizes& sizes() const { return sizes_; }

  // Where the thing of that name comes to lie, along the level and about its upright: in the frame
  // of `pose`, whose Z is up. `share` of what is drawn for it.
  Pose moved(const Pose& pose, std::string_view thing, double share = 1) const;
  // The rows, each rubbing so many times as much as before.
  std::vector<catalog::FrictionRow> frictions(std::vector<catalog::FrictionRow> rows) const;
  // For WorldOptions::mass_factors, by product: equal SKUs, equal factors.
  std::vector<double> mass_factors(const std::vector<catalog::Product>& products) const;

 private:
  PerturbationSizes sizes_;
  Seed seed_;
};

}  // namespace marketgen::episodes
