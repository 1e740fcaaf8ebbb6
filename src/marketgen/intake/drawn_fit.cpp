#include "intake/drawn_fit.h"

#include <algorithm>
#include <cmath>

#include "intake/fit_slices.h"
#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

// The map with one zone only.
drawing::ZoneMap only(const drawing::ZoneMap& map, int zone) {
  drawing::ZoneMap one = map;
  for (std::int16_t& at : one.zone)
    if (at != drawing::ZoneMap::outside)
      at = at == zone ? std::int16_t{0} : std::int16_t{drawing::ZoneMap::bare};
  return one;
}

double rounded(double value, double steps) {
  return std::round(value * steps) / steps;
}

}  // namespace

DrawnFit drawn_fit(const DrawnZones& drawn, const plan::Plan& plan) {
  const std::vector<RectMm> built = plan::zone_rectangles(plan);
  const std::vector<std::string> ids = drawn.ids();
  const int width = plan.shell.width_mm, depth = plan.shell.depth_mm;
  const double square_m2 =
      1e-6 * width * depth / std::max(1.0, 1.0 * drawn.map.columns * drawn.map.rows);
  DrawnFit fit;
  std::vector<RectMm> rects(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    DrawnZoneFit& one = fit.zones.emplace_back();
    one.zone = ids[i];
    const auto squares = std::ranges::count(drawn.map.zone, static_cast<std::int16_t>(i));
    one.drawn_m2 = rounded(square_m2 * static_cast<double>(squares), 10);
    if (i < drawn.runs.size() && drawn.runs[i]) one.drawn_runs = drawn.runs[i]->count;
    const auto zone = std::ranges::find(plan.zones, ids[i], &plan::Zone::id);
    if (zone == plan.zones.end()) continue;
    rects[i] = built[static_cast<std::size_t>(zone - plan.zones.begin())];
    one.runs = zone->fixture.runs;
    one.iou =
        rounded(micro_iou(only(drawn.map, static_cast<int>(i)), {rects[i]}, width, depth), 1000);
  }
  for (std::size_t i = 0; i < plan.zones.size(); ++i)  // what the drawing does not have
    if (std::ranges::find(ids, plan.zones[i].id) == ids.end()) rects.push_back(built[i]);
  fit.iou = rounded(micro_iou(drawn.map, rects, width, depth), 1000);
  return fit;
}

}  // namespace marketgen::intake
