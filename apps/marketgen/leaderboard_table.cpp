#include "leaderboard_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "evaluation/leaderboard_page.h"
#include "evaluation/table_remarks.h"
#include "say.h"

namespace marketgen::app {
namespace {

template <class Interval>
std::string with_interval(double value, const Interval& interval) {
  return evaluation::percent_with_interval(value, interval.low, interval.high);
}

std::string p_value(double p) {
  return p < 0.0001 ? "<.0001" : fmt::format("{:.4f}", p);
}

void print_entry(const evaluation::LeaderboardEntry& entry) {
  const auto& to_best = entry.to_best;
  say("{:<22} {:<22} {:<22} {:<22} {:<22} {:<22} {:<7} {:<8} {}\n",
      evaluation::spoken_entry(entry) + (entry.floor ? " (floor)" : ""),
      with_interval(entry.strict.share, entry.strict),
      with_interval(entry.partial.value, entry.partial),
      entry.spl ? with_interval(entry.spl->value, *entry.spl) : "",
      with_interval(entry.clean.share, entry.clean),
      with_interval(entry.violations.share, entry.violations),
      to_best ? p_value(to_best->p_strict_holm) : "",
      to_best ? p_value(to_best->p_partial_holm) : "",
      entry.commit);
}

void print_repeated(const evaluation::LeaderboardTrack& track) {
  for (const evaluation::RepeatedPolicy& policy : track.repeated)
    say("{}\n", evaluation::spoken_repeated(policy));
}

std::string needed(const std::vector<evaluation::PowerRow>& power) {
  std::string text;
  for (const evaluation::PowerRow& row : power)
    text += fmt::format("{:<10}", row.episodes);
  return text;
}

void print_power(const evaluation::LeaderboardTrack& track) {
  say("\nepisodes to tell a difference of so many points (80 % power, 5 % error), as alike within "
      "a "
      "store as these\n{:<22} {:<10}{}\n",
      "",
      "likeness",
      "2         5         10        20");
  for (const evaluation::LeaderboardEntry& entry : track.entries) {
    say("{:<22} {:<10.2f}{}\n",
        evaluation::spoken_entry(entry),
        entry.likeness,
        needed(entry.power));
    if (entry.to_best)
      say("{:<22} {:<10}{}\n",
          "  beside " + entry.to_best->against,
          "",
          needed(entry.to_best->power));
  }
}

}  // namespace

void print_leaderboard(const evaluation::Leaderboard& board) {
  say("episodes {}, version {}, realism {}\n",
      evaluation::spoken_episodes(board.set, board.episodes_hash),
      board.version,
      board.realism);
  if (const std::string remark = evaluation::realism_remark(board.realism); !remark.empty())
    say("{}\n", remark);
  for (const evaluation::LeaderboardTrack& track : board.tracks) {
    const evaluation::LeaderboardEntry& best = track.entries.front();
    say("\n{}: {} episodes of {} stores; percent with 95 % intervals; p against {} (Holm)\n",
        name_of(track.track),
        best.episodes,
        best.stores,
        best.policy);
    say("{:<22} {:<22} {:<22} {:<22} {:<22} {:<22} {:<7} {:<8} {}\n",
        "policy",
        "strict",
        "partial",
        "SPL",
        "clean",
        "violations",
        "strict",
        "partial",
        "commit");
    for (const evaluation::LeaderboardEntry& entry : track.entries)
      print_entry(entry);
    if (std::ranges::none_of(track.entries, &evaluation::LeaderboardEntry::floor))
      say("{}\n", evaluation::no_floor_remark());
    print_repeated(track);
    print_power(track);
  }
}

}  // namespace marketgen::app
