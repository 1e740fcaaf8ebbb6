#include "episodes/certificate.h"

#include <fmt/format.h>

#include "episodes/episode_spec.h"

namespace marketgen::episodes {
namespace {

// Reasons for which physics was asked and said no.
bool is_of_physics(const DrawRefusal& refusal) {
  return refusal.reason.starts_with(refused_by_physics);
}

Error bad_trial(const std::string& where, std::string message) {
  return {"episode.bad_value", where, std::move(message)};
}

Result<void> check_trial(const PhysicsProof& proof,
                         const ProofTrial& trial,
                         const std::string& where) {
  int failed = 0;
  for (const FailedRuns& runs : trial.failures)
    failed += runs.runs;
  if (trial.held + failed != trial.tried)
    return bad_trial(
        where + "/tried",
        fmt::format(
            "{} runs held and {} failed, which is not {}", trial.held, failed, trial.tried));
  if (trial.tried > proof.replays)
    return bad_trial(where + "/tried", fmt::format("more than the {} replays", proof.replays));
  if (trial.clean > trial.held)
    return bad_trial(where + "/clean", fmt::format("more than the {} that held", trial.held));
  if (trial.tried > 0 && !trial.nominal.strict)
    return bad_trial(where + "/tried", "its run of the episode as it is failed: expected 0");
  return {};
}

// What kept the actor that came nearest: the first failure of the episode as it is, or of its
// perturbed worlds.
std::string why_not(const PhysicsProof& proof) {
  for (const ProofTrial& trial : proof.trials)
    if (trial.nominal.strict)
      return trial.failures.empty()
                 ? "replays"
                 : fmt::format("replays {}", name_of(trial.failures.front().failure));
  return proof.trials.empty() ? "not tried"
                              : std::string(name_of(proof.trials.front().nominal.failure));
}

bool holds(const PhysicsProof& proof, const ProofTrial& trial) {
  return trial.nominal.strict && trial.held >= proof.needed;
}

}  // namespace

double PhysicsProof::simulated_s() const {
  double sum = 0;
  for (const ProofTrial& trial : trials)
    sum += trial.nominal.simulated_s;
  return sum;
}

bool is_planned(const EpisodeCertificate& certificate) {
  return certificate.has("place") && !certificate.has(shown_by_wider_search);
}

void add_refusal(std::vector<DrawRefusal>& to, const DrawRefusal& refusal) {
  const auto same = std::ranges::find(to, refusal.reason, &DrawRefusal::reason);
  if (same == to.end()) {
    to.push_back(refusal);
    return;
  }
  same->drawn += refusal.drawn;
  same->planned += refusal.planned;
}

void CandidateJudge::refuse(const std::string& reason, bool planned) {
  add_refusal(refused_, {reason, 1, planned ? 1 : 0});
}

Result<bool> CandidateJudge::keep(EpisodeSpec& spec) {
  EpisodeCertificate& certificate = spec.certificate;
  if (prove_) {
    MARKETGEN_TRY(certificate.physics, prove_(spec));
    if (!certificate.physics->held()) {
      refuse(std::string(refused_by_physics) + why_not(*certificate.physics),
             is_planned(certificate));
      return false;
    }
    certificate.proved.emplace_back(shown_in_physics);
  }
  if (!refused_.empty()) certificate.refused = refused_;
  return true;
}

std::string CandidateJudge::spoken() const {
  std::string text;
  for (const DrawRefusal& refusal : refused_)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", refusal.reason, refusal.drawn);
  return text;
}

DrawShares draw_shares(const std::vector<EpisodeSpec>& episodes) {
  DrawShares shares;
  shares.kept = shares.drawn = static_cast<int>(episodes.size());
  for (const EpisodeSpec& spec : episodes) {
    const EpisodeCertificate& certificate = spec.certificate;
    for (const DrawRefusal& refusal : certificate.refused.value_or(std::vector<DrawRefusal>{})) {
      add_refusal(shares.refused, refusal);
      shares.drawn += refusal.drawn;
      if (!is_of_physics(refusal)) continue;
      shares.planned_tried += refusal.planned;
      shares.other_tried += refusal.drawn - refusal.planned;
    }
    if (!certificate.physics) continue;
    const bool planned = is_planned(certificate);
    ++(planned ? shares.planned_tried : shares.other_tried);
    ++(planned ? shares.planned_held : shares.other_held);
    const std::string& by = certificate.physics->by;
    const auto same = std::ranges::find(shares.proved_by, by, &ProvedBy::by);
    if (same == shares.proved_by.end())
      shares.proved_by.push_back({by, 1});
    else
      ++same->episodes;
  }
  std::ranges::sort(shares.refused, {}, &DrawRefusal::reason);
  std::ranges::sort(shares.proved_by, {}, &ProvedBy::by);
  return shares;
}

Result<void> check_certificate(const EpisodeCertificate& certificate, const std::string& where) {
  const bool said = certificate.has(shown_in_physics);
  if (!certificate.physics) {
    if (!said) return {};
    return bad_trial(where + "/proved",
                     "says \"physics\", and nothing is there of it: draw the episodes again");
  }
  const PhysicsProof& proof = *certificate.physics;
  const std::string at = where + "/physics";
  for (std::size_t i = 0; i < proof.trials.size(); ++i)
    MARKETGEN_CHECK(check_trial(proof, proof.trials[i], fmt::format("{}/trials/{}", at, i)));
  if (said != proof.held())
    return bad_trial(where + "/proved",
                     said ? "says \"physics\", and no actor has done it: draw the episodes again"
                          : "does not say \"physics\", and an actor has done it");
  if (!proof.held()) return {};
  if (proof.trials.empty() || proof.trials.back().by != proof.by ||
      !holds(proof, proof.trials.back()))
    return bad_trial(at + "/by",
                     fmt::format("\"{}\" has not done it in {} perturbed worlds: draw the episodes "
                                 "again",
                                 proof.by,
                                 proof.needed));
  return {};
}

}  // namespace marketgen::episodes
