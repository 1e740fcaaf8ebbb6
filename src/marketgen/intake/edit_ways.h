// Ways to change where things lie, for edit_words.cpp: each looks through plans that one or two
// patches make, and keeps those that do it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "intake/edit_words.h"
#include "plan/relation.h"

namespace marketgen::intake {

std::string name_of_zones(const plan::Plan& plan);  // "bakery, dairy, snacks"

// Ids of the zones of that type, largest first. Error: plan.unknown_reference when there is none.
Result<std::vector<std::string>> zones_called(const StandingStore& store, std::string_view type);

// A zone of the type (the relation's a) is put where the relation holds.
Result<std::vector<Way>> ways_to_move(const StandingStore& store, const plan::RelationTerms& terms);
// The largest zone of the type gets so much floor.
Result<std::vector<Way>> ways_to_resize(const StandingStore& store,
                                        std::string_view type,
                                        double area_m2);
// The same beside `first`, which comes before in every way; for a zone that needs more room.
std::vector<Way> with_more_room(const StandingStore& store,
                                const std::string& zone,
                                const Way& first);
// Another zone of the type, with so many fixtures where it is counted.
Result<std::vector<Way>> ways_to_add(const StandingStore& store,
                                     std::string_view type,
                                     std::optional<int> count);

}  // namespace marketgen::intake
