#include "layout/zone_faults.h"

#include <algorithm>
#include <array>

#include "layout/design.h"
#include "layout/layout_rules.h"
#include "layout/rule_facts.h"
#include "layout/zone_ground.h"

namespace marketgen::layout {
namespace {

struct ZoneRule {
  std::string_view code;
  Findings (*measure)(const RuleFacts&);
};
constexpr std::array<ZoneRule, 5> zone_rules{{{"ZONE_TOO_SMALL", &zone_too_small},
                                              {"COLD_SCATTERED", &cold_scattered},
                                              {"PRODUCE_FAR", &produce_far},
                                              {"RELATION_BROKEN", &relation_broken},
                                              {"RELATION_MISSED", &relation_missed}}};

Severity severity_of(std::string_view code) {
  return std::ranges::find(layout_rules(), code, &LayoutRule::code)->severity;
}

}  // namespace

FaultCount count_faults(const std::vector<Violation>& violations) {
  FaultCount count;
  for (const Violation& v : violations)
    ++(v.severity == Severity::hard ? count.hard : count.soft);
  return count;
}

bool is_about_zones(std::string_view code) {
  return std::ranges::find(zone_rules, code, &ZoneRule::code) != zone_rules.end();
}

FaultCount zone_faults(const plan::Plan& plan, const catalog::Catalog& catalog) {
  const Design design = make_design(plan, catalog);
  Layout bare;
  bare.shell = plan.shell;
  bare.zones = layout_zones(design);
  const RuleFacts facts{bare, design, {}, {}, {}, {}, {}};
  FaultCount count;
  for (const ZoneRule& rule : zone_rules) {
    const int found = static_cast<int>(rule.measure(facts).size());
    (severity_of(rule.code) == Severity::hard ? count.hard : count.soft) += found;
  }
  return count;
}

}  // namespace marketgen::layout
