#include "assets/import/asset_estimates.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "catalog/usual_pack.h"

namespace marketgen::assets {
namespace {

constexpr double filled_share = 0.8;  // pi / 4 for round packs, nearly 1 for cartons
constexpr std::size_t enough_rows = 3;
constexpr double usual_friction = 0.35;                  // cardboard on steel
constexpr double min_mass_kg = 0.001, max_mass_kg = 50;  // limits of Product::fields

double box_density(const catalog::Product& p) {
  return p.mass_kg / (p.width_m() * p.depth_m() * p.height_m());
}

std::vector<double> densities_where(const catalog::Catalog& catalog,
                                    const std::function<bool(const catalog::Product&)>& like) {
  std::vector<double> list;
  for (const catalog::Product& p : catalog.products) {
    if (like(p)) list.push_back(box_density(p));
  }
  std::sort(list.begin(), list.end());
  return list;
}

Estimate mass_at(const std::vector<double>& densities, double volume_m3, const std::string& who) {
  const double density = densities[densities.size() / 2] / filled_share;
  return {std::clamp(density * volume_m3, min_mass_kg, max_mass_kg),
          fmt::format("{:.0f} kg/m3, the median of {} rows {}", density, densities.size(), who)};
}

}  // namespace

Estimate estimated_mass(const catalog::Product& product,
                        double volume_m3,
                        const catalog::Catalog& catalog) {
  const auto alike = densities_where(catalog, [&](const catalog::Product& p) {
    return p.subcategory == product.subcategory && p.material == product.material;
  });
  if (alike.size() >= enough_rows)
    return mass_at(alike, volume_m3, "of " + product.subcategory + " in " + product.material);
  const auto same_material = densities_where(
      catalog, [&](const catalog::Product& p) { return p.material == product.material; });
  if (same_material.size() >= enough_rows)
    return mass_at(same_material, volume_m3, "in " + product.material);
  const auto all = densities_where(catalog, [](const catalog::Product&) { return true; });
  if (!all.empty()) return mass_at(all, volume_m3, "of the whole catalogue");
  return {std::clamp(1000 * volume_m3, min_mass_kg, max_mass_kg), "that of water"};
}

Estimate estimated_friction(const std::string& material, const catalog::Catalog& catalog) {
  if (const catalog::FrictionRow* row = catalog::friction_on_steel(catalog.frictions, material))
    return {row->sliding, row->a + " on " + row->b + ": " + row->source};
  return {usual_friction, "no row for " + material + " on steel: that of cardboard"};
}

}  // namespace marketgen::assets
