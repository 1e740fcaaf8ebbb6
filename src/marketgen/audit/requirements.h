// Do the wishes hold? Each kind of requirement is measured on the finished scene; the plan is not
// looked at.
#pragma once
#include <vector>

#include "audit/audit.h"
#include "catalog/catalog.h"
#include "plan/requirement.h"
#include "scene/scene.h"

namespace marketgen::audit {

// One result per requirement, in order. `why` says what was measured.
std::vector<RequirementResult> check_requirements(
    const scene::Scene& scene,
    const catalog::Catalog& catalog,
    const std::vector<plan::Requirement>& requirements);

}  // namespace marketgen::audit
