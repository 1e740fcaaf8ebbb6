#include "scene/demand.h"

#include <algorithm>
#include <cmath>

#include "base/seed.h"

namespace marketgen::scene {

double demand_of(const catalog::Product& product) {
  constexpr double first_rank = 0.01;  // nothing is asked for more than the first hundredth
  const double rank = Seed(0).child("popularity", product.sku).stream().uniform();
  return 0.5 / std::sqrt(std::max(rank, first_rank));
}

}  // namespace marketgen::scene
