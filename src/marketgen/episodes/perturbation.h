// A world that is a little other than its episode says: where things lie, how they rub, and how
// heavy they are. Given to a TrackWorld when it is reset; policies and oracles go on being told the
// rows' friction and masses, and oracles see things where they truly lie.
//
// SI units. Immutable; any number of threads may ask.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "base/seed.h"
#include "catalog/product.h"
#include "catalog/rows.h"
#include "episodes/perturbation_sizes.h"
#include "geometry/pose.h"

namespace marketgen::episodes {

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

// Nothing when all sizes are 0.
std::optional<Perturbation> perturbation_of(const PerturbationSizes& sizes, Seed seed);

}  // namespace marketgen::episodes
