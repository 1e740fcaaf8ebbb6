// Numbers of an outside model that nobody measured, from what the catalogue knows of its like.
#pragma once
#include <string>

#include "catalog/catalog.h"

namespace marketgen::assets {

struct Estimate {
  double value = 0;
  std::string from;  // a sentence for a person
};

// Mass in kilograms: `volume_m3` times the density of goods like it. That is the median over the
// catalogue's rows of the same subcategory and material, else of the same material, else of all,
// of mass over the volume of the bounding box, divided by what a pack fills of its box (0.8).
// Within the limits of product rows.
Estimate estimated_mass(const catalog::Product& product,
                        double volume_m3,
                        const catalog::Catalog& catalog);

// Sliding friction on a painted steel shelf, from data/friction.json; 0.35 for an unknown material.
Estimate estimated_friction(const std::string& material, const catalog::Catalog& catalog);

}  // namespace marketgen::assets
