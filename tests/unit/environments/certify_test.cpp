// Certificates in physics: what is done again and again is proved, what is not says why.
#include "environments/certify.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "environments/environment_entry.h"
#include "environments/run_episode.h"
#include "episodes/check_episodes.h"
#include "io/json.h"
#include "support/drawn_checkout.h"
#include "support/pool_ground.h"
#include "support/recorded_actions.h"

namespace marketgen {
namespace {

environments::CertificateRules by(std::vector<std::string> actors, int replays, int needed) {
  environments::CertificateRules rules;
  rules.actors = std::move(actors);
  rules.replays = replays;
  rules.needed = needed;
  return rules;
}

episodes::PhysicsProof proof_of(environments::Arena& arena,
                                const episodes::EpisodeSpec& spec,
                                const environments::CertificateRules& rules) {
  auto proof = environments::prove(arena, spec, rules);
  if (!proof.ok()) fatal(to_string(proof.error()).c_str());
  return std::move(proof).value();
}

// The pool's, whose products its header has, with one goal: less is to be done.
episodes::EpisodeSpec one_goal() {
  episodes::EpisodeSpec spec = pool_ground(episodes::Track::checkout)->episodes().front();
  spec.goals.resize(1);
  return spec;
}

TEST(Certify, WhatIsDoneAgainAndAgainIsProved) {
  environments::Arena& arena = pool_ground(episodes::Track::checkout)->arena();
  episodes::EpisodeSpec spec = one_goal();
  const environments::CertificateRules rules = by({"stop", "oracle-plain"}, 2, 1);
  spec.certificate.physics = proof_of(arena, spec, rules);
  const episodes::PhysicsProof& proof = *spec.certificate.physics;
  ASSERT_EQ(proof.by, "oracle-plain") << io::write_json(proof);
  ASSERT_EQ(proof.trials.size(), 2U);
  EXPECT_FALSE(proof.trials[0].nominal.strict);
  EXPECT_EQ(proof.trials[0].tried, 0) << "what fails as it is needs no replays";
  const episodes::ProofTrial& held = proof.trials[1];
  EXPECT_TRUE(held.nominal.strict);
  EXPECT_EQ(held.nominal.hits, 1);
  EXPECT_EQ(held.held, 1) << "decided then";
  EXPECT_FALSE(held.nominal.state_hash.empty());
  spec.certificate.proved.emplace_back("physics");
  const auto checked = episodes::check_episode(spec, spec.id);
  EXPECT_TRUE(checked.ok()) << to_string(checked.error());
  // The episode as it is ends as anybody's run of it does.
  const auto run = environments::run_episode(arena, one_goal(), "oracle-plain");
  ASSERT_TRUE(run.ok()) << to_string(run.error());
  EXPECT_EQ(run->state_hash, held.nominal.state_hash);
}

// Heavier than what the fingers press holds.
TEST(Certify, GoodsThatTheHandCannotHoldAreNotProvedAndSayWhy) {
  episodes::EpisodeSpec spec = one_goal();
  episodes::EpisodeHeader header;
  header.products = pool_ground(episodes::Track::checkout)->products();
  for (catalog::Product& product : header.products)
    if (product.sku == spec.goals.front().sku) product.mass_kg = 12;
  spec.lane.reset();
  spec.limit_s = 40;
  environments::Arena arena(data_rows(), header, committed_catalog());
  const episodes::PhysicsProof proof = proof_of(arena, spec, by({"oracle-plain"}, 3, 2));
  EXPECT_FALSE(proof.held());
  ASSERT_EQ(proof.trials.size(), 1U);
  EXPECT_NE(proof.trials[0].nominal.failure, episodes::FailureCode::none);
  EXPECT_NE(proof.trials[0].nominal.failure, episodes::FailureCode::unknown);
}

// Where much is quite other the replays end at the second that fails, or as soon as enough held.
TEST(SlowCertify, ReplaysEndWhenTheyAreDecided) {
  environments::Arena& arena = pool_ground(episodes::Track::checkout)->arena();
  episodes::EpisodeSpec spec = one_goal();
  environments::CertificateRules rules = by({"oracle-plain"}, 4, 3);
  rules.perturbation.mass = 0.9;  // many are then too heavy, or else as good as nothing
  rules.perturbation.friction = 0.9;
  rules.perturbation.place_m = 0.05;
  const episodes::PhysicsProof proof = proof_of(arena, spec, rules);
  const episodes::ProofTrial& trial = proof.trials.front();
  ASSERT_TRUE(trial.nominal.strict) << io::write_json(proof);
  EXPECT_EQ(proof.held(), trial.held == 3);
  EXPECT_TRUE(trial.held == 3 || trial.tried - trial.held == 2) << io::write_json(proof);
}

TEST(Certify, AReplayIsAFunctionOfItsEpisodeAndNumber) {
  environments::Arena& arena = pool_ground(episodes::Track::checkout)->arena();
  const episodes::EpisodeSpec spec = one_goal();
  const auto hash = [&](int replay) {
    const auto world = arena.open(
        spec, environments::replay_perturbation(spec, episodes::PerturbationSizes{}, replay));
    if (!world.ok()) fatal(to_string(world.error()).c_str());
    return (*world)->state_hash();
  };
  EXPECT_EQ(hash(0), hash(0));
  EXPECT_NE(hash(0), hash(1));
}

// ---- Over the tracks ----

class EachTracksCertificate : public testing::TestWithParam<episodes::Track> {};

TEST_P(EachTracksCertificate, WorldsOpenPerturbedAndAlikeTwice) {
  environments::Arena& arena = pool_ground(GetParam())->arena();
  const episodes::EpisodeSpec spec = pool_episode(GetParam(), 10);
  const episodes::Perturbation other{{}, Seed(3)};
  const auto once = arena.open(spec, other), again = arena.open(spec, other),
             plain = arena.open(spec);
  for (const auto* world : {&once, &again, &plain}) {
    ASSERT_TRUE(world->ok()) << to_string(world->error());
    const auto stepped = (**world)->step(episodes::still_action((**world)->observe()));
    ASSERT_TRUE(stepped.ok()) << to_string(stepped.error());
  }
  EXPECT_EQ((*once)->state_hash(), (*again)->state_hash());
}

TEST_P(EachTracksCertificate, WhoDoesNothingProvesNothing) {
  environments::Arena& arena = pool_ground(GetParam())->arena();
  const episodes::PhysicsProof proof =
      proof_of(arena, pool_episode(GetParam(), 10), by({"stop", "random"}, 10, 9));
  EXPECT_FALSE(proof.held());
  ASSERT_EQ(proof.trials.size(), 2U);
  for (const episodes::ProofTrial& trial : proof.trials) {
    EXPECT_EQ(trial.tried, 0);
    EXPECT_EQ(trial.nominal.hits, 0);
    EXPECT_GT(trial.nominal.asked, 0);
  }
}

// Episodes of both open and are checked; they have no witness.
TEST_P(EachTracksCertificate, EpisodesAreDrawnWithoutOne) {
  environments::Arena& arena = pool_ground(GetParam())->arena();
  const episodes::EpisodeStore& store = pool_ground(GetParam())->stores().front();
  for (const episodes::Split split : {episodes::Split::paper, episodes::Split::all}) {
    const auto sampler = environments::environment_entry_of(GetParam()).sampler(arena, "", {split});
    ASSERT_TRUE(sampler.ok()) << to_string(sampler.error());
    const auto from = (*sampler)->of_store({store.name, store.scene_hash, store.plan_hash});
    ASSERT_TRUE(from.ok()) << to_string(from.error());
    const auto spec = (*from)->sample(Seed(5), 0);
    ASSERT_TRUE(spec.ok()) << to_string(spec.error());
    EXPECT_TRUE(spec->certificate.witness.empty());
    EXPECT_FALSE(spec->certificate.physics);
    EXPECT_FALSE(spec->certificate.has("place"));
    const auto checked = episodes::check_episode(*spec, spec->id);
    EXPECT_TRUE(checked.ok()) << to_string(checked.error());
    const auto again = (*from)->sample(Seed(5), 0);
    ASSERT_TRUE(again.ok()) << to_string(again.error());
    EXPECT_EQ(io::write_json_line(*spec), io::write_json_line(*again));
  }
}

INSTANTIATE_TEST_SUITE_P(OfTracks,
                         EachTracksCertificate,
                         testing::ValuesIn(episodes::all_tracks),
                         [](const auto& track) { return std::string(name_of(track.param)); });

// ---- A measure, of a file of episodes that one brings ----

std::string asked(const char* name, const std::string& otherwise) {
  const char* const said = std::getenv(name);
  return said == nullptr ? otherwise : said;
}

// MARKETGEN_EPISODES=FILE [MARKETGEN_COUNT=1000] [MARKETGEN_REPLAYS=10]
// [MARKETGEN_ACTOR=oracle-plain]: how many perturbed worlds an actor masters that plans anew in
// them, and how many the commands of the episode as it is, without looking.
TEST(CertifyMeasure, ClosedAndOpenLoop) {
  const std::string file = asked("MARKETGEN_EPISODES", "");
  if (file.empty()) GTEST_SKIP() << "no MARKETGEN_EPISODES";
  const std::string actor = asked("MARKETGEN_ACTOR", "oracle-plain");
  const int replays = std::stoi(asked("MARKETGEN_REPLAYS", "10"));
  int left = std::stoi(asked("MARKETGEN_COUNT", "1000"));
  const auto ground = environments::EpisodeGround::of_file(file);
  ASSERT_TRUE(ground.ok()) << to_string(ground.error());
  environments::Arena& arena = (*ground)->arena();
  for (const episodes::EpisodeSpec& spec : (*ground)->episodes()) {
    if (left-- <= 0) break;
    const auto world = arena.open(spec);
    ASSERT_TRUE(world.ok()) << to_string(world.error());
    auto policy = arena.policy(actor, **world);
    ASSERT_TRUE(policy.ok()) << to_string(policy.error());
    Recorder recorder(std::move(policy).value());
    const auto began = std::clock();
    const auto nominal = environments::run_policy(**world, recorder, actor);
    ASSERT_TRUE(nominal.ok()) << to_string(nominal.error());
    const double took_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    fmt::print("{} by {}: nominal {} ({}, {:.0f} simulated s, {:.1f} s)",
               spec.id,
               actor,
               nominal->success_strict ? "held" : "failed",
               name_of(nominal->failure),
               nominal->simulated_s,
               took_s);
    std::array<int, 2> held{};
    std::array<double, 2> times_s{};
    for (int replay = 0; nominal->success_strict && replay < replays; ++replay) {
      const episodes::Perturbation other =
          environments::replay_perturbation(spec, episodes::PerturbationSizes{}, replay);
      for (const std::size_t open_loop : {0U, 1U}) {
        const auto start = std::clock();
        const auto there = arena.open(spec, other);
        ASSERT_TRUE(there.ok()) << to_string(there.error());
        auto looking = arena.policy(actor, **there);
        ASSERT_TRUE(looking.ok()) << to_string(looking.error());
        Recorded recorded(recorder.actions());
        agent::Policy& acts = open_loop == 1 ? static_cast<agent::Policy&>(recorded) : **looking;
        const auto result = environments::run_policy(**there, acts, actor);
        ASSERT_TRUE(result.ok()) << to_string(result.error());
        held[open_loop] += result->success_strict ? 1 : 0;
        times_s[open_loop] += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (open_loop == 0 && !result->success_strict) fmt::print(" {}", name_of(result->failure));
      }
    }
    fmt::print("; of {} closed loop {} in {:.0f} s, open loop {} in {:.0f} s\n",
               replays,
               held[0],
               times_s[0],
               held[1],
               times_s[1]);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace marketgen
