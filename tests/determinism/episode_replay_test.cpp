// Episodes that are run again end in the same bits, on one thread or on all.
#include <gtest/gtest.h>

#include <set>

#include "base/parallel.h"
#include "environments/run_episode.h"
#include "episodes/checkout/sample_checkout.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr int baskets = 4, runs_a_basket = 4;
constexpr double simulated_s = 3;

// Four baskets, and four ways through each: what the policy draws comes from the episode's seed.
episodes::EpisodeFile sixteen_episodes(const std::filesystem::path& data) {
  episodes::EpisodeFile file;
  for (const catalog::Product& product : committed_catalog().products)
    if (episodes::is_checkout_item(product)) file.header.products.push_back(product);
  for (int basket = 0; basket < baskets; ++basket) {
    auto spec = episodes::sample_checkout(data,
                                          file.header.products,
                                          committed_catalog().frictions,
                                          {"corner", "s", "p"},
                                          Seed(31),
                                          basket);
    if (!spec.ok()) fatal(to_string(spec.error()).c_str());
    spec->limit_s = simulated_s;
    for (int i = 0; i < runs_a_basket; ++i) {
      spec->seed = static_cast<std::uint64_t>(i);
      file.episodes.push_back(*spec);
    }
  }
  return file;
}

std::string end_of(environments::Arena& arena, const episodes::EpisodeSpec& spec) {
  const auto result = environments::run_episode(arena, spec, "random");
  return result.ok() ? result->state_hash : to_string(result.error());
}

TEST(EpisodeReplay, SixteenEpisodesEndInTheSameState) {
  const std::filesystem::path data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
  const episodes::EpisodeFile file = sixteen_episodes(data);
  environments::Arena arena(data, file.header, committed_catalog());
  const auto run = [&](std::size_t i) { return end_of(arena, file.episodes[i]); };
  const std::vector<std::string> first = parallel_map(file.episodes.size(), run);
  const ThreadLimit one(1);
  const std::vector<std::string> again = parallel_map(file.episodes.size(), run);
  EXPECT_EQ(first, again);
  EXPECT_EQ(std::set<std::string>(first.begin(), first.end()).size(), file.episodes.size())
      << "each goes its own way";
}

}  // namespace
}  // namespace marketgen
