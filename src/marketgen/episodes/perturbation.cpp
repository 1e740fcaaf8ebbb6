#include "episodes/perturbation.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

namespace marketgen::episodes {

Pose Perturbation::moved(const Pose& pose, std::string_view thing, double share) const {
  Stream draw = seed_.child("place", thing).stream();
  const double most = sizes_.place_m, max_turn = sizes_.turn_deg * std::numbers::pi / 180;
  const double x = draw.uniform(-most, most), y = draw.uniform(-most, most);
  const double turn = draw.uniform(-max_turn, max_turn);
  return {pose.position + Vec3{share * x, share * y, 0},
          rotation_about({0, 0, 1}, share * turn) * pose.rotation};
}

std::vector<catalog::FrictionRow> Perturbation::frictions(
    std::vector<catalog::FrictionRow> rows) const {
  for (catalog::FrictionRow& row : rows) {
    const auto& [first, second] = std::minmax(row.a, row.b);
    Stream draw = seed_.child("friction", fmt::format("{} {}", first, second)).stream();
    row.sliding *= 1 + draw.uniform(-sizes_.friction, sizes_.friction);
  }
  return rows;
}

std::vector<double> Perturbation::mass_factors(
    const std::vector<catalog::Product>& products) const {
  std::vector<double> factors;
  for (const catalog::Product& product : products)
    factors.push_back(1 +
                      seed_.child("mass", product.sku).stream().uniform(-sizes_.mass, sizes_.mass));
  return factors;
}

std::optional<Perturbation> perturbation_of(const PerturbationSizes& sizes, Seed seed) {
  const bool any = sizes.place_m > 0 || sizes.turn_deg > 0 || sizes.friction > 0 || sizes.mass > 0;
  return any ? std::optional<Perturbation>(std::in_place, sizes, seed) : std::nullopt;
}

}  // namespace marketgen::episodes
