// A leaderboard as commands print it.
#pragma once
#include "evaluation/leaderboard.h"

namespace marketgen::app {

void print_leaderboard(const evaluation::Leaderboard& board);

}  // namespace marketgen::app
