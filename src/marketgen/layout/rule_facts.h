// What the rules look at, found out once, and what they find.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "layout/design.h"
#include "layout/faces.h"
#include "layout/layout.h"
#include "layout/reach.h"

namespace marketgen::layout {

// One place where a rule is broken.
struct Finding {
  std::string where;
  double value = 0, limit = 0;
  std::string message;
  std::optional<PointMm> at_mm;
};
using Findings = std::vector<Finding>;

struct RuleFacts {
  const Layout& layout;
  const Design& design;
  std::vector<RectMm> footprints;                  // of layout.fixtures
  std::vector<const catalog::FixtureKind*> kinds;  // of layout.fixtures; null when unknown
  std::vector<Face> faces;
  Reach person, wheelchair;

  const catalog::ProfileRow& profile() const { return design.profile; }
  const catalog::Catalog& catalog() const { return design.catalog; }
  const plan::Shell& shell() const { return layout.shell; }
  bool is_checkout(std::size_t fixture) const {
    return kinds[fixture] != nullptr && kinds[fixture]->role == catalog::FixtureRole::checkout;
  }
  bool is_shelving(std::size_t fixture) const {
    return kinds[fixture] != nullptr && kinds[fixture]->role == catalog::FixtureRole::shelving;
  }
};

RuleFacts gather_facts(const Layout& layout, const Design& design);

// One function a rule; each returns every place where it is broken.
#define LAYOUT_RULE(code, severity, function, ...) Findings function(const RuleFacts& facts);
#include "layout/layout_rules.inc"
#undef LAYOUT_RULE

// "1,200 mm"
std::string in_mm(double mm);

}  // namespace marketgen::layout
