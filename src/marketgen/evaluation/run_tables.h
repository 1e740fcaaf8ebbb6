// Tables and plots of a run's results, as parts of an HTML page.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "episodes/episode_result.h"

namespace marketgen::evaluation {

// Contacts by force class and everything else of the side effects: sums, and in how many episodes.
std::string ledger_table(const std::vector<episodes::EpisodeResult>& results);
// A bar for each episode, as long as its simulated time: green where all goals were reached.
std::string time_lines(const std::vector<episodes::EpisodeResult>& results);
// Goals by category and by shape, with intervals over stores; goods that the catalogue lacks are
// "unknown".
std::string goods_tables(const std::vector<episodes::EpisodeResult>& results,
                         const catalog::Catalog& catalog);

}  // namespace marketgen::evaluation
