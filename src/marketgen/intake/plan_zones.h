// The zones of a plan: fixtures and stock as the wishes, the profile and the floor have them.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "intake/plan_writer.h"

namespace marketgen::intake {

constexpr double untidy_jitter = 0.5;  // from here on, items stand in wrong places too
constexpr double untidy_misplaced = 0.03;

// Sets the fault of price tags that a wish for stock is about (tags_missing, tags_wrong_price,
// tags_wrong_product, tags_doubled) to this share; false when it is about something else.
bool set_price_tags(std::optional<plan::PriceTagSpec>& tags,
                    std::string_view subject,
                    double share);

// In the order of the program's zones.
std::vector<plan::Zone> zones_of(const PlanSources& sources);

// Boards of a gondola where nobody says how many.
int gondola_levels(int height_mm);

}  // namespace marketgen::intake
