// Whether two policies differ on the same episodes: p-values, two-sided.
#pragma once
#include <vector>

namespace marketgen::evaluation {

// Of episodes that only the one policy and only the other solves (McNemar, exact: Edwards,
// Psychometrika 1948). 1 when both are 0.
double mcnemar_exact(int only_first, int only_second);

constexpr int sign_flip_draws = 10'000;

// Of the sums of differences in each store, which have no sign of their own when the policies are
// alike (permutation by clusters). All signs are gone through where there are at most
// sign_flip_draws; else so many are drawn from one fixed stream, the measured one counted among
// them. So n stores give no p below 2 / 2^n. 1 of no stores.
double sign_flip_test(const std::vector<double>& differences);

// The p-values of several tests, each corrected for how many there are (Holm, Scandinavian Journal
// of Statistics 6, 1979): of true hypotheses any is rejected with at most the probability that is
// asked for. In the same order; at most 1.
std::vector<double> holm(const std::vector<double>& p);

}  // namespace marketgen::evaluation
