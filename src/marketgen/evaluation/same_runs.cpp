#include "evaluation/same_runs.h"

#include <fmt/format.h>

namespace marketgen::evaluation {
namespace {

// One thing that has to be the same, and what to do where it is not.
struct Likeness {
  std::string name, first, other, remedy;
};

Result<void> check_alike(const FinishedRun& first,
                         const FinishedRun& other,
                         const std::vector<Likeness>& all) {
  for (const Likeness& each : all)
    if (each.first != each.other)
      return Error{"results.not_comparable",
                   other.folder.string(),
                   fmt::format("is of {} {}, {} of {}: {}",
                               each.name,
                               each.other,
                               first.folder.string(),
                               each.first,
                               each.remedy)};
  return {};
}

Likeness same_realism(const RunRecord& a, const RunRecord& b) {
  return {"realism", a.realism, b.realism, "run both with the same realism"};
}

Likeness same_version(const RunRecord& a, const RunRecord& b) {
  return {"version", a.version, b.version, "run both with the same version of marketgen"};
}

Result<void> check_same_task(const FinishedRun& first, const FinishedRun& other) {
  const RunRecord &a = first.record, &b = other.record;
  return check_alike(
      first,
      other,
      {{"episodes", a.episodes_hash, b.episodes_hash, "run both policies on one file of episodes"},
       {"split",
        std::string(name_of(a.split)),
        std::string(name_of(b.split)),
        "run both policies on one file of episodes"},
       {"instructions",
        a.instructions,
        b.instructions,
        "run both policies on one file of episodes"},
       same_version(a, b)});
}

}  // namespace

Result<void> check_same_but_realism(const std::vector<FinishedRun>& runs) {
  for (const FinishedRun& run : runs)
    MARKETGEN_CHECK(check_same_task(runs.front(), run));
  return {};
}

Result<void> check_same_world(const std::vector<FinishedRun>& runs) {
  for (const FinishedRun& run : runs) {
    const RunRecord &a = runs.front().record, &b = run.record;
    MARKETGEN_CHECK(check_alike(runs.front(), run, {same_version(a, b), same_realism(a, b)}));
  }
  return {};
}

Result<void> check_same_episodes(const std::vector<FinishedRun>& runs) {
  MARKETGEN_CHECK(check_same_but_realism(runs));
  return check_same_world(runs);
}

Result<void> check_one_run(const std::vector<FinishedRun>& runs) {
  for (const FinishedRun& run : runs) {
    const RunRecord &a = runs.front().record, &b = run.record;
    MARKETGEN_CHECK(check_same_task(runs.front(), run));
    MARKETGEN_CHECK(check_alike(
        runs.front(),
        run,
        {same_realism(a, b),
         {"policy", a.policy, b.policy, "name the shards of one policy"},
         {"repetition",
          std::to_string(a.repetition.value_or(1)),
          std::to_string(b.repetition.value_or(1)),
          "name the shards of one repetition"},
         {"commit", a.commit(), b.commit(), "run all shards with the same build of marketgen"}}));
  }
  return {};
}

std::optional<std::string> common_set(const std::vector<FinishedRun>& runs) {
  std::optional<std::string> set;
  for (const FinishedRun& run : runs) {
    if (!run.record.set || (set && *set != *run.record.set)) return std::nullopt;
    set = run.record.set;
  }
  return set;
}

}  // namespace marketgen::evaluation
