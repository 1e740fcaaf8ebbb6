// Seeded search for a good draft: several starts from the bands' habits, then small changes that
// are kept when they help.
#pragma once
#include "base/seed.h"
#include "intake/draft_score.h"

namespace marketgen::intake {

struct FoundDraft {
  FloorDraft draft;
  Candidate candidate;
  double penalty = 0;
  int evaluations = 0;
};

constexpr int max_starts = 12;  // of one search; more find nothing better

// What one start costs, whatever machine does it: a floor that is judged costs as much as it has
// zones and relations, of which each takes about a microsecond.
std::int64_t work_of_a_start(const StoreProgram& program, const Understanding& understanding);

// Deterministic for a seed. Precondition: the program has at least one zone, and 1 <= starts.
FoundDraft search_draft(const StoreProgram& program,
                        const Understanding& understanding,
                        const catalog::Catalog& catalog,
                        Seed seed,
                        int starts = max_starts);

}  // namespace marketgen::intake
