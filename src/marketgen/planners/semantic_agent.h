// The agent for one zone: its fixtures and its goods.
#pragma once
#include <string>
#include <vector>

#include "planners/spatial_agent.h"

namespace marketgen::planners {

// What a semantic agent answers.
struct ZoneProposal {
  plan::FixtureSpec fixture;
  plan::StockSpec stock;
  std::string reason;

  static constexpr auto fields = field_list(
      field("fixture", &ZoneProposal::fixture, "its fixtures; null: as is usual", required()),
      field("stock", &ZoneProposal::stock, "its goods", required()),
      field("reason", &ZoneProposal::reason, "one sentence", required(), at_most_bytes(600)));
};

// Asks for every zone of the plan, several at a time. A zone whose agent fails keeps what it has;
// `failures` gets a line for each. Values that words decided are kept.
plan::Plan furnish_zones(const llm::LanguageModel& model,
                         const plan::Plan& plan,
                         const Assignment& assignment,
                         std::vector<std::string>& failures);

}  // namespace marketgen::planners
