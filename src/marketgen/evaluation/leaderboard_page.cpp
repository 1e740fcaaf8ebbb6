#include "evaluation/leaderboard_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "evaluation/table_remarks.h"
#include "store/html_page.h"

namespace marketgen::evaluation {
namespace {

// The value, and in a line below it how sure that is.
std::string cell(double value, double low, double high, const std::string& counted) {
  return fmt::format("<td class=\"value\">{:.1f}<br><small>{:.1f} to {:.1f}{}</small></td>",
                     100 * value,
                     100 * low,
                     100 * high,
                     counted);
}

template <class Share>
std::string share_cell(const Share& share) {
  return cell(
      share.share, share.low, share.high, fmt::format("<br>{} of {}", share.number, share.of));
}

std::string estimate_cell(const std::optional<Estimate>& estimate) {
  return estimate ? cell(estimate->value, estimate->low, estimate->high, "") : "<td>–</td>";
}

std::string p_cell(double p) {
  return fmt::format("<td>{}</td>", p < 0.0001 ? "&lt; 0.0001" : fmt::format("{:.4f}", p));
}

std::string entry_row(const LeaderboardEntry& entry) {
  std::string row = fmt::format("<tr><td>{}{}<br><small>{}</small></td>",
                                escaped_markup(spoken_entry(entry)),
                                entry.floor ? " <span class=\"warn\">floor</span>" : "",
                                escaped_markup(entry.commit));
  row += share_cell(entry.strict) + estimate_cell(entry.partial) + share_cell(entry.goals) +
         estimate_cell(entry.spl) + share_cell(entry.clean) + share_cell(entry.violations);
  if (!entry.to_best) return row + "<td colspan=\"2\">best</td></tr>";
  return row + p_cell(entry.to_best->p_strict_holm) + p_cell(entry.to_best->p_partial_holm) +
         "</tr>";
}

std::string power_row(const std::string& name,
                      const std::string& likeness,
                      const std::vector<PowerRow>& power) {
  std::string row =
      fmt::format("<tr><td>{}</td><td>{}</td>", escaped_markup(name), escaped_markup(likeness));
  for (const PowerRow& each : power)
    row += fmt::format("<td>{} <small>of {} stores</small></td>", each.episodes, each.stores);
  return row + "</tr>";
}

std::string power_table(const LeaderboardTrack& track) {
  std::string out =
      "<h2>Episodes that would be needed</h2><p class=\"sub\">To tell a difference in strict "
      "success of so many points at 80 % power and 5 % error, with as many episodes a store, as "
      "alike within a store, as were measured. Beside another: both on the same episodes.</p>"
      "<table><tr><th>policy</th><th>likeness in stores</th><th>2 points</th><th>5 points</th>"
      "<th>10 points</th><th>20 points</th></tr>";
  for (const LeaderboardEntry& entry : track.entries) {
    out += power_row(spoken_entry(entry), fmt::format("{:.2f}", entry.likeness), entry.power);
    if (entry.to_best)
      out += power_row(
          spoken_entry(entry) + " beside " + entry.to_best->against, "", entry.to_best->power);
  }
  return out + "</table>";
}

std::string repeated_lines(const LeaderboardTrack& track) {
  std::string out;
  for (const RepeatedPolicy& policy : track.repeated)
    out += fmt::format("<p>{}</p>", escaped_markup(spoken_repeated(policy)));
  return out;
}

std::string track_section(const LeaderboardTrack& track) {
  const LeaderboardEntry& best = track.entries.front();
  std::string out = fmt::format(
      "<section><h1>{}</h1><p class=\"sub\">{} episodes of {} stores. Percent with 95 % intervals: "
      "Wilson for shares of episodes; for goals, partial scores and SPL a bootstrap over stores. p "
      "against the best, {}, on the same episodes: McNemar, exact, for strict successes; signs of "
      "the stores' sums flipped for partial scores.</p><table><tr><th>policy</th><th>strict</th>"
      "<th>partial</th><th>goals</th><th>SPL</th><th>clean</th><th>violations</th><th>p strict</th>"
      "<th>p partial</th></tr>",
      name_of(track.track),
      best.episodes,
      best.stores,
      escaped_markup(best.policy));
  for (const LeaderboardEntry& entry : track.entries)
    out += entry_row(entry);
  out += "</table>";
  if (std::ranges::none_of(track.entries, &LeaderboardEntry::floor))
    out += fmt::format("<p class=\"warn\">{}</p>", escaped_markup(no_floor_remark()));
  return out + repeated_lines(track) + power_table(track) + "</section>";
}

}  // namespace

std::string percent_with_interval(double value, double low, double high) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", 100 * value, 100 * low, 100 * high);
}

std::string percent_with_deviation(const RepeatedShare& share) {
  return fmt::format("{:.1f} ± {:.1f}", 100 * share.mean, 100 * share.deviation);
}

std::string spoken_repeated(const RepeatedPolicy& policy) {
  return fmt::format(
      "{}, {} repetitions: strict {}, partial {}, clean {} % (mean and standard "
      "deviation between them)",
      policy.policy,
      policy.repetitions,
      percent_with_deviation(policy.strict),
      percent_with_deviation(policy.partial),
      percent_with_deviation(policy.clean));
}

std::string spoken_entry(const LeaderboardEntry& entry) {
  return entry.repetition ? fmt::format("{} (repetition {})", entry.policy, *entry.repetition)
                          : entry.policy;
}

std::string leaderboard_sections(const Leaderboard& board) {
  std::string out = fmt::format(
      "<p class=\"sub\">episodes {} · split {} · instructions in {} · version {} "
      "· realism {}</p>",
      escaped_markup(spoken_episodes(board.set, board.episodes_hash)),
      name_of(board.split),
      escaped_markup(board.instructions),
      escaped_markup(board.version),
      escaped_markup(board.realism));
  if (const std::string remark = realism_remark(board.realism); !remark.empty())
    out += fmt::format("<p class=\"warn\">{}</p>", escaped_markup(remark));
  for (const LeaderboardTrack& track : board.tracks)
    out += track_section(track);
  return out;
}

std::string leaderboard_html(const Leaderboard& board) {
  return store::html_page("MarketGen leaderboard", leaderboard_sections(board));
}

}  // namespace marketgen::evaluation
