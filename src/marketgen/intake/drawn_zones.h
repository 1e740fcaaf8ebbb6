// The zones of a drawing, by the types that the words on it name.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "drawing/zone_drawing.h"

namespace marketgen::intake {

struct Language;

struct DrawnZones {
  std::vector<std::string> types;  // zone type, by index in the map
  drawing::ZoneMap map;
  std::vector<std::string> warnings;  // words that name no zone, for a person
  // Shelves drawn in each zone, by index in `types`; no further than there are some.
  std::vector<std::optional<drawing::DrawnRuns>> runs{};

  // As the planner numbers them: "bakery", and "bakery-2" for the second one.
  std::vector<std::string> ids() const;
};

// What is written on a zone is read as a prompt is, so it may be of either language and have slips
// of the pen. A zone whose words name none is taken for the first of the `usual` zone types that is
// not drawn; where it is small, or none is left, its floor goes to the zone with which it has the
// longest border, and is bare where there is no such zone. Warnings say which.
DrawnZones named_by_words(const drawing::ZoneDrawing& drawing,
                          const Language& language,
                          const catalog::Catalog& catalog,
                          const std::vector<std::string>& usual);

}  // namespace marketgen::intake
