#include "evaluation/power_table.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace marketgen::evaluation {
namespace {

// Of the standard normal distribution: 97.5 % for the error, 80 % for the power.
constexpr double error_z = 1.959963984540054, power_z = 0.8416212335729143;

struct StoreSpread {
  double sum = 0, squares = 0;
  int episodes = 0;
};

std::map<std::string, StoreSpread> spreads_of(const std::vector<ScoredEpisode>& episodes) {
  std::map<std::string, StoreSpread> stores;
  for (const ScoredEpisode& episode : episodes) {
    StoreSpread& store = stores[episode.store];
    store.sum += episode.score;
    store.squares += episode.score * episode.score;
    ++store.episodes;
  }
  return stores;
}

PowerRow row_of(double difference, double independent, const StoreSampling& sampling) {
  const double alike = 1 + (sampling.episodes_per_store - 1) * sampling.likeness;
  const double episodes = std::ceil(independent * alike - 1e-9);
  return {difference,
          static_cast<int>(episodes),
          static_cast<int>(std::ceil(episodes / sampling.episodes_per_store - 1e-9))};
}

double episodes_for(double share, double other) {
  const double mean = (share + other) / 2, difference = share - other;
  const double root = error_z * std::sqrt(2 * mean * (1 - mean)) +
                      power_z * std::sqrt(share * (1 - share) + other * (1 - other));
  return root * root / (difference * difference);
}

}  // namespace

double likeness_in_stores(const std::vector<ScoredEpisode>& episodes) {
  const auto stores = spreads_of(episodes);
  const auto n = static_cast<double>(episodes.size()), k = static_cast<double>(stores.size());
  if (stores.size() < 2 || episodes.size() <= stores.size()) return 0;
  double sum = 0, between = 0, within = 0, sizes = 0;
  for (const auto& [name, store] : stores) {
    sum += store.sum;
    between += store.sum * store.sum / store.episodes;
    within += store.squares - store.sum * store.sum / store.episodes;
    sizes += static_cast<double>(store.episodes) * store.episodes;
  }
  between = (between - sum * sum / n) / (k - 1);
  within /= n - k;
  const double size = (n - sizes / n) / (k - 1);
  const double all = between + (size - 1) * within;
  return all > 0 ? std::clamp((between - within) / all, 0.0, 1.0) : 0;
}

StoreSampling sampling_of(const std::vector<ScoredEpisode>& episodes) {
  const auto stores = spreads_of(episodes).size();
  if (stores == 0) return {};
  return {static_cast<double>(episodes.size()) / static_cast<double>(stores),
          likeness_in_stores(episodes)};
}

std::vector<PowerRow> power_of_two_runs(double share, const StoreSampling& sampling) {
  std::vector<PowerRow> rows;
  for (const double difference : told_differences) {
    double independent = 0;
    for (const double other : {share - difference, share + difference})
      if (other >= 0 && other <= 1) independent = std::max(independent, episodes_for(share, other));
    rows.push_back(row_of(difference, independent, sampling));
  }
  return rows;
}

std::vector<PowerRow> power_of_pairs(double discordant, const StoreSampling& sampling) {
  std::vector<PowerRow> rows;
  for (const double difference : told_differences) {
    const double differing = std::max(discordant, difference);  // a difference is made of such
    const double root =
        error_z * std::sqrt(differing) + power_z * std::sqrt(differing - difference * difference);
    rows.push_back(row_of(difference, root * root / (difference * difference), sampling));
  }
  return rows;
}

}  // namespace marketgen::evaluation
