// How many episodes are needed to tell two policies apart: at 80 % power and 5 % error, two-sided,
// with episodes of a store as alike as was measured.
#pragma once
#include <array>
#include <vector>

#include "base/fields.h"
#include "evaluation/store_bootstrap.h"

namespace marketgen::evaluation {

constexpr std::array<double, 4> told_differences{0.02, 0.05, 0.10, 0.20};

struct PowerRow {
  double difference = 0;
  int episodes = 0, stores = 0;
  static constexpr auto fields = field_list(
      field("difference", &PowerRow::difference, "of the shares of strict successes, 0..1"),
      field("episodes", &PowerRow::episodes, "that each policy has to run"),
      field("stores", &PowerRow::stores, "that these are of, as many in each as were measured"));
};

// How alike the episodes of a store are, 0..1: the share of the variance that is between stores
// (intraclass correlation by analysis of variance; Donner, International Statistical Review 1986).
// `score` of weight 1. 0 where it cannot be measured: one store, or one episode a store.
double likeness_in_stores(const std::vector<ScoredEpisode>& episodes);

// What a table is made for: episodes a store, which are `likeness` alike.
struct StoreSampling {
  double episodes_per_store = 1, likeness = 0;
};
StoreSampling sampling_of(const std::vector<ScoredEpisode>& episodes);

// Of two policies that run episodes of their own, one of which reaches `share` (Fleiss,
// "Statistical Methods for Rates and Proportions", 1981, without correction for continuity). The
// other is that much better or worse, whichever takes more episodes.
std::vector<PowerRow> power_of_two_runs(double share, const StoreSampling& sampling);
// Of two that run the same episodes, `discordant` of which only one of them solves (Connor,
// Biometrics 1987). `sampling` is that of the differences.
std::vector<PowerRow> power_of_pairs(double discordant, const StoreSampling& sampling);

}  // namespace marketgen::evaluation
