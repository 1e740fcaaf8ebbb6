#include "perception/rivals.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace marketgen::perception {
namespace {

struct Likeness {
  double min_share = 0, max_share = 0;  // of each side
  std::size_t most = 0;
  bool same_category = false;
};
constexpr Likeness much_its_size{0.7, 1.3, 20, true}, as_large_or_larger{0.7, 2.5, 150, false};

std::vector<const catalog::Product*> most_alike(const catalog::Product& product,
                                                const std::vector<catalog::Product>& rows,
                                                const Likeness& likeness) {
  std::vector<std::pair<double, const catalog::Product*>> alike;
  for (const catalog::Product& other : rows) {
    if (product.sku == other.sku) continue;
    if (likeness.same_category && product.category != other.category) continue;
    double off = 0;
    bool fits = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = 1.0 * other.size_mm[axis] / product.size_mm[axis];
      fits = fits && share >= likeness.min_share && share <= likeness.max_share;
      off = std::max(off, std::abs(share - 1));
    }
    if (fits) alike.emplace_back(off, &other);
  }
  std::ranges::sort(alike, {}, [](const auto& entry) {
    return std::pair<double, std::string_view>(entry.first, entry.second->sku);
  });
  std::vector<const catalog::Product*> rivals;
  for (std::size_t i = 0; i < std::min(likeness.most, alike.size()); ++i)
    rivals.push_back(alike[i].second);
  return rivals;
}

}  // namespace

std::vector<const catalog::Product*> rivals_of(const catalog::Product& product,
                                               const std::vector<catalog::Product>& rows) {
  return most_alike(product, rows, much_its_size);
}

std::vector<const catalog::Product*> rivals_of_any_kind(const catalog::Product& product,
                                                        const std::vector<catalog::Product>& rows) {
  return most_alike(product, rows, as_large_or_larger);
}

}  // namespace marketgen::perception
