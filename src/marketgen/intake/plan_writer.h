// From wishes, program and floor to the plan itself, with the provenance of every value that
// somebody asked for.
#pragma once
#include "intake/brief.h"
#include "intake/candidate.h"
#include "intake/store_program.h"
#include "intake/understanding.h"

namespace marketgen::intake {

struct PlanSources {
  const Brief& brief;
  const Understanding& understanding;
  const StoreProgram& program;
  const Candidate& candidate;
  const catalog::Catalog& catalog;
};

plan::Plan write_plan(const PlanSources& sources);

}  // namespace marketgen::intake
