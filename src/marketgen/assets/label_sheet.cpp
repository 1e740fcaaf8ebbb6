#include "assets/label_sheet.h"

#include "assets/archetypes/label_zone.h"
#include "assets/archetypes/registry.h"

namespace marketgen {
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
    {"round_produce", SheetKind::skin},
    {"elongated_produce", SheetKind::skin},
    {"leafy_produce", SheetKind::skin},
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

MetricSheet sleeve_sheet(float w, float d, float h) {
  return {{w, d + h}, {{PanelKind::top, 0, 0, w, d}, {PanelKind::front, 0, d, w, h}}};
}

// Round and leafy goods unroll about Z, long ones about X.
MetricSheet skin_sheet(std::string_view archetype, float w, float d, float h) {
  if (archetype == "elongated_produce")
    return single_panel(PanelKind::skin, ellipse_perimeter(d, h), w);
  return single_panel(PanelKind::skin, ellipse_perimeter(w, d), ellipse_perimeter(w, h) / 2);
}

MetricSheet front_back_sheet_of(const Product& product, float w, float h) {
  if (product.archetype != "flask" && product.archetype != "tube") return front_back_sheet(w, h);
  const LabelZone zone = label_zone_of(product);
  return front_back_sheet(zone.perimeter_m / 2, zone.high_m - zone.low_m);
}

MetricSheet carton_sheet_of(const Product& product, float w, float d, float h) {
  if (product.archetype != "gable_carton") return carton_sheet(w, d, h, d);
  const GableRoof roof = gable_roof_of(product);
  return carton_sheet(w, d, roof.body_m, 2 * roof.slope_m / gable_slopes_share);
}

MetricSheet metric_sheet(SheetKind kind, const Product& product) {
  const auto w = static_cast<float>(product.width_m());
  const auto d = static_cast<float>(product.depth_m());
  const auto h = static_cast<float>(product.height_m());
  const LabelZone zone = label_zone_of(product);
  switch (kind) {
    case SheetKind::band:
      return single_panel(PanelKind::band, zone.perimeter_m, zone.high_m - zone.low_m);
    case SheetKind::band_lid:
      return band_lid_sheet(zone, w, d);
    case SheetKind::carton:
      return carton_sheet_of(product, w, d, h);
    case SheetKind::front_back:
      return front_back_sheet_of(product, w, h);
    case SheetKind::sleeve:
      return sleeve_sheet(w, d, h);
    case SheetKind::skin:
      return skin_sheet(product.archetype, w, d, h);
  }
  return {};
}

Result<MetricSheet> metric_sheet_of(const Product& product) {
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

Result<std::vector<Panel>> panels_of(const Product& product) {
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

Result<SheetSize> sheet_size_of(const Product& product) {
  MARKETGEN_TRY(const MetricSheet sheet, metric_sheet_of(product));
  return sheet.size;
}

}  // namespace marketgen
