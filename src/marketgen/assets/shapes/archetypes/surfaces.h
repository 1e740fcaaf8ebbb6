// What packs are made of, as render surfaces.
#pragma once
#include "assets/product_model.h"
#include "base/result.h"

namespace marketgen::assets {

// Roughness of printed faces.
inline constexpr float gloss_paper_roughness = 0.45F;   // coated label paper, folding carton
inline constexpr float matt_paper_roughness = 0.75F;    // uncoated paper bags
inline constexpr float film_roughness = 0.30F;          // printed plastic film
inline constexpr float lacquer_roughness = 0.25F;       // lacquered metal
inline constexpr float skin_roughness = 0.40F;          // waxy fruit skin
inline constexpr float plastic_wall_roughness = 0.12F;  // blown bottles
inline constexpr float glass_roughness = 0.06F;

// The row's colours as linear RGB.
struct PackColors {
  Vec3f primary, secondary, accent;
};
Result<PackColors> pack_colors(const catalog::Product& product);  // Errors: assets.bad_row

Surface aluminium();
Surface tinplate();
Surface lacquered_metal(Vec3f color);
Surface plastic(Vec3f color);
Surface paper(Vec3f color);
Surface film(Vec3f color);
// Clear plastic over something of that colour, or moulded in it.
Surface clear_plastic(Vec3f color);
// Antique green: it hides what it holds.
Surface dark_glass();

}  // namespace marketgen::assets
