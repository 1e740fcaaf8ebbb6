#include "assets/print/label_sheet.h"

#include <algorithm>
#include <numbers>

#include "assets/shapes/archetypes/fruit.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "assets/shapes/archetypes/pack_faces.h"
#include "assets/shapes/archetypes/registry.h"

namespace marketgen::assets {
namespace {

struct SheetRow {
  std::string_view archetype;
  SheetKind kind;
};

constexpr SheetRow sheet_rows[] = {
    {"can", SheetKind::band},
    {"food_tin", SheetKind::band},
    {"soda_bottle", SheetKind::band},
    {"water_bottle", SheetKind::band},
    {"wine_bottle", SheetKind::band},
    {"beer_bottle", SheetKind::band},
    {"sauce_bottle", SheetKind::band},
    {"flask", SheetKind::front_back},
    {"gable_carton", SheetKind::carton},
    {"brick_carton", SheetKind::carton},
    {"box", SheetKind::carton},
    {"jar", SheetKind::band},
    {"tub", SheetKind::band_lid},
    {"pouch", SheetKind::front_back},
    {"pillow_bag", SheetKind::front_back},
    {"paper_bag", SheetKind::front_back},
    {"tray", SheetKind::sleeve},
    {"loaf", SheetKind::carton},
    {"bundle", SheetKind::carton},
    {"tube", SheetKind::front_back},
    {"slim_can", SheetKind::band},
    {"flat_tin", SheetKind::band_lid},
    {"sardine_tin", SheetKind::sleeve},
    {"round_tin", SheetKind::band_lid},
    {"canister", SheetKind::band},
    {"spirit_bottle", SheetKind::band},
    {"oil_bottle", SheetKind::band},
    {"squeeze_bottle", SheetKind::front_back},
    {"milk_jug", SheetKind::front_back},
    {"jerrycan", SheetKind::front_back},
    {"detergent_bottle", SheetKind::front_back},
    {"spray_bottle", SheetKind::front_back},
    {"pump_bottle", SheetKind::front_back},
    {"aerosol", SheetKind::band},
    {"stick", SheetKind::front_back},
    {"cream_jar", SheetKind::band_lid},
    {"yogurt_cup", SheetKind::band_lid},
    {"flow_pack", SheetKind::front_back},
    {"vacuum_pack", SheetKind::front_back},
    {"chub", SheetKind::front_back},
    {"meat_tray", SheetKind::sleeve},
    {"cheese_wedge", SheetKind::sleeve},
    {"foil_brick", SheetKind::carton},
    {"egg_box", SheetKind::sleeve},
    {"net_bag", SheetKind::front_back},
    {"can_six_pack", SheetKind::carton},
    {"bottle_six_pack", SheetKind::carton},
    {"crate", SheetKind::carton},
    {"roll_pack", SheetKind::carton},
    {"blister", SheetKind::front_back},
    {"sachet", SheetKind::front_back},
    {"soft_pack", SheetKind::carton},
    {"baguette_bag", SheetKind::front_back},
    {"round_produce", SheetKind::skin},
    {"elongated_produce", SheetKind::skin},
    {"leafy_produce", SheetKind::skin},
    {"apple", SheetKind::skin},
    {"pear", SheetKind::skin},
    {"citrus", SheetKind::skin},
    {"peach", SheetKind::skin},
    {"plum", SheetKind::skin},
    {"mango", SheetKind::skin},
    {"avocado", SheetKind::skin},
    {"kiwi", SheetKind::skin},
    {"melon", SheetKind::skin},
    {"watermelon", SheetKind::skin},
    {"coconut", SheetKind::skin},
    {"tomato", SheetKind::skin},
    {"bell_pepper", SheetKind::skin},
    {"potato", SheetKind::skin},
    {"onion", SheetKind::skin},
    {"garlic", SheetKind::skin},
    {"pumpkin", SheetKind::skin},
    {"beetroot", SheetKind::skin},
    {"chili", SheetKind::skin},
    {"cucumber", SheetKind::skin},
    {"courgette", SheetKind::skin},
    {"aubergine", SheetKind::skin},
    {"carrot", SheetKind::skin},
    {"sweet_potato", SheetKind::skin},
    {"banana_bunch", SheetKind::skin},
    {"pineapple", SheetKind::skin},
    {"grapes", SheetKind::skin},
    {"strawberry_punnet", SheetKind::skin},
    {"mushroom_punnet", SheetKind::skin},
    {"leek", SheetKind::skin},
    {"spring_onions", SheetKind::skin},
    {"celery", SheetKind::skin},
    {"broccoli", SheetKind::skin},
    {"cauliflower", SheetKind::skin},
    {"cabbage", SheetKind::skin},
    {"lettuce_head", SheetKind::skin},
    {"corn_cob", SheetKind::skin},
    {"radish_bunch", SheetKind::skin},
    {"asparagus_bunch", SheetKind::skin},
    {"ginger", SheetKind::skin},
    {"fennel", SheetKind::skin},
    {"herb_bunch", SheetKind::skin},
    {"bread_roll", SheetKind::skin},
    {"croissant", SheetKind::skin},
    {"pretzel", SheetKind::skin},
    {"donut", SheetKind::skin},
    {"muffin", SheetKind::skin},
    {"round_bread", SheetKind::skin},
};

// Of the gable's `top` panel the two slopes take this share; the fin has the rest.
constexpr float gable_slopes_share = 0.9F;

// A panel placed on the sheet in metres from its upper left corner.
struct Placed {
  PanelKind kind;
  float x, y, width, height;
};

struct MetricSheet {
  SheetSize size;
  std::vector<Placed> panels;
};

MetricSheet single_panel(PanelKind kind, float width, float height) {
  return {{width, height}, {{kind, 0, 0, width, height}}};
}

MetricSheet carton_sheet(float w, float d, float body, float top) {
  return {{2 * (w + d), body + top},
          {{PanelKind::front, 0, top, w, body},
           {PanelKind::right, w, top, d, body},
           {PanelKind::back, w + d, top, w, body},
           {PanelKind::left, 2 * w + d, top, d, body},
           {PanelKind::top, 0, 0, w, top},
           {PanelKind::bottom, w + d, top - d, w, d}}};
}

MetricSheet front_back_sheet(float width, float height) {
  return {{2 * width, height},
          {{PanelKind::front, 0, 0, width, height}, {PanelKind::back, width, 0, width, height}}};
}

MetricSheet band_lid_sheet(const LabelZone& zone, float w, float d) {
  const float width = zone.perimeter_m, height = zone.high_m - zone.low_m;
  return {{width, d + height},
          {{PanelKind::band, 0, d, width, height}, {PanelKind::top, (width - w) / 2, 0, w, d}}};
}

MetricSheet sleeve_sheet(const SleeveFaces& faces) {
  const FaceSize top = faces.top, front = faces.front;
  return {{std::max(top.width_m, front.width_m), top.height_m + front.height_m},
          {{PanelKind::top, 0, 0, top.width_m, top.height_m},
           {PanelKind::front, 0, top.height_m, front.width_m, front.height_m}}};
}

// Standing goods unroll about Z, lying ones about X; of a hand of bananas one of them does.
MetricSheet skin_sheet(const catalog::Product& product, float w, float d, float h) {
  if (product.archetype == "banana_bunch") {
    const float thick = banana_thickness * h;
    return single_panel(PanelKind::skin, ellipse_perimeter(thick, thick), w);
  }
  if (lies_along_x(product)) return single_panel(PanelKind::skin, ellipse_perimeter(d, h), w);
  return single_panel(PanelKind::skin, ellipse_perimeter(w, d), ellipse_perimeter(w, h) / 2);
}

MetricSheet front_back_sheet_of(const catalog::Product& product) {
  const LabelZone zone = label_zone_of(product);
  const bool bottle = product.archetype == "flask" || product.archetype == "tube" || zone.arc < 1;
  if (bottle) return front_back_sheet(zone.face_width_m, zone.high_m - zone.low_m);
  const FaceSize face = front_face_of(product);
  return front_back_sheet(face.width_m, face.height_m);
}

MetricSheet carton_sheet_of(const catalog::Product& product, float w, float d, float h) {
  if (product.archetype == "gable_carton") {
    const GableRoof roof = gable_roof_of(product);
    return carton_sheet(w, d, roof.body_m, 2 * roof.slope_m / gable_slopes_share);
  }
  if (is_film_pack(product)) {
    const FilmForm film = film_form_of(product);
    const float depth = film.girth_share * d;
    return carton_sheet(film.girth_share * w, depth, film.high_m, depth);
  }
  if (product.archetype == "soft_pack") {
    const SoftForm soft = soft_form_of(product);
    const float round = (2 - std::numbers::pi_v<float> / 2) * soft.edge_m;  // cut off by both edges
    const float depth = soft.size.y - round;
    return carton_sheet(soft.size.x - round, depth, soft.size.z - round, depth);
  }
  if (product.archetype == "crate") {
    const FaceSize front = crate_face_of(w, h), side = crate_face_of(d, h);
    return carton_sheet(front.width_m, side.width_m, front.height_m, side.width_m);
  }
  return carton_sheet(w, d, h, d);
}

MetricSheet metric_sheet(SheetKind kind, const catalog::Product& product) {
  const auto w = static_cast<float>(product.width_m());
  const auto d = static_cast<float>(product.depth_m());
  const auto h = static_cast<float>(product.height_m());
  const LabelZone zone = label_zone_of(product);
  switch (kind) {
    case SheetKind::band:
      return single_panel(PanelKind::band, zone.perimeter_m, zone.high_m - zone.low_m);
    case SheetKind::band_lid:
      return band_lid_sheet(zone, zone.lid_share * w, zone.lid_share * d);
    case SheetKind::carton:
      return carton_sheet_of(product, w, d, h);
    case SheetKind::front_back:
      return front_back_sheet_of(product);
    case SheetKind::sleeve:
      return sleeve_sheet(sleeve_faces_of(product));
    case SheetKind::skin:
      return skin_sheet(product, w, d, h);
  }
  return {};
}

Result<MetricSheet> metric_sheet_of(const catalog::Product& product) {
  MARKETGEN_TRY(const SheetKind kind, sheet_kind_of(product.archetype));
  MARKETGEN_CHECK(check_product_size(product));
  return metric_sheet(kind, product);
}

}  // namespace

Result<SheetKind> sheet_kind_of(std::string_view archetype) {
  for (const SheetRow& row : sheet_rows) {
    if (row.archetype == archetype) return row.kind;
  }
  return unknown_archetype(archetype, "archetype");
}

Result<std::vector<Panel>> panels_of(const catalog::Product& product) {
  MARKETGEN_TRY(const MetricSheet sheet, metric_sheet_of(product));
  std::vector<Panel> panels;
  for (const Placed& p : sheet.panels) {
    panels.push_back({p.kind,
                      p.x / sheet.size.width_m,
                      p.y / sheet.size.height_m,
                      (p.x + p.width) / sheet.size.width_m,
                      (p.y + p.height) / sheet.size.height_m,
                      p.width,
                      p.height});
  }
  return panels;
}

Result<SheetSize> sheet_size_of(const catalog::Product& product) {
  MARKETGEN_TRY(const MetricSheet sheet, metric_sheet_of(product));
  return sheet.size;
}

}  // namespace marketgen::assets
