#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr int pleats = 10;  // folds of the gathered film around the clip

// From the casing's frill over the clip to the body.
std::vector<Section> gathered_end(const WrapForm& form, std::uint16_t casing, std::uint16_t clip) {
  const float end = form.print_from_m,
              thin = 0.16F * std::min(form.half_across_m, form.half_thick_m);
  const auto round = [](float z, float radius, float lobe, std::uint16_t surface) {
    return Section{
        .z = z, .half_width = radius, .half_depth = radius, .surface = surface, .lobe = lobe};
  };
  const auto body = [&](float z, float share, float lobe) {
    return Section{.z = z,
                   .half_width = share * form.half_across_m,
                   .half_depth = share * form.half_thick_m,
                   .surface = casing,
                   .lobe = lobe};
  };
  return {round(0, 1.5F * thin, 0.28F, casing),
          round(0.10F * end, 1.1F * thin, 0.22F, casing),
          round(0.17F * end, 0.85F * thin, 0, clip),
          round(0.17F * end, 1.25F * thin, 0, clip),
          round(0.28F * end, 1.25F * thin, 0, clip),
          round(0.28F * end, 0.85F * thin, 0, casing),
          body(0.33F * end, 0.30F, 0.10F),
          body(0.40F * end, 0.55F, 0.07F),
          body(0.52F * end, 0.76F, 0.04F),
          body(0.66F * end, 0.89F, 0.02F),
          body(0.82F * end, 0.97F, 0.008F),
          body(end, 1, 0)};
}

}  // namespace

// Liver sausage, polenta, dough, pet food: a casing filled tight and clipped at both ends.
Result<ProductModel> make_chub(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t casing = pack.add_surface(film(colors.primary));
  const std::uint16_t clip = pack.add_surface(aluminium());
  const WrapForm form = wrap_form_of(product);

  std::vector<Section> sections = gathered_end(form, casing, clip);
  const std::size_t half = sections.size();
  sections.back().surface = print;
  for (std::size_t i = 0; i < half; ++i) {
    Section mirrored = sections[half - 1 - i];
    mirrored.z = form.length_m - mirrored.z;
    // A surface belongs to the band that starts at its section: mirrored, to the one before.
    mirrored.surface = i + 1 < half ? sections[half - 2 - i].surface : casing;
    sections.push_back(mirrored);
  }
  add_loft(pack,
           sections,
           {.triangles = 2800, .lobes = pleats, .max_chords = 12, .lying = true},
           form.frame);
  const float end = pack.width() / 2, gathered = 0.30F * form.print_from_m;
  pack.add_band_feature(FeatureKind::seam, -end, gathered - end, PackAxis::x);
  pack.add_band_feature(FeatureKind::seam, end - gathered, end, PackAxis::x);
  return pack.finish();
}

CollisionPrimitive collision_chub(const catalog::Product& product) {
  return lying_cylinder_around(product);
}

}  // namespace marketgen::assets
