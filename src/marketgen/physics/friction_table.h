// How two contact materials rub: the rows of data/friction.json as a table.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "catalog/rows.h"

namespace marketgen {

class FrictionTable {
 public:
  using Material = std::uint16_t;
  static constexpr Material unknown = 0;

  explicit FrictionTable(const std::vector<FrictionRow>& rows);

  Material material(const std::string& name) const;  // unknown when no row has it
  // Sliding friction, or 0 when no row has this pair.
  double sliding(Material a, Material b) const { return table_[a * names_.size() + b]; }

 private:
  std::map<std::string, Material> names_;
  std::vector<double> table_;
};

}  // namespace marketgen
