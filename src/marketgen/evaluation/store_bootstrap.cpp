#include "evaluation/store_bootstrap.h"

#include <algorithm>
#include <map>

#include "base/seed.h"

namespace marketgen::evaluation {
namespace {

double ratio(double score, double weight) {
  return weight > 0 ? score / weight : 0;
}

double total_ratio(const std::vector<Cluster>& clusters) {
  double score = 0, weight = 0;
  for (const Cluster& cluster : clusters) {
    score += cluster.score;
    weight += cluster.weight;
  }
  return ratio(score, weight);
}

double drawn_ratio(const std::vector<Cluster>& clusters, Stream& draw) {
  const int last = static_cast<int>(clusters.size()) - 1;
  double score = 0, weight = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Cluster& cluster = clusters[static_cast<std::size_t>(draw.integer(0, last))];
    score += cluster.score;
    weight += cluster.weight;
  }
  return ratio(score, weight);
}

}  // namespace

std::vector<Cluster> clusters_of(const std::vector<ScoredEpisode>& episodes) {
  std::map<std::string, Cluster> stores;
  for (const ScoredEpisode& episode : episodes) {
    Cluster& cluster = stores[episode.store];
    cluster.score += episode.score;
    cluster.weight += episode.weight;
    ++cluster.episodes;
  }
  std::vector<Cluster> clusters;
  if (stores.size() > 1) {
    for (const auto& [store, cluster] : stores)
      clusters.push_back(cluster);
  } else {
    for (const ScoredEpisode& episode : episodes)
      clusters.push_back({episode.score, episode.weight, 1});
  }
  return clusters;
}

Estimate estimate_of(const std::vector<ScoredEpisode>& episodes) {
  std::vector<Cluster> clusters = clusters_of(episodes);
  const double value = total_ratio(clusters);
  if (clusters.empty()) return {};
  const auto by_sums = [](const Cluster& a, const Cluster& b) {
    return a.score != b.score ? a.score < b.score : a.weight < b.weight;
  };
  std::ranges::sort(clusters, by_sums);
  Stream draw = Seed(1).child("store_bootstrap").stream();
  std::vector<double> ratios;
  for (int i = 0; i < bootstrap_draws; ++i)
    ratios.push_back(drawn_ratio(clusters, draw));
  std::ranges::sort(ratios);
  constexpr auto outside = static_cast<std::size_t>(0.025 * bootstrap_draws);
  return {value, ratios[outside], ratios[ratios.size() - 1 - outside]};
}

}  // namespace marketgen::evaluation
