#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr float greatest_fin_m = 0.009F;  // width of an end seal
constexpr int crimps = 5;                 // ridges that the sealing jaws press into a fin
constexpr float crimp_rise_m = 0.0004F;

// One half of the pack from its fin's edge (share 0) to the body (share 1).
struct Fin {
  float length, half_across, half_thick;  // the fin's
  float shoulder;                         // length over which it opens to the body
};

void add_half(std::vector<Section>& half,
              const WrapForm& form,
              const Fin& fin,
              std::uint16_t print) {
  const auto section = [&](float z, float across, float thick, float roundness, float rise) {
    return Section{.z = z,
                   .half_width = across,
                   .half_depth = thick,
                   .surface = print,
                   .roundness = roundness,
                   .y = rise};
  };
  for (int i = 0; i <= 2 * crimps; ++i) {
    const float z = fin.length * static_cast<float>(i) / (2 * crimps);
    const float rise = std::min(crimp_rise_m, 0.3F * fin.half_thick) * (i % 2 == 0 ? 1.0F : -1.0F);
    half.push_back(section(z, fin.half_across, fin.half_thick, 0.02F, rise));
  }
  constexpr int steps = 7;
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / steps;
    const float open = 1 - (1 - t) * (1 - t) * (1 - t), ease = t * t * (3 - 2 * t);
    half.push_back(section(fin.length + fin.shoulder * t,
                           fin.half_across + (form.half_across_m - fin.half_across) * ease,
                           fin.half_thick + (form.half_thick_m - fin.half_thick) * open,
                           0.02F + (form.roundness - 0.02F) * open,
                           0));
  }
}

}  // namespace

// Chocolate bars, biscuits, ice lollies: film sealed along the back and crimped at both ends.
Result<ProductModel> make_flow_pack(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  MARKETGEN_TRY(const PackColors colors, pack_colors(product));
  const std::uint16_t print = pack.add_print(film_roughness);
  const std::uint16_t edge = pack.add_surface(film(colors.primary));
  const WrapForm form = wrap_form_of(product);
  Fin fin;
  fin.length = std::min(greatest_fin_m, 0.09F * form.length_m);
  fin.half_across = form.half_across_m / flow_body_share;
  fin.half_thick = std::min(0.0004F, 0.1F * form.half_thick_m);
  fin.shoulder = std::min(0.22F * form.length_m, 1.1F * form.half_thick_m + 0.002F);

  std::vector<Section> sections;
  add_half(sections, form, fin, print);
  sections.front().surface = edge;
  const std::size_t half = sections.size();
  for (std::size_t i = 0; i < half; ++i) {
    Section mirrored = sections[half - 1 - i];
    mirrored.z = form.length_m - mirrored.z;
    sections.push_back(mirrored);
  }
  add_loft(pack, sections, {.triangles = 2800, .max_chords = 6, .lying = true}, form.frame);
  const float end = pack.width() / 2;
  pack.add_band_feature(FeatureKind::seam, -end, fin.length - end, PackAxis::x);
  pack.add_band_feature(FeatureKind::seam, end - fin.length, end, PackAxis::x);
  return pack.finish(0.3F);
}

CollisionPrimitive collision_flow_pack(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
