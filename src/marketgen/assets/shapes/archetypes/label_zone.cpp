#include "assets/shapes/archetypes/label_zone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/shapes/archetypes/loft.h"

namespace marketgen::assets {
namespace {

// One row per printed round or oval pack. Margins are shares of the height, but never more than the
// given millimetres: ends, rims and lids do not grow with the pack.
struct ZoneRow {
  std::string_view archetype;
  float bottom_share, bottom_max_mm;
  float top_share, top_max_mm;
  float width_share;     // of the pack's width in the middle of the band
  float oval_roundness;  // of the cross-section when the footprint is not round
  float arc = 1;         // less: the section is `oval_roundness` whatever the footprint
  float lid_share = 1;
};

constexpr ZoneRow zone_rows[] = {
    {"can", 0.08F, 7, 0.14F, 13, 1.0F, 1.0F},
    {"food_tin", 0.08F, 3.2F, 0.08F, 3.2F, 1.0F, 0.35F},
    {"soda_bottle", 0.34F, 140, 0.40F, 140, 1.0F, 0.6F},
    {"water_bottle", 0.38F, 150, 0.36F, 130, 1.0F, 0.6F},
    {"wine_bottle", 0.13F, 45, 0.50F, 170, 1.0F, 1.0F},
    {"beer_bottle", 0.13F, 40, 0.52F, 150, 1.0F, 1.0F},
    {"sauce_bottle", 0.12F, 40, 0.40F, 130, 1.0F, 0.8F},
    {"jar", 0.10F, 14, 0.28F, 34, 1.0F, 0.5F},
    {"tub", 0.05F, 6, 0.16F, 14, 0.93F, 0.35F},
    {"flask", 0.10F, 25, 0.34F, 90, 1.0F, 0.75F},
    {"tube", 0.26F, 60, 0.09F, 16, 1.0F, 1.0F},
    {"slim_can", 0.07F, 8, 0.13F, 15, 1.0F, 1.0F},
    {"sardine_tin", 0.22F, 5, 0.22F, 5, 0.97F, 0.45F, 0.30F, 0.915F},
    {"flat_tin", 0.10F, 3.2F, 0.12F, 3.6F, 1.0F, 0.35F, 1, 0.90F},
    {"round_tin", 0.05F, 2.0F, 0.28F, 16, 0.985F, 0.3F, 1, 0.93F},
    {"canister", 0.03F, 5, 0.10F, 17, 0.975F, 0.5F},
    {"spirit_bottle", 0.13F, 35, 0.46F, 122, 1.0F, 0.35F},
    {"oil_bottle", 0.15F, 45, 0.50F, 150, 1.0F, 0.6F},
    {"aerosol", 0.035F, 5, 0.33F, 64, 0.98F, 0.8F},
    {"cream_jar", 0.12F, 6, 0.46F, 24, 0.97F, 0.5F, 1, 0.84F},
    {"yogurt_cup", 0.08F, 7, 0.07F, 6, 0.83F, 0.4F, 1, 0.98F},
    {"squeeze_bottle", 0.27F, 52, 0.20F, 40, 1.0F, 0.85F, 0.60F},
    {"milk_jug", 0.10F, 26, 0.54F, 810, 1.0F, 0.5F, 0.30F},
    {"jerrycan", 0.12F, 42, 0.42F, 630, 1.0F, 0.3F, 0.0F},
    {"detergent_bottle", 0.10F, 30, 0.50F, 750, 1.0F, 0.62F, 0.50F},
    {"spray_bottle", 0.09F, 24, 0.52F, 780, 1.0F, 0.85F, 0.60F},
    {"pump_bottle", 0.08F, 16, 0.44F, 660, 1.0F, 0.85F, 0.60F},
    {"stick", 0.18F, 21, 0.46F, 55, 1.0F, 0.8F, 0.60F},
};

const ZoneRow& zone_row_of(std::string_view archetype) {
  for (const ZoneRow& row : zone_rows) {
    if (row.archetype == archetype) return row;
  }
  return zone_rows[0];
}

float section_perimeter(float width, float depth, float roundness) {
  return roundness * ellipse_perimeter(width, depth) + (1.0F - roundness) * 2.0F * (width + depth);
}

}  // namespace

float ellipse_perimeter(float width, float depth) {
  const double a = width / 2.0, b = depth / 2.0;
  return static_cast<float>(std::numbers::pi *
                            (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b))));
}

bool is_round_footprint(const catalog::Product& product) {
  const int w = product.size_mm[0], d = product.size_mm[1];
  return 10 * std::abs(w - d) <= std::max(w, d);
}

LabelZone label_zone_of(const catalog::Product& product) {
  const ZoneRow& row = zone_row_of(product.archetype);
  const auto height = static_cast<float>(product.height_m());
  const bool always_oval = row.archetype == "flask" || row.arc < 1;
  LabelZone zone;
  zone.low_m = std::min(row.bottom_share * height, row.bottom_max_mm * 1e-3F);
  zone.high_m = height - std::min(row.top_share * height, row.top_max_mm * 1e-3F);
  zone.roundness = is_round_footprint(product) && !always_oval ? 1.0F : row.oval_roundness;
  auto width = row.width_share * static_cast<float>(product.width_m());
  auto depth = row.width_share * static_cast<float>(product.depth_m());
  if (row.archetype == "tube") {  // half way from the round end, as wide as deep, to the flat one
    width = (width + std::min(width, depth)) / 2;
    depth /= 2;
  }
  zone.perimeter_m = section_perimeter(width, depth, zone.roundness);
  zone.arc = row.arc;
  const Section section{
      .half_width = width / 2, .half_depth = depth / 2, .roundness = zone.roundness};
  zone.face_width_m = row.arc < 1 ? label_width(section, row.arc) : zone.perimeter_m / 2;
  zone.lid_share = row.lid_share;
  return zone;
}

GableRoof gable_roof_of(const catalog::Product& product) {
  const auto height = static_cast<float>(product.height_m());
  const float half_depth = static_cast<float>(product.depth_m()) / 2.0F;
  GableRoof roof;
  roof.fin_m = std::min(0.014F, 0.10F * height);       // a sealed fin is 10 to 15 mm high
  roof.rise_m = std::min(half_depth, 0.25F * height);  // slopes of up to 45 degrees
  roof.body_m = height - roof.rise_m - roof.fin_m;
  roof.slope_m = std::sqrt(half_depth * half_depth + roof.rise_m * roof.rise_m);
  return roof;
}

}  // namespace marketgen::assets
