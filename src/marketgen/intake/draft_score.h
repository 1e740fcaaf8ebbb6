// How good a candidate is: a sum of penalties, smaller is better.
#pragma once
#include <array>
#include <vector>

#include "intake/candidate.h"

namespace marketgen::intake {

// A small preference of each zone for each band, different for every seed: what makes two stores of
// one prompt differ.
using BandTaste = std::vector<std::array<double, band_count>>;

struct ScoreInput {
  const StoreProgram& program;
  const Understanding& understanding;
  const BandTaste& taste;
};

// Wishes weigh most, then room, then the adjacency facts and habits of shop design, then taste.
// Infinite when it is more than `accepted`, which is often found out early.
double penalty_of(const FloorDraft& draft,
                  const Candidate& candidate,
                  const ScoreInput& input,
                  double accepted);

// What a zone's stance makes of a band, in penalty points; the search starts where this is least.
double band_habit(const ProgramZone& zone, Band band);

}  // namespace marketgen::intake
