#include <array>

#include "base/text.h"
#include "layout/layout.h"
#include "layout/layout_rules.h"
#include "layout/rule_facts.h"

namespace marketgen::layout {
namespace {

using Evaluate = Findings (*)(const RuleFacts&);

constexpr std::array evaluators{
#define LAYOUT_RULE(code, severity, function, ...) static_cast<Evaluate>(&function),
#include "layout/layout_rules.inc"
#undef LAYOUT_RULE
};

}  // namespace

const std::vector<LayoutRule>& layout_rules() {
  using enum RepairMove;
  static const std::vector<LayoutRule> rules{
#define LAYOUT_RULE(code, severity, function, summary, source, ...) \
  {#code, Severity::severity, summary, source, {__VA_ARGS__}},
#include "layout/layout_rules.inc"
#undef LAYOUT_RULE
  };
  return rules;
}

RuleFacts gather_facts(const Layout& layout, const Design& design) {
  RuleFacts facts{layout, design, {}, {}, faces_of(layout.fixtures, design.catalog), {}, {}};
  for (const Fixture& fixture : layout.fixtures) {
    facts.footprints.push_back(footprint_of(fixture));
    facts.kinds.push_back(design.catalog.fixture_kind(fixture.kind));
  }
  facts.person = reach_of(design.floor, layout.shell, layout.fixtures, person_width_mm);
  facts.wheelchair =
      reach_of(design.floor, layout.shell, layout.fixtures, design.profile.wheelchair_mm);
  return facts;
}

std::string in_mm(double mm) {
  return with_thousands(static_cast<std::int64_t>(mm + 0.5)) + " mm";
}

std::vector<Violation> check_layout(const Layout& layout,
                                    const plan::Plan& plan,
                                    const catalog::Catalog& catalog) {
  Design design = make_design(plan, catalog);
  design.floor = make_floor(layout.shell);
  const RuleFacts facts = gather_facts(layout, design);
  std::vector<Violation> violations;
  const std::vector<LayoutRule>& rules = layout_rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    for (Finding& found : evaluators[i](facts)) {
      violations.push_back({std::string(rules[i].code),
                            rules[i].severity,
                            std::move(found.where),
                            found.value,
                            found.limit,
                            std::move(found.message),
                            found.at_mm});
    }
  }
  return violations;
}

}  // namespace marketgen::layout
