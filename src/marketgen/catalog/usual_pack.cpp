#include "catalog/usual_pack.h"

#include <algorithm>
#include <functional>
#include <map>

namespace marketgen::catalog {
namespace {

// Empty when no row is alike.
std::string max_common(const std::vector<Product>& rows,
                       const std::function<bool(const Product&)>& alike) {
  std::map<std::string, int> votes;
  for (const Product& row : rows) {
    if (alike(row)) ++votes[row.material];
  }
  const auto most = std::ranges::max_element(
      votes, [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? std::string() : most->first;
}

}  // namespace

std::string usual_material(const std::vector<Product>& rows, const Product& product) {
  const auto same_shape = [&](const Product& row) { return row.archetype == product.archetype; };
  const auto same_category = [&](const Product& row) { return row.category == product.category; };
  const auto same_subcategory = [&](const Product& row) {
    return same_category(row) && row.subcategory == product.subcategory;
  };
  for (const std::function<bool(const Product&)>& alike :
       {std::function<bool(const Product&)>(same_shape),
        std::function<bool(const Product&)>(same_subcategory),
        std::function<bool(const Product&)>(same_category)}) {
    if (std::string found = max_common(rows, alike); !found.empty()) return found;
  }
  return "cardboard";
}

const FrictionRow* friction_on_steel(const std::vector<FrictionRow>& rows,
                                     std::string_view material) {
  const auto found = std::ranges::find_if(rows, [&](const FrictionRow& row) {
    return (row.a == material && row.b == "steel") || (row.b == material && row.a == "steel");
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace marketgen::catalog
