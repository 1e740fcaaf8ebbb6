#include "episodes/check_witness.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"
#include "episodes/proved_names.h"
#include "episodes/track_entry.h"
#include "motion/grasp_candidates.h"

namespace marketgen::episodes {
namespace {

constexpr std::string_view remedy = "draw the episodes again, or leave \"certificate\" out";

Error bad_certificate(const std::string& where, const std::string& message) {
  return {"episode.bad_value", where, fmt::format("{}: {}", message, remedy)};
}

std::vector<std::string_view> proofs_of(Track track) {
  std::vector<std::string_view> known = entry_of(track).proofs();
  known.push_back(shown_in_physics);
  return known;
}

Result<void> check_proved(const EpisodeSpec& spec, const std::string& where) {
  const std::vector<std::string_view> known = proofs_of(spec.track);
  std::set<std::string_view> said;
  for (const std::string& name : spec.certificate.proved) {
    if (std::ranges::find(known, name) == known.end())
      return bad_certificate(
          where,
          fmt::format("of the track {} nothing is shown that is called \"{}\"{}; "
                      "there are: {}",
                      name_of(spec.track),
                      name,
                      did_you_mean(name, known),
                      fmt::join(known, ", ")));
    if (!said.insert(name).second)
      return bad_certificate(where, fmt::format("says \"{}\" twice", name));
  }
  return {};
}

// The first condition that only a planned way shows; empty: there is none.
std::string_view shown_by_a_way(const EpisodeCertificate& certificate) {
  const auto without_one = [](std::string_view name) {
    return name == shown_settled || name == shown_in_physics ||
           std::ranges::find(shown_on_paper, name) != shown_on_paper.end();
  };
  const auto found = std::ranges::find_if_not(certificate.proved, without_one);
  return found == certificate.proved.end() ? std::string_view() : std::string_view(*found);
}

Result<void> check_goals_are_fetched(const EpisodeSpec& spec, const std::string& where) {
  const std::string_view shown = shown_by_a_way(spec.certificate);
  if (shown.empty()) return {};
  const std::vector<WitnessPick>& witness = spec.certificate.witness;
  if (witness.empty())
    return bad_certificate(
        where,
        fmt::format("is empty, and \"proved\" says \"{}\", which a planned way shows", shown));
  for (const EpisodeGoal& goal : spec.goals) {
    const auto fetched = std::ranges::count(witness, goal.sku, &WitnessPick::sku);
    if (fetched < goal.count)
      return bad_certificate(
          where,
          fmt::format("takes {} of \"{}\", and {} are asked for", fetched, goal.sku, goal.count));
  }
  return {};
}

Result<void> check_pick(const WitnessPick& pick, const std::string& where) {
  if (!pick.strategy.empty() && !value_named<motion::GraspStrategy>(pick.strategy))
    return bad_certificate(
        where + "/strategy",
        fmt::format("nothing is taken by \"{}\"{}; there are: {}",
                    pick.strategy,
                    did_you_mean(pick.strategy, names_of(motion::GraspStrategy{})),
                    fmt::join(names_of(motion::GraspStrategy{}), ", ")));
  std::set<int> grasps;
  for (const int grasp : pick.grasps)
    if (grasp < 0 || !grasps.insert(grasp).second)
      return bad_certificate(
          where + "/grasps",
          fmt::format("{} is {}", grasp, grasp < 0 ? "less than 0" : "there twice"));
  if (pick.drive_m < 0)
    return bad_certificate(where + "/drive_m", fmt::format("{} is less than 0", pick.drive_m));
  return {};
}

}  // namespace

Result<void> check_witness(const EpisodeSpec& spec, const std::string& where) {
  const std::string at = where + "/certificate";
  MARKETGEN_CHECK(check_proved(spec, at + "/proved"));
  MARKETGEN_CHECK(check_goals_are_fetched(spec, at + "/witness"));
  std::set<std::string_view> taken;
  const std::vector<WitnessPick>& witness = spec.certificate.witness;
  for (std::size_t i = 0; i < witness.size(); ++i) {
    const std::string at_pick = fmt::format("{}/witness/{}", at, i);
    MARKETGEN_CHECK(check_pick(witness[i], at_pick));
    if (!taken.insert(witness[i].product).second)
      return bad_certificate(at_pick + "/product",
                             fmt::format("\"{}\" was taken before", witness[i].product));
  }
  if (auto checked = entry_of(spec.track).check_picks(spec); !checked.ok())
    return bad_certificate(at + "/" + checked.error().where, checked.error().message);
  return {};
}

}  // namespace marketgen::episodes
