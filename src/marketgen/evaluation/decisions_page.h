// An episode's decisions as a self-contained HTML page: what the policy saw, took it for, tried and
// did, beside what was true.
#pragma once
#include <string>

#include "evaluation/decision_record.h"

namespace marketgen::evaluation {

// Loads nothing; every text is escaped.
std::string decisions_html(const EpisodeDecisions& decisions);

}  // namespace marketgen::evaluation
