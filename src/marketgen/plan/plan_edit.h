// Changes of a plan's tree that keep every other row where it is: what patches are made of.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plan/plan.h"

namespace marketgen::plan {

std::optional<std::size_t> leaf_of(const Plan& plan, std::string_view zone);
std::optional<std::size_t> parent_of(const Plan& plan, std::size_t child);  // nothing for the root
std::optional<std::size_t> zone_index(const Plan& plan, std::string_view zone);
std::optional<std::size_t> node_index(const Plan& plan, std::string_view node);

// `wanted`, or "wanted-2", "wanted-3"…: no zone, node or opening has it.
std::string unused_id(const Plan& plan, const std::string& wanted);

// Who set what is at these pointers: what was said of them before goes, and the oldest where there
// would be too many.
void note_provenance(Plan& plan, const std::vector<std::string>& paths, Source by);

// A zone as its type's row has it: label, anchor, fixture kind and temperature; no id yet.
Zone usual_zone(const catalog::ZoneTypeRow& type, const catalog::Catalog& catalog);

// Takes the leaf and the cut above it out of the tree: what was cut off with it gets its floor.
// Pointers of the provenance that come after are counted anew, those into removed rows go.
// Precondition: not the root. Returns the cut.
Node take_out_leaf(Plan& plan, std::size_t leaf);

// Takes the zone's row out; its leaf is gone already. Provenance as above.
void erase_zone(Plan& plan, std::size_t zone);

// Puts `cut` in the place of `target`, with `target` and `leaf` as its children: the leaf on that
// side. split and children of the cut are set here.
void put_beside(Plan& plan, std::size_t target, Node cut, Node leaf, Wall side);

}  // namespace marketgen::plan
