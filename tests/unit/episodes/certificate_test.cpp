// What an episode says of itself: kept as it was written, and refused when it contradicts itself.
#include "episodes/certificate.h"

#include <gtest/gtest.h>

#include "episodes/episode_spec.h"
#include "io/json.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

episodes::PhysicsProof proof_by(const std::string& actor) {
  episodes::PhysicsProof proof;
  proof.by = actor;
  proof.replays = 10;
  proof.needed = 9;
  episodes::ProofTrial failed, held;
  failed.by = "oracle-plain";
  failed.nominal.asked = 2;
  failed.nominal.failure = episodes::FailureCode::dropped;
  failed.nominal.simulated_s = 30;
  held.by = "oracle";
  held.nominal.strict = true;
  held.nominal.hits = held.nominal.asked = 2;
  held.nominal.side_effects.hard_contacts = 1;
  held.nominal.simulated_s = 41.5;
  held.nominal.state_hash = "abc";
  held.tried = 10;
  held.held = 9;
  held.clean = 4;
  held.failures = {{episodes::FailureCode::slipped, 1}};
  proof.trials = {failed, held};
  return proof;
}

episodes::EpisodeCertificate proved() {
  episodes::EpisodeCertificate certificate;
  certificate.proved = {"settled", "physics"};
  certificate.physics = proof_by("oracle");
  return certificate;
}

Error error_of(const episodes::EpisodeCertificate& certificate) {
  const auto checked = episodes::check_certificate(certificate, "e.jsonl:2");
  return checked.ok() ? Error{"none", "", ""} : checked.error();
}

TEST(Certificate, ReadsWhatItWrote) {
  const std::string text = io::write_json_line(proved());
  const auto read = io::read_json<episodes::EpisodeCertificate>(text, "certificate");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(io::write_json_line(*read), text);
  EXPECT_EQ(read->physics->trials[1].failures.front().failure, episodes::FailureCode::slipped);
  EXPECT_EQ(read->physics->simulated_s(), 71.5);
  EXPECT_EQ(error_of(*read).code, "none");
}

// Files of earlier versions have nothing of it, and keep their hashes.
TEST(Certificate, OneWithoutPhysicsIsWrittenAsBefore) {
  episodes::EpisodeCertificate certificate;
  certificate.proved = {"settled"};
  EXPECT_EQ(io::write_json_line(certificate), R"({"proved": ["settled"], "witness": []})");
  EXPECT_EQ(error_of(certificate).code, "none");
  for (const episodes::EpisodeSpec& spec : pool_file().episodes)
    EXPECT_FALSE(spec.certificate.physics);
  EXPECT_EQ(pool_file().header.split, episodes::Split::planned);
}

TEST(Certificate, OneThatContradictsItselfIsAnError) {
  const auto at = [](const auto& change) {
    episodes::EpisodeCertificate certificate = proved();
    change(certificate);
    const Error error = error_of(certificate);
    EXPECT_EQ(error.code, "episode.bad_value");
    return error.where;
  };
  using Certificate = episodes::EpisodeCertificate;
  EXPECT_EQ(at([](Certificate& c) { c.physics.reset(); }), "e.jsonl:2/proved");
  EXPECT_EQ(at([](Certificate& c) { c.proved.pop_back(); }), "e.jsonl:2/proved");
  EXPECT_EQ(at([](Certificate& c) { c.physics->by.clear(); }), "e.jsonl:2/proved");
  EXPECT_EQ(at([](Certificate& c) { c.physics->by = "oracle-plain"; }), "e.jsonl:2/physics/by");
  EXPECT_EQ(at([](Certificate& c) { c.physics->needed = 10; }), "e.jsonl:2/physics/by");
  EXPECT_EQ(at([](Certificate& c) { c.physics->trials.clear(); }), "e.jsonl:2/physics/by");
  EXPECT_EQ(at([](Certificate& c) { c.physics->trials[1].held = 10; }),
            "e.jsonl:2/physics/trials/1/tried");
  EXPECT_EQ(at([](Certificate& c) { c.physics->replays = 9; }), "e.jsonl:2/physics/trials/1/tried");
  EXPECT_EQ(at([](Certificate& c) { c.physics->trials[1].clean = 10; }),
            "e.jsonl:2/physics/trials/1/clean");
  EXPECT_EQ(at([](Certificate& c) { c.physics->trials[1].nominal.strict = false; }),
            "e.jsonl:2/physics/trials/1/tried");
}

// ---- What is drawn, tried and kept ----

// Few kinds: that of each a body is made takes longer than all the rest.
std::vector<catalog::Product> few_goods() {
  std::vector<catalog::Product> goods = checkout_goods_rows();
  goods.resize(10);
  return goods;
}

TEST(CandidateJudge, BasketsThatAreNotDoneAreDrawnAnewAndNoted) {
  int asked = 0;
  const episodes::EpisodeProver prove =
      [&](const episodes::EpisodeSpec&) -> Result<episodes::PhysicsProof> {
    return proof_by(++asked < 2 ? "" : "oracle");
  };
  const auto spec = episodes::sample_checkout(data_rows(),
                                              few_goods(),
                                              committed_catalog().frictions,
                                              {"corner", "s", "p"},
                                              Seed(7),
                                              0,
                                              {},
                                              prove);
  ASSERT_TRUE(spec.ok()) << to_string(spec.error());
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(spec->certificate.has("physics"));
  ASSERT_TRUE(spec->certificate.refused.has_value());
  int refused_in_physics = 0;
  for (const episodes::DrawRefusal& refusal : *spec->certificate.refused)
    if (refusal.reason == "physics: replays Slipped") refused_in_physics = refusal.drawn;
  EXPECT_EQ(refused_in_physics, 1);
  const episodes::DrawShares shares = episodes::draw_shares({*spec});
  EXPECT_EQ(shares.kept, 1);
  EXPECT_GE(shares.drawn, 2);
  EXPECT_EQ(shares.planned_tried, 0);
  EXPECT_EQ(shares.other_tried, 2);
  EXPECT_EQ(shares.other_held, 1);
  ASSERT_EQ(shares.proved_by.size(), 1U);
  EXPECT_EQ(shares.proved_by.front().by, "oracle");
}

TEST(CandidateJudge, SaysWhatWasRefused) {
  episodes::PhysicsProof made = proof_by("");
  const episodes::EpisodeProver prove =
      [&](const episodes::EpisodeSpec&) -> Result<episodes::PhysicsProof> { return made; };
  episodes::CandidateJudge judge(prove);
  EXPECT_TRUE(judge.proves());
  EXPECT_EQ(judge.spoken(), "");
  judge.refuse("restless");
  judge.refuse("restless");
  episodes::EpisodeSpec spec;
  spec.certificate.proved = {"settled", "place"};
  EXPECT_FALSE(judge.keep(spec).value());
  made.trials.resize(1);  // that failed as it is
  EXPECT_FALSE(judge.keep(spec).value());
  EXPECT_EQ(judge.spoken(), "restless 2, physics: replays Slipped 1, physics: Dropped 1");
  made = proof_by("oracle");
  EXPECT_TRUE(judge.keep(spec).value());
  const episodes::DrawShares shares = episodes::draw_shares({spec});
  EXPECT_EQ(shares.drawn, 5);
  EXPECT_EQ(shares.planned_tried, 3);
  EXPECT_EQ(shares.planned_held, 1);
  EXPECT_EQ(shares.other_tried, 0);
}

TEST(CandidateJudge, WithoutAProverAllIsKept) {
  const episodes::EpisodeProver none;
  episodes::CandidateJudge judge(none);
  EXPECT_FALSE(judge.proves());
  episodes::EpisodeSpec spec;
  EXPECT_TRUE(judge.keep(spec).value());
  EXPECT_FALSE(spec.certificate.has("physics"));
  EXPECT_FALSE(spec.certificate.refused);
}

// A file that calls itself certified has only such episodes.
TEST(CertifiedFile, EveryEpisodeIsDoneInPhysics) {
  episodes::EpisodeFile file = pool_file();
  file.header.split = episodes::Split::certified;
  const auto read = episodes::read_episodes(episodes::write_episodes(file), "e.jsonl");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "episode.bad_value");
  EXPECT_EQ(read.error().where, "e.jsonl:2/certificate");
  for (episodes::EpisodeSpec& spec : file.episodes) {
    spec.certificate.proved.emplace_back("physics");
    spec.certificate.physics = proof_by("oracle");
  }
  const auto whole = episodes::read_episodes(episodes::write_episodes(file), "e.jsonl");
  EXPECT_TRUE(whole.ok()) << to_string(whole.error());
}

}  // namespace
}  // namespace marketgen
