// Intervals of goals and partial scores, which are no independent draws: those of a store share its
// goods and its light. Whole stores are drawn anew (Davison and Hinkley, "Bootstrap Methods and
// their Application", 1997, section 3.8), so that an interval is as wide as stores differ.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"

namespace marketgen::evaluation {

constexpr int bootstrap_draws = 10'000;

// What an episode adds to a ratio: goals reached of those asked for, or its score of 1.
struct ScoredEpisode {
  std::string store;
  double score = 0, weight = 1;
};

// A ratio of sums with its 95 % interval.
struct Estimate {
  double value = 0, low = 0, high = 0;
  static constexpr auto fields =
      field_list(field("value", &Estimate::value, "as measured"),
                 field("low", &Estimate::low, "95 % interval, bootstrap over stores"),
                 field("high", &Estimate::high, "95 % interval, bootstrap over stores"));
};

// Sums of the episodes that are drawn together: those of a store, or, where all are of one store,
// each by itself, in their order. In the order of the stores' names.
struct Cluster {
  double score = 0, weight = 0;
  int episodes = 0;
};
std::vector<Cluster> clusters_of(const std::vector<ScoredEpisode>& episodes);

// Percentiles of bootstrap_draws draws from one fixed stream: the same episodes, in any order, give
// the same interval. Of no episodes: 0. Where all clusters are alike the interval has no width,
// whatever their number.
Estimate estimate_of(const std::vector<ScoredEpisode>& episodes);
// The mean of several such ratios, each of a list of episodes of its own and drawn by itself.
Estimate estimate_of_mean(const std::vector<std::vector<ScoredEpisode>>& lists);

}  // namespace marketgen::evaluation
