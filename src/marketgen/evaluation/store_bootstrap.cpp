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

bool by_sums(const Cluster& a, const Cluster& b) {
  return a.score != b.score ? a.score < b.score : a.weight < b.weight;
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
  return estimate_of_mean({episodes});
}

Estimate estimate_of_mean(const std::vector<std::vector<ScoredEpisode>>& lists) {
  const auto share = 1.0 / static_cast<double>(std::max<std::size_t>(lists.size(), 1));
  double value = 0;
  std::vector<double> means(bootstrap_draws, 0);
  for (std::size_t list = 0; list < lists.size(); ++list) {
    std::vector<Cluster> clusters = clusters_of(lists[list]);
    value += share * total_ratio(clusters);
    std::ranges::sort(clusters, by_sums);
    const Seed seed(1);
    Stream draw =
        (list == 0 ? seed.child("store_bootstrap") : seed.child("store_bootstrap", list)).stream();
    for (double& mean : means)
      mean += share * drawn_ratio(clusters, draw);
  }
  std::ranges::sort(means);
  constexpr auto outside = static_cast<std::size_t>(0.025 * bootstrap_draws);
  return {value, means[outside], means[means.size() - 1 - outside]};
}

}  // namespace marketgen::evaluation
