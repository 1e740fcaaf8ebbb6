#include "environments/certify.h"

#include <algorithm>

#include "environments/run_episode.h"

namespace marketgen::environments {
namespace {

episodes::RunLedger ledger_of(const episodes::EpisodeResult& result) {
  episodes::RunLedger ledger;
  ledger.hits = result.hits;
  ledger.asked = result.asked;
  ledger.strict = result.success_strict;
  ledger.clean = result.success_clean;
  ledger.failure = result.failure;
  ledger.side_effects = result.side_effects;
  ledger.simulated_s = result.simulated_s;
  ledger.state_hash = result.state_hash;
  return ledger;
}

void add(const episodes::EpisodeResult& result, episodes::ProofTrial& trial) {
  ++trial.tried;
  if (result.success_strict) {
    ++trial.held;
    trial.clean += result.success_clean ? 1 : 0;
    return;
  }
  const auto same =
      std::ranges::find(trial.failures, result.failure, &episodes::FailedRuns::failure);
  if (same == trial.failures.end())
    trial.failures.push_back({result.failure, 1});
  else
    ++same->runs;
}

Result<episodes::ProofTrial> trial_of(Arena& arena,
                                      const episodes::EpisodeSpec& spec,
                                      const std::string& actor,
                                      const CertificateRules& rules) {
  episodes::ProofTrial trial;
  trial.by = actor;
  MARKETGEN_TRY(const episodes::EpisodeResult nominal, run_episode(arena, spec, actor));
  trial.nominal = ledger_of(nominal);
  if (!trial.nominal.strict) return trial;
  const int may_fail = rules.replays - rules.needed;
  for (int replay = 0; replay < rules.replays; ++replay) {
    if (trial.held == rules.needed || trial.tried - trial.held > may_fail) break;
    MARKETGEN_TRY(
        const episodes::EpisodeResult result,
        run_episode(
            arena, spec, actor, nullptr, replay_perturbation(spec, rules.perturbation, replay)));
    add(result, trial);
  }
  return trial;
}

}  // namespace

episodes::Perturbation replay_perturbation(const episodes::EpisodeSpec& spec,
                                           const episodes::PerturbationSizes& sizes,
                                           int replay) {
  return {sizes, Seed(spec.seed).child("replay", static_cast<std::uint64_t>(replay))};
}

Result<episodes::PhysicsProof> prove(Arena& arena,
                                     const episodes::EpisodeSpec& spec,
                                     const CertificateRules& rules) {
  episodes::PhysicsProof proof;
  proof.replays = rules.replays;
  proof.needed = rules.needed;
  proof.perturbation = rules.perturbation;
  for (const std::string& actor : rules.actors) {
    MARKETGEN_TRY(episodes::ProofTrial trial, trial_of(arena, spec, actor, rules));
    const bool held = trial.nominal.strict && trial.held >= rules.needed;
    proof.trials.push_back(std::move(trial));
    if (!held) continue;
    proof.by = actor;
    break;
  }
  return proof;
}

}  // namespace marketgen::environments
