#include "evaluation/paired_tests.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "base/seed.h"

namespace marketgen::evaluation {
namespace {

// Of sums that differ by rounding alone.
constexpr double same_sum = 1e-9;

// As far from 0 as the measured sum, or farther.
bool is_as_far(double sum, double measured) {
  return std::abs(sum) >= std::abs(measured) - same_sum;
}

double sum_with_signs(const std::vector<double>& differences, std::uint64_t minus) {
  double sum = 0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    sum += ((minus >> i) & 1U) != 0 ? -differences[i] : differences[i];
  return sum;
}

double sum_with_drawn_signs(const std::vector<double>& differences, Stream& draw) {
  double sum = 0;
  for (std::size_t i = 0; i < differences.size(); i += 64) {
    const std::size_t end = std::min(differences.size(), i + 64);
    std::uint64_t minus = draw.bits();
    for (std::size_t j = i; j < end; ++j, minus >>= 1)
      sum += (minus & 1U) != 0 ? -differences[j] : differences[j];
  }
  return sum;
}

}  // namespace

double mcnemar_exact(int only_first, int only_second) {
  const int n = only_first + only_second;
  double tail = 0;  // of the binomial distribution with p = 1/2
  for (int k = 0; k <= std::min(only_first, only_second); ++k)
    tail += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) -
                     n * std::log(2.0));
  return std::min(1.0, 2 * tail);
}

double sign_flip_test(const std::vector<double>& differences) {
  const double measured = sum_with_signs(differences, 0);
  const std::uint64_t all = differences.size() < 63 ? std::uint64_t{1} << differences.size() : 0;
  int as_far = 0;
  if (all != 0 && all <= sign_flip_draws) {
    for (std::uint64_t minus = 0; minus < all; ++minus)
      as_far += is_as_far(sum_with_signs(differences, minus), measured) ? 1 : 0;
    return as_far / static_cast<double>(all);
  }
  Stream draw = Seed(1).child("sign_flip_test").stream();
  for (int i = 0; i < sign_flip_draws; ++i)
    as_far += is_as_far(sum_with_drawn_signs(differences, draw), measured) ? 1 : 0;
  return (as_far + 1.0) / (sign_flip_draws + 1.0);
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> corrected(p.size());
  double at_least = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const double tests_left = static_cast<double>(p.size() - rank);
    at_least = std::max(at_least, std::min(1.0, tests_left * p[order[rank]]));
    corrected[order[rank]] = at_least;
  }
  return corrected;
}

}  // namespace marketgen::evaluation
