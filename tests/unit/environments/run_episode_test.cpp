// Whole episodes with the oracle: run, judged, repeated bit for bit.
#include "environments/run_episode.h"

#include <gtest/gtest.h>

#include "io/json.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

Result<episodes::EpisodeResult> run_by(const std::string& policy,
                                       const episodes::EpisodeSpec& spec) {
  episodes::EpisodeHeader header;
  header.products = checkout_goods_rows();
  environments::Arena arena(data_rows(), header, committed_catalog());
  return environments::run_episode(arena, spec, policy);
}

episodes::EpisodeResult run(const episodes::EpisodeSpec& spec) {
  auto result = run_by("oracle", spec);
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

TEST(RunEpisode, TheOracleActsTwiceAlike) {
  episodes::EpisodeSpec spec = drawn(7, 0);
  spec.limit_s = 15;  // one item or two
  const episodes::EpisodeResult one = run(spec), again = run(spec);
  EXPECT_EQ(one.state_hash, again.state_hash);
  EXPECT_GT(one.side_effects.displaced + one.success_partial, 0) << io::write_json(one);
  EXPECT_TRUE(one.detail.empty()) << one.detail;
}

TEST(RunEpisode, UnknownPoliciesAreErrors) {
  const auto result = run_by("orakel", drawn(7, 0));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "usage.bad_flag");
}

}  // namespace
}  // namespace marketgen
