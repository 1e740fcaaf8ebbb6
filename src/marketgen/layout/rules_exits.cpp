// Rules about ways out: how many doors, and how wide.
#include <fmt/format.h>

#include "layout/rule_facts.h"
#include "plan/egress.h"

namespace marketgen::layout {

Findings exits_few(const RuleFacts& facts) {
  const plan::WaysOut ways = plan::ways_out(facts.shell());
  const int needed = ways.needed_doors();
  if (ways.doors >= needed) return {};
  return {
      {"store",
       static_cast<double>(ways.doors),
       static_cast<double>(needed),
       fmt::format("{} doors lead outside; {:.0f} people, whom so large a floor is for, need {}",
                   ways.doors,
                   ways.people,
                   needed),
       std::nullopt}};
}

Findings egress_narrow(const RuleFacts& facts) {
  const plan::WaysOut ways = plan::ways_out(facts.shell());
  const double needed_mm = ways.needed_width_mm();
  if (ways.width_mm >= needed_mm) return {};
  return {{"store",
           static_cast<double>(ways.width_mm),
           needed_mm,
           fmt::format(
               "the doors that lead outside are {:.1f} m wide together; {:.0f} people need {:.1f}",
               1e-3 * ways.width_mm,
               ways.people,
               1e-3 * needed_mm),
           std::nullopt}};
}

}  // namespace marketgen::layout
