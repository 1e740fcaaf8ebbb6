#include "assets/shapes/archetypes/pack_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/loft.h"

namespace marketgen::assets {
namespace {

constexpr float sine_45_deg = 0.70710678F;

Vec3f size_of(const catalog::Product& product) {
  return {static_cast<float>(product.width_m()),
          static_cast<float>(product.depth_m()),
          static_cast<float>(product.height_m())};
}

// The loft's axis along X; its front towards the shopper, upwards, or half way between.
PartFrame lying_frame(Vec3f size, float up, float forward) {
  return {.origin = {-size.x / 2, 0, size.z / 2},
          .x = {0, -up, -forward},
          .y = {0, forward, -up},
          .z = {1, 0, 0}};
}

void lay_along_x(WrapForm& form, Vec3f size) {
  const bool up = size.z <= size.y;
  form.length_m = size.x;
  form.half_across_m = (up ? size.y : size.z) / 2;
  form.half_thick_m = (up ? size.z : size.y) / 2;
  form.frame = up ? lying_frame(size, 1, 0) : lying_frame(size, 0, 1);
}

WrapForm flow_pack_form(Vec3f size) {
  WrapForm form;
  lay_along_x(form, size);
  form.half_across_m *= flow_body_share;
  form.roundness = 0.42F;
  form.print_to_m = form.length_m;
  return form;
}

// Gathered and clipped at both ends, printed between.
WrapForm chub_form(Vec3f size) {
  WrapForm form;
  lay_along_x(form, size);
  const bool round = std::abs(size.y - size.z) < 0.1F * std::max(size.y, size.z);
  if (round) form.frame = lying_frame(size, sine_45_deg, sine_45_deg);
  form.print_from_m =
      std::min(0.16F * size.x, 0.75F * std::min(form.half_across_m, form.half_thick_m));
  form.print_to_m = size.x - form.print_from_m;
  return form;
}

WrapForm baguette_form(Vec3f size) {
  WrapForm form;
  if (size.z > size.x) {
    form = {.length_m = size.z,
            .half_across_m = size.x / 2,
            .half_thick_m = size.y / 2,
            .standing = true,
            .frame = {}};
  } else {
    lay_along_x(form, size);
  }
  form.roundness = 0.85F;
  form.print_to_m = 0.74F * form.length_m;  // the rest of the loaf looks out
  return form;
}

FaceSize wrapped_face_of(const catalog::Product& product) {
  const WrapForm form = wrap_form_of(product);
  const Section section{.half_width = form.half_across_m,
                        .half_depth = form.half_thick_m,
                        .roundness = form.roundness};
  const float along = form.print_to_m - form.print_from_m, across = label_width(section, 1);
  return form.standing ? FaceSize{across, along} : FaceSize{along, across};
}

// The number that the net quantity starts with: "8 rolls", "6 x 0.5 l"; 0 when it says none.
int pieces_in(const catalog::Product& product) {
  return std::atoi(product.net.c_str());
}

// Rolls stand in the rows and layers whose rolls have the most ordinary shape.
FilmForm roll_rows(const catalog::Product& product, Vec3f size) {
  constexpr float usual_height_share = 0.95F;  // height of a toilet roll over its width
  constexpr int max_along = 6, max_high = 4, max_upright = 12;
  const int wanted = pieces_in(product);
  FilmForm best;
  float least = 1e9F;
  for (int across = 1; across <= max_along; ++across) {
    for (int deep = 1; deep <= max_along && across * deep <= max_upright; ++deep) {
      for (int high = 1; high <= max_high; ++high) {
        const float w = size.x / static_cast<float>(across), d = size.y / static_cast<float>(deep);
        const float h = size.z / static_cast<float>(high);
        const float oval = std::abs(std::log(w / d));
        const float tall = std::abs(std::log(h / (usual_height_share * std::min(w, d))));
        const float count = wanted > 0 && across * deep * high != wanted ? 10.0F : 0.0F;
        const float big = std::abs(std::log(std::min(w, d) / 0.115F));  // rolls are 10 to 13 cm
        const float unusual = 3 * oval + 0.4F * tall + 0.6F * big + count;
        if (unusual >= least) continue;
        least = unusual;
        best = {.across = across, .deep = deep, .high = high};
      }
    }
  }
  return best;
}

float piece_radius(const FilmForm& form, Vec3f size) {
  return 0.5F *
         std::min(size.x / static_cast<float>(form.across), size.y / static_cast<float>(form.deep));
}

}  // namespace

WrapForm wrap_form_of(const catalog::Product& product) {
  const Vec3f size = size_of(product);
  if (product.archetype == "flow_pack") return flow_pack_form(size);
  if (product.archetype == "chub") return chub_form(size);
  return baguette_form(size);
}

FlatForm flat_form_of(const catalog::Product& product) {
  const Vec3f size = size_of(product);
  if (size.y <= size.z) return {size, {}};
  return {
      {size.x, size.z, size.y},
      {.origin = {0, -size.y / 2, size.z / 2}, .x = {1, 0, 0}, .y = {0, 0, -1}, .z = {0, 1, 0}}};
}

bool is_film_pack(const catalog::Product& product) {
  return product.archetype == "can_six_pack" || product.archetype == "bottle_six_pack" ||
         product.archetype == "roll_pack";
}

FilmForm film_form_of(const catalog::Product& product) {
  const Vec3f size = size_of(product);
  FilmForm form{.across = size.x >= size.y ? 3 : 2, .deep = size.x >= size.y ? 2 : 3};
  if (product.archetype == "roll_pack") form = roll_rows(product, size);
  form.high_m = size.z;
  if (product.archetype == "can_six_pack") form.high_m = 0.90F * size.z;
  if (product.archetype == "bottle_six_pack") form.high_m = 0.60F * size.z;
  form.piece_radius_m = piece_radius(form, size);
  const float corners_cut = (8 - 2 * std::numbers::pi_v<float>)*form.piece_radius_m;
  form.girth_share = 1 - corners_cut / (2 * (size.x + size.y));
  return form;
}

FaceSize crate_face_of(float width_m, float height_m) {
  return {(1 - 2.1F * crate_post_share) * width_m,
          (crate_wall_high - 2.05F * crate_bar_share) * height_m};
}

SoftForm soft_form_of(const catalog::Product& product) {
  constexpr float greatest_edge_m = 0.022F, greatest_fin_m = 0.004F, greatest_lid_m = 0.006F;
  const Vec3f size = size_of(product);
  SoftForm form;
  form.fin_m = std::min(greatest_fin_m, 0.04F * size.x);
  if (size.z < size.y) form.lid_m = std::min(greatest_lid_m, 0.10F * size.z);  // wipes lie
  form.size = {size.x - 2 * form.fin_m, size.y, size.z - 0.45F * form.lid_m};
  form.edge_m =
      std::min(greatest_edge_m, 0.24F * std::min({form.size.x, form.size.y, form.size.z}));
  return form;
}

FaceSize front_face_of(const catalog::Product& product) {
  const std::string_view archetype = product.archetype;
  const Vec3f size = size_of(product);
  if (archetype == "flow_pack" || archetype == "chub" || archetype == "baguette_bag")
    return wrapped_face_of(product);
  if (archetype == "vacuum_pack" || archetype == "sachet") {
    const Vec3f flat = flat_form_of(product).size;
    return {flat.x, flat.z};
  }
  if (archetype == "blister") return {size.x, (blister_print_high - blister_bubble_high) * size.z};
  if (archetype == "net_bag") return {size.x, (1 - net_header_low) * size.z};
  return {size.x, size.z};
}

SleeveFaces sleeve_faces_of(const catalog::Product& product) {
  const Vec3f size = size_of(product);
  if (product.archetype == "sardine_tin") {
    const LabelZone zone = label_zone_of(product);
    return {{zone.lid_share * size.x, zone.lid_share * size.y},
            {zone.face_width_m, zone.high_m - zone.low_m}};
  }
  if (product.archetype == "cheese_wedge")
    return {{0.54F * size.x, 0.36F * size.y}, {0.62F * size.x, 0.62F * size.z}};
  if (product.archetype == "egg_box")
    return {{0.80F * size.x, 0.56F * size.y}, {0.72F * size.x, 0.27F * size.z}};
  return {{size.x, size.y}, {size.x, size.z}};
}

}  // namespace marketgen::assets
