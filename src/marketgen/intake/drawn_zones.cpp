#include "intake/drawn_zones.h"

#include <algorithm>
#include <array>
#include <map>

#include "intake/language.h"
#include "intake/store_program.h"
#include "intake/understanding.h"

namespace marketgen::intake {
namespace {

constexpr int nameless = -1;
constexpr double min_guessed_share = 0.03;  // of the drawn floor; smaller ones are specks
constexpr int max_between_mm = 1000;        // of bare floor or a line, between neighbours

// Squares of zone `from` beside zones that have names, by the name's index.
std::map<int, int> borders_of(const drawing::ZoneMap& map,
                              int from,
                              const std::vector<int>& named) {
  constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const int reach = std::max(1, static_cast<int>(max_between_mm / std::max(1.0, map.cell_mm)));
  const auto next_zone = [&](int x, int y, std::array<int, 2> way) {
    for (int step = 1; step <= reach; ++step) {
      const int to_x = x + step * way[0], to_y = y + step * way[1];
      if (to_x < 0 || to_y < 0 || to_x >= map.columns || to_y >= map.rows) return from;
      const int zone = map.at(to_x, to_y);
      if (zone != drawing::ZoneMap::bare) return zone;
    }
    return from;
  };
  std::map<int, int> borders;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.columns; ++x) {
      if (map.at(x, y) != from) continue;
      for (const auto& way : ways) {
        const int zone = next_zone(x, y, way);
        if (zone < 0 || zone == from || named[static_cast<std::size_t>(zone)] == nameless) continue;
        ++borders[named[static_cast<std::size_t>(zone)]];
      }
    }
  }
  return borders;
}

// The first zone type that the words name; empty when they name none.
std::string type_in(const std::string& words,
                    const Language& language,
                    const catalog::Catalog& catalog) {
  const std::vector<std::string> types =
      named_zone_types(understand(words, language, catalog), catalog);
  return types.empty() ? "" : types.front();
}

// Of what a shop has on its floor: neither tills nor rooms behind.
std::string first_undrawn(const std::vector<std::string>& usual,
                          const std::vector<std::string>& drawn,
                          const catalog::Catalog& catalog) {
  for (const std::string& type : usual) {
    const catalog::ZoneTypeRow* row = catalog.zone_type(type);
    if (row == nullptr || row->fixture.empty()) continue;
    const catalog::FixtureKind* kind = catalog.fixture_kind(row->fixture);
    const bool sells = kind != nullptr && kind->role == catalog::FixtureRole::shelving;
    if (sells && std::ranges::find(drawn, type) == drawn.end()) return type;
  }
  return "";
}

}  // namespace

std::vector<std::string> DrawnZones::ids() const {
  std::vector<std::string> ids;
  std::map<std::string, int> count;
  for (const std::string& type : types)
    ids.push_back(zone_id(type, count[type]++));
  return ids;
}

DrawnZones named_by_words(const drawing::ZoneDrawing& drawing,
                          const Language& language,
                          const catalog::Catalog& catalog,
                          const std::vector<std::string>& usual) {
  DrawnZones drawn;
  drawn.map = drawing.map;
  std::vector<int> named;  // index in `types`, by zone of the drawing
  for (const drawing::DrawnZone& zone : drawing.zones) {
    const std::string type = type_in(zone.words, language, catalog);
    named.push_back(type.empty() ? nameless : static_cast<int>(drawn.types.size()));
    if (!type.empty()) drawn.types.push_back(type);
  }
  const auto written_on = [&](std::size_t zone) {
    return drawing.zones[zone].words.empty()
               ? std::string("nothing is written on a zone")
               : "\"" + drawing.zones[zone].words + "\" names no zone";
  };
  double drawn_m2 = 0;
  for (const drawing::DrawnZone& zone : drawing.zones)
    drawn_m2 += zone.area_m2;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i] != nameless || drawing.zones[i].area_m2 < min_guessed_share * drawn_m2) continue;
    const std::string type = first_undrawn(usual, drawn.types, catalog);
    if (type.empty()) continue;
    named[i] = static_cast<int>(drawn.types.size());
    drawn.types.push_back(type);
    drawn.warnings.push_back(written_on(i) + "; it is taken for " + type);
  }
  drawn.runs.resize(drawn.types.size());
  for (std::size_t i = 0; i < named.size(); ++i)
    if (named[i] != nameless)
      drawn.runs[static_cast<std::size_t>(named[i])] = drawing.zones[i].runs;
  std::vector<int> becomes = named;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i] != nameless) continue;
    const std::map<int, int> borders = borders_of(drawing.map, static_cast<int>(i), named);
    const auto longest = std::ranges::max_element(
        borders, {}, [](const std::pair<const int, int>& border) { return border.second; });
    if (longest != borders.end()) becomes[i] = longest->first;
    const std::string taker =
        longest == borders.end()
            ? "it stays bare"
            : "its floor goes to " + drawn.types[static_cast<std::size_t>(longest->first)];
    drawn.warnings.push_back(written_on(i) + "; " + taker);
  }
  for (std::int16_t& zone : drawn.map.zone) {
    if (zone < 0) continue;
    const int index = becomes[static_cast<std::size_t>(zone)];
    zone = static_cast<std::int16_t>(index == nameless ? drawing::ZoneMap::bare : index);
  }
  return drawn;
}

}  // namespace marketgen::intake
