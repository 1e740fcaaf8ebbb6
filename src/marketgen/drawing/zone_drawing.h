// Drawings of a shop's zones: coloured, hatched or pencilled areas with names, within an outline.
//
// A drawing says where zones are and what is written on them, in the words of whoever drew it.
// Which kind of zone a word means is the language's business (intake/drawn_zones.h).
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "drawing/floor_plan.h"

namespace marketgen::drawing {

// Which zone each square of the floor belongs to. Row 0 is the south.
struct ZoneMap {
  static constexpr int outside = -2, bare = -1;  // no floor; floor of no zone

  int columns = 0, rows = 0;
  double cell_mm = 0;                // side of a square; (0, 0) is the shell's south-west corner
  std::vector<std::int16_t> zone{};  // row by row from the west: index of the zone, outside or bare

  int at(int column, int row) const {
    return zone[static_cast<std::size_t>(row) * columns + column];
  }
};

// Shelves that are drawn in a zone.
struct DrawnRuns {
  int count = 0;         // straight lines side by side
  bool along_x = false;  // they lie east-west
  double confidence = 0;
};

struct DrawnZone {
  std::string words;  // written on it, or beside its colour in the legend; UTF-8, may be empty
  bool from_legend = false;
  double words_confidence = 0;  // 0 to 1, of the reader of text
  std::array<std::uint8_t, 3> rgb{};
  double area_m2 = 0;
  std::optional<DrawnRuns> runs{};  // absent: no shelves are drawn there
};

struct ZoneDrawing {
  FloorPlan floor;                // walls and openings, as of a floor plan; its scale
  bool scale_is_guessed = false;  // nothing said it: the floor has ReadOptions::usual_area_m2
  std::vector<DrawnZone> zones;
  ZoneMap map;
  std::vector<std::string> warnings;  // for a person; those of the floor stand there
};

// PNG or JPEG: drawn, scanned, or photographed up to about 30 degrees askew. Scale as of floor
// plans (floor_plan.h), else from dimensions that are written along it ("20 m"), else guessed.
// Errors: those of read_floor_plan; drawing.no_zones when nothing within the outline tells one part
// of it from another; drawing.chart.
Result<ZoneDrawing> read_zone_drawing(const std::filesystem::path& path,
                                      const ReadOptions& options);
Result<ZoneDrawing> read_zone_drawing_bytes(std::string_view bytes,
                                            const std::string& where,
                                            const ReadOptions& options);

}  // namespace marketgen::drawing
