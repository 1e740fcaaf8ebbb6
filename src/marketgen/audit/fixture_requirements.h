// Requirements about fixtures and the goods on them, one check a kind.
#pragma once
#include "audit/requirement_facts.h"
#include "plan/requirement.h"

namespace marketgen::audit {

Verdict check_fixture_count(const Facts& facts, const plan::Requirement& r);
// Straight lines of modules that stand together: those of one run, a double-sided one or two back
// to back counting once where sides are asked for.
Verdict check_run_count(const Facts& facts, const plan::Requirement& r);
Verdict check_levels(const Facts& facts, const plan::Requirement& r);
Verdict check_shelf_pitch(const Facts& facts, const plan::Requirement& r);
Verdict check_endcaps(const Facts& facts, const plan::Requirement& r);
Verdict check_height(const Facts& facts, const plan::Requirement& r);
Verdict check_stock(const Facts& facts, const plan::Requirement& r);

}  // namespace marketgen::audit
