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

}  // namespace marketgen::evaluation
