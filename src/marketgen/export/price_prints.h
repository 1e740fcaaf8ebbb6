// The price tags and offer cards of a store's shelf edges: each design once, and where it is stuck
// on.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::exporters {

constexpr float print_roughness = 0.5F;

struct PricePrint {
  std::string name;         // "price/<sku>", "offer/<sku>"
  std::size_t picture = 0;  // row of PricePrints::pictures
  Mesh mesh;                // an upright sheet round its middle, facing -Y
  std::vector<Pose> places;
};

struct PricePrints {
  std::vector<std::string> pictures;  // PNG
  std::vector<PricePrint> tags, cards;
};

// Errors: those of draw_price_tag and draw_promotion_card, image.*.
Result<PricePrints> price_prints(const scene::Scene& scene);

// The design at all its places as one mesh, in the store frame.
Mesh mesh_of_all(const PricePrint& print);

}  // namespace marketgen::exporters
