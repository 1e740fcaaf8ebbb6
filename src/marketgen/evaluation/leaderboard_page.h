// A leaderboard as one self-contained HTML page.
#pragma once
#include <string>

#include "evaluation/leaderboard.h"

namespace marketgen::evaluation {

// Loads nothing. Every text of a file is escaped.
std::string leaderboard_html(const Leaderboard& board);
// The same as a part of a page: a table for each track, and how many episodes would be needed.
std::string leaderboard_sections(const Leaderboard& board);

// "47.0 (37.5 to 56.7)", in percent: of anything with low and high.
std::string percent_with_interval(double value, double low, double high);
// "47.0 ± 1.2", in percent.
std::string percent_with_deviation(const RepeatedShare& share);
// Its policy, and which repetition it is of, but for the first.
std::string spoken_entry(const LeaderboardEntry& entry);
// "oracle, 3 repetitions: strict ...": what several runs of a policy have in common.
std::string spoken_repeated(const RepeatedPolicy& policy);

}  // namespace marketgen::evaluation
