#include "physics/goods/friction_table.h"

#include <cmath>

namespace marketgen::physics {

FrictionTable::FrictionTable(const std::vector<catalog::FrictionRow>& rows) {
  names_.emplace("", unknown);
  for (const catalog::FrictionRow& row : rows) {
    for (const std::string& name : {row.a, row.b})
      names_.emplace(name, static_cast<Material>(names_.size()));
  }
  table_.assign(names_.size() * names_.size(), 0);
  for (const catalog::FrictionRow& row : rows) {
    const Material a = material(row.a), b = material(row.b);
    at(a, b) = at(b, a) = row.sliding;
  }
  const Material reference = material(reference_material);
  if (reference == unknown) return;
  const auto count = static_cast<Material>(names_.size());
  std::vector<double> on_reference;
  for (Material a = 0; a < count; ++a)
    on_reference.push_back(at(a, reference));
  for (Material a = 0; a < count; ++a) {
    for (Material b = 0; b < count; ++b) {
      if (at(a, b) == 0) at(a, b) = std::sqrt(on_reference[a] * on_reference[b]);
    }
  }
}

FrictionTable::Material FrictionTable::material(std::string_view name) const {
  const auto found = names_.find(name);
  return found == names_.end() ? unknown : found->second;
}

double FrictionTable::sliding_on(Material a, const catalog::Product& product) const {
  const double known = sliding(a, material(product.material));
  return known > 0 ? known : product.friction;
}

}  // namespace marketgen::physics
