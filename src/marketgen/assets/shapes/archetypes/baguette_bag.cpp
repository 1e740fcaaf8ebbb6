#include <algorithm>

#include "assets/shapes/archetypes/collision.h"
#include "assets/shapes/archetypes/loft.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"
#include "assets/shapes/archetypes/shell.h"
#include "assets/shapes/archetypes/surfaces.h"

namespace marketgen::assets {
namespace {

constexpr Vec3f crust{0.44F, 0.20F, 0.065F};  // baked brown
constexpr Vec3f score{0.76F, 0.53F, 0.27F};   // the lighter crumb where the crust tore open
constexpr float loaf_share = 0.90F;           // of the sleeve's cross-section

Section section_of(const WrapForm& form, float along, float share, std::uint16_t surface) {
  return {.z = along * form.length_m,
          .half_width = share * form.half_across_m,
          .half_depth = share * form.half_thick_m,
          .surface = surface,
          .roundness = form.roundness};
}

// A folded foot, straight walls, an open edge that is turned in to the loaf.
void add_paper(PackBuilder& pack, const WrapForm& form, std::uint16_t print, std::uint16_t inside) {
  const float edge = form.print_to_m / form.length_m;
  std::vector<Section> sections{section_of(form, 0, 0.97F, inside),
                                section_of(form, 0.012F, 1, print),
                                section_of(form, 0.25F, 0.985F, print),
                                section_of(form, 0.55F, 0.995F, print),
                                section_of(form, edge - 0.04F, 0.99F, print),
                                section_of(form, edge, 1, inside),
                                section_of(form, edge - 0.004F, 0.965F, inside),
                                section_of(form, edge - 0.05F, 0.93F, inside)};
  add_loft(pack, sections, {.triangles = 1100, .lying = !form.standing}, form.frame);
}

void add_loaf(PackBuilder& pack, const WrapForm& form, std::uint16_t bread) {
  std::vector<Section> sections;
  const float from = form.print_to_m / form.length_m - 0.10F;
  sections.push_back(section_of(form, from, loaf_share, bread));
  sections.push_back(section_of(form, 0.86F, loaf_share, bread));
  constexpr int steps = 9;
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / steps;
    const float share = std::max(1 - t * t * t, 0.0F);
    sections.push_back(
        section_of(form, 0.86F + 0.14F * (1 - (1 - t) * (1 - t)), loaf_share * share, bread));
  }
  for (Section& s : sections)
    s.roundness = 1;
  add_loft(pack, sections, {.triangles = 900}, form.frame);
}

// Slanting cuts on the side that the reader sees.
void add_scores(PackBuilder& pack, const WrapForm& form, std::uint16_t surface) {
  const float across = form.half_across_m, face = -loaf_share * form.half_thick_m;
  for (const float along : {0.775F, 0.865F, 0.945F}) {
    const float narrow = along > 0.9F ? 0.72F : 1.0F;
    const float reach = 0.055F * form.length_m, side = 0.30F * across * narrow;
    const float z = along * form.length_m, y = face * (along > 0.9F ? 0.83F : 0.95F);
    TubeForm cut;
    cut.up = {0, -1, 0};
    cut.low_round_m = cut.high_round_m = 0.9F * reach;
    cut.knots = {{{side, y, z - reach}, 0.16F * across, 0.05F * across},
                 {{0, y - 0.02F * across, z}, 0.17F * across, 0.09F * across},
                 {{-side, y, z + 0.8F * reach}, 0.16F * across, 0.05F * across}};
    add_tube(pack, {.surface = surface}, 10, 6, cut, form.frame);
  }
}

}  // namespace

// A baguette in its open paper sleeve, standing in a basket or lying on a shelf.
Result<ProductModel> make_baguette_bag(const catalog::Product& product) {
  MARKETGEN_TRY(PackBuilder pack, start_pack(product));
  const std::uint16_t print = pack.add_print(matt_paper_roughness);
  const std::uint16_t inside = pack.add_surface(paper({0.72F, 0.62F, 0.48F}));
  const std::uint16_t bread = pack.add_surface({.color = crust, .roughness = 0.7F});
  const std::uint16_t crumb = pack.add_surface({.color = score, .roughness = 0.85F});
  const WrapForm form = wrap_form_of(product);
  add_paper(pack, form, print, inside);
  add_loaf(pack, form, bread);
  add_scores(pack, form, crumb);
  return pack.finish();
}

CollisionPrimitive collision_baguette_bag(const catalog::Product& product) {
  return box_around(product);
}

}  // namespace marketgen::assets
