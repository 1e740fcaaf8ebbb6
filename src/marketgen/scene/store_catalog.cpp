#include "scene/store_catalog.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace marketgen::scene {
namespace {

// Goods that are piled as high as `pile_m`, `min_layers` to `max_layers` on one another.
// Seen in shops; no source.
struct Pile {
  std::string_view archetype;
  double pile_m;
  int min_layers, max_layers;
};
constexpr std::array piles{Pile{"loaf", 0.24, 1, 3},
                           Pile{"baguette_bag", 0.20, 1, 3},
                           Pile{"banana_bunch", 0.20, 2, 2},
                           Pile{"grapes", 0.20, 2, 2},
                           Pile{"leek", 0.16, 2, 4},
                           Pile{"spring_onions", 0.16, 2, 4},
                           Pile{"celery", 0.17, 2, 3},
                           Pile{"radish_bunch", 0.19, 2, 3},
                           Pile{"asparagus_bunch", 0.20, 2, 3},
                           Pile{"herb_bunch", 0.15, 2, 3}};

// How many of the product lie on one another, at most.
int piled_max(const catalog::Product& product) {
  const auto found = std::ranges::find(piles, product.archetype, &Pile::archetype);
  if (found == piles.end()) return product.stack_max;
  const int high = static_cast<int>(found->pile_m / product.height_m());
  return std::max(product.stack_max, std::clamp(high, found->min_layers, found->max_layers));
}

}  // namespace

StoreCatalog::StoreCatalog(const catalog::Catalog& rows, const plan::Plan& plan)
    : local_(rows, plan.country) {
  if (plan.shelves != plan::ShelfPitch::fitted) return;
  const auto changes = [&](const catalog::Product& product) {
    return piled_max(product) != product.stack_max &&
           !std::ranges::binary_search(rows.own, product.sku);
  };
  // Who has such rows already asks again for a part of a store: thousands of rows are not copied.
  if (std::ranges::none_of(local_.get().products, changes)) return;
  piled_ = local_.get();
  for (catalog::Product& product : piled_->products)
    if (changes(product)) product.stack_max = piled_max(product);
}

}  // namespace marketgen::scene
