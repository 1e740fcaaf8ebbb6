// Seeded search for a good draft: several starts from the bands' habits, then small changes that
// are kept when they help.
#pragma once
#include "base/seed.h"
#include "intake/draft_score.h"

namespace marketgen {

struct FoundDraft {
  FloorDraft draft;
  Candidate candidate;
  double penalty = 0;
  int evaluations = 0;
};

// Deterministic for a seed. Precondition: the program has at least one zone.
FoundDraft search_draft(const StoreProgram& program,
                        const Understanding& understanding,
                        const Catalog& catalog,
                        Seed seed);

}  // namespace marketgen
