// What repair moves share: a candidate from patches, where a fault lies, who said what.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "layout/repair_moves.h"
#include "plan/patch.h"

namespace marketgen::layout {

constexpr double min_ratio = 0.08, max_ratio = 0.92;  // market-plan/1

// The plan with those patches, one after the other: repairs change plans as edits do. None where
// one of them cannot be carried out.
std::optional<RepairCandidate> candidate(const RepairTask& task,
                                         const std::vector<plan::Patch>& patches,
                                         std::string change);
void add_candidate(std::vector<RepairCandidate>& out,
                   const RepairTask& task,
                   const plan::Patch& patch,
                   std::string change);

// The zone that the fault lies in: ids of fixtures, runs and aisles begin with it.
std::optional<std::size_t> zone_of(const RepairTask& task);

// A person, in words, by a flag or with a picture: the value at `path`, or what lies below it.
bool somebody_said(const plan::Plan& plan, const std::string& path);

// One function a move of repair_moves.inc: the plans it would make, the gentlest change first.
#define REPAIR_MOVE(name, what) std::vector<RepairCandidate> propose_##name(const RepairTask& task);
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE

}  // namespace marketgen::layout
