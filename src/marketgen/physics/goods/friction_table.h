// How two contact materials rub: the rows of data/friction.json as a table.
//
// A pair without a row of its own takes the geometric mean of what each has on painted steel, the
// surface that every material has a row for. (The usual mixing rule of rigid-body engines; exact
// when the two rub each other as much as each rubs the reference.)
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/product.h"
#include "catalog/rows.h"

namespace marketgen::physics {

// Contact materials of what is no product.
constexpr std::string_view reference_material = "steel";  // painted: shelves, fixtures
constexpr std::string_view belt_material = "rubber";
constexpr std::string_view room_material = "tile";  // floor, walls, columns

class FrictionTable {
 public:
  using Material = std::uint16_t;
  static constexpr Material unknown = 0;

  explicit FrictionTable(const std::vector<catalog::FrictionRow>& rows);

  Material material(std::string_view name) const;  // unknown when no row has it
  // Sliding friction; 0 when one of the two is unknown, or has no row of its own and none on steel.
  double sliding(Material a, Material b) const { return table_[a * names_.size() + b]; }
  // Of a product on `a`; by the product's own figure when the table has none.
  double sliding_on(Material a, const catalog::Product& product) const;

 private:
  double& at(Material a, Material b) { return table_[a * names_.size() + b]; }

  std::map<std::string, Material, std::less<>> names_;
  std::vector<double> table_;
};

}  // namespace marketgen::physics
