// What checks of requirements share: the facts of a scene, and verdicts with their reasons.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/requirement.h"
#include "scene/scene.h"

namespace marketgen::audit {

struct Verdict {
  bool met;
  std::string why;
};

// What every check may look at.
struct Facts {
  const scene::Scene& scene;
  const catalog::Catalog& catalog;
  std::vector<std::uint64_t> items_on_fixture;
};

Facts facts_of(const scene::Scene& scene, const catalog::Catalog& catalog);

// The number against the one that was asked for, by its comparison.
bool compares(const plan::Requirement& r, double measured, double tolerance = 1e-9);
// "at least ", "at most " or nothing.
std::string_view sign(plan::Comparison comparison);
Verdict number_verdict(const plan::Requirement& r,
                       double measured,
                       std::string_view what,
                       std::string_view unit,
                       double tolerance = 1e-9);

// Of that type or id.
bool is_of(const layout::LayoutZone& zone, const std::string& name);
std::vector<const layout::LayoutZone*> zones_of(const Facts& facts, const std::string& name);
// In a zone of that name; "" is the store.
bool in_zone(const Facts& facts, const layout::Fixture& fixture, const std::string& name);
// Whether what is asked of `zone` ("": of all but some) is asked of what stands there.
bool holds_for(const Facts& facts,
               const plan::Requirement& r,
               const std::string& zone,
               const layout::Fixture& fixture);
// Ambient shelving with several levels: what people mean by "shelves".
bool is_shelving(const Facts& facts, const layout::Fixture& fixture);

}  // namespace marketgen::audit
