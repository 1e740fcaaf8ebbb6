// How far a world may be off from what its episode says (episodes/perturbation.h).
#pragma once
#include "base/fields.h"

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

}  // namespace marketgen::episodes
