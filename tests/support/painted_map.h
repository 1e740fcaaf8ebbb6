// Hand-made drawings of zones: rectangles painted on a map.
#pragma once
#include <vector>

#include "drawing/zone_drawing.h"
#include "geometry/rectangle.h"

namespace marketgen {

inline drawing::ZoneMap blank_map(int width_mm, int depth_mm, int cell_mm = 100) {
  drawing::ZoneMap map;
  map.columns = width_mm / cell_mm;
  map.rows = depth_mm / cell_mm;
  map.cell_mm = cell_mm;
  map.zone.assign(static_cast<std::size_t>(map.columns) * map.rows, drawing::ZoneMap::bare);
  return map;
}

inline void paint(drawing::ZoneMap& map, const RectMm& rect, int zone) {
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.columns; ++x) {
      const double px = (x + 0.5) * map.cell_mm, py = (y + 0.5) * map.cell_mm;
      if (px < rect.x0 || px >= rect.x1 || py < rect.y0 || py >= rect.y1) continue;
      map.zone[static_cast<std::size_t>(y) * map.columns + x] = static_cast<std::int16_t>(zone);
    }
  }
}

inline drawing::ZoneMap painted_map(int width_mm, int depth_mm, const std::vector<RectMm>& rects) {
  drawing::ZoneMap map = blank_map(width_mm, depth_mm);
  for (std::size_t i = 0; i < rects.size(); ++i)
    paint(map, rects[i], static_cast<int>(i));
  return map;
}

}  // namespace marketgen
