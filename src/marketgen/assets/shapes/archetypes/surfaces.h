// What packs are made of, as render surfaces.
#pragma once
#include "assets/product_model.h"
#include "base/result.h"

namespace marketgen::assets {

// Roughness of printed faces.
inline constexpr float gloss_paper_roughness = 0.45F;  // coated label paper, folding carton
inline constexpr float matt_paper_roughness = 0.75F;   // uncoated paper bags
inline constexpr float film_roughness = 0.30F;         // printed plastic film
inline constexpr float lacquer_roughness = 0.25F;      // lacquered metal
inline constexpr float skin_roughness = 0.40F;         // waxy fruit skin

// The row's colours as linear RGB.
struct PackColors {
  Vec3f primary, secondary, accent;
};
Result<PackColors> pack_colors(const catalog::Product& product);  // Errors: assets.bad_row

// What is seen through clear plastic or glass: by the first word of contents.inc that the row's
// name, variant, subcategory or keywords contain, otherwise the label's ground colour.
Result<Vec3f> contents_color(const catalog::Product& product);  // Errors: assets.bad_row

// Index of refraction of what is inside by the same word, when it is a liquid one sees through;
// otherwise 0.
float contents_refraction(const catalog::Product& product);

Surface aluminium();
Surface tinplate();
Surface lacquered_metal(Vec3f color);
Surface plastic(Vec3f color);
Surface paper(Vec3f color);
Surface film(Vec3f color);
// Clear plastic or glass with what it holds, as one glossy surface: opaque, unless a `refraction`
// says that one sees through it (Surface::refraction).
Surface filled_plastic(Vec3f contents, float refraction = 0);
Surface filled_glass(Vec3f contents, float refraction = 0);
// Antique green: it hides what it holds.
Surface dark_glass();

}  // namespace marketgen::assets
