#include "scene/demand.h"

#include <algorithm>
#include <cmath>

#include "base/seed.h"

namespace marketgen::scene {

double demand_of(const catalog::Product& product) {
  constexpr double first_rank = 0.002;  // nothing is asked for more than the first five hundredth
  constexpr double mean_of_ranks = 3.3656;  // 4 - 3 * first_rank^(1/4)
  const double rank =
      std::max(Seed(0).child("popularity", product.sku).stream().uniform(), first_rank);
  const double root = std::sqrt(rank);
  return 1 / (root * std::sqrt(root) * mean_of_ranks);
}

}  // namespace marketgen::scene
