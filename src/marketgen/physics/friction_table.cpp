#include "physics/friction_table.h"

namespace marketgen {

FrictionTable::FrictionTable(const std::vector<FrictionRow>& rows) {
  names_.emplace("", unknown);
  for (const FrictionRow& row : rows) {
    for (const std::string& name : {row.a, row.b})
      names_.emplace(name, static_cast<Material>(names_.size()));
  }
  table_.assign(names_.size() * names_.size(), 0);
  for (const FrictionRow& row : rows) {
    const std::size_t a = names_.at(row.a), b = names_.at(row.b);
    table_[a * names_.size() + b] = table_[b * names_.size() + a] = row.sliding;
  }
}

FrictionTable::Material FrictionTable::material(const std::string& name) const {
  const auto at = names_.find(name);
  return at == names_.end() ? unknown : at->second;
}

}  // namespace marketgen
