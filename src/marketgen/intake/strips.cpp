#include "intake/strips.h"

#include <algorithm>
#include <numeric>

#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

constexpr double min_share = 0.083;  // of a strip: what BSP ratios can express

const ProgramZone& zone_at(const StoreProgram& program, int index) {
  return program.zones[static_cast<std::size_t>(index)];
}

int min_length(const StripRoom& room) {
  return std::max(room.min_mm, static_cast<int>(room.length_mm * min_share));
}

// What is counted fits there.
int min_length(const StripRoom& room, const StoreProgram& program, const ProgramZone& zone) {
  const int counted = counted_length_mm(zone, *program.profile, room.depth_mm);
  return std::max(min_length(room), static_cast<int>(program.counted_share * counted));
}

// Lengths of all zones; those below the least are raised at the cost of the others.
std::vector<int> lengths_of(const std::vector<int>& zones,
                            const StoreProgram& program,
                            const StripRoom& room,
                            int length_mm) {
  const std::size_t count = zones.size();
  std::vector<int> lengths(count, 0);
  std::vector<bool> settled(count, false);
  int left = length_mm;
  for (std::size_t i = 0; i < count; ++i) {
    const ProgramZone& zone = zone_at(program, zones[i]);
    if (!zone.wanted_m2 || zone.wanted_how == plan::Comparison::at_most || count == 1) continue;
    lengths[i] = std::clamp(
        static_cast<int>(*zone.wanted_m2 * 1e6 / room.depth_mm), min_length(room), length_mm);
    settled[i] = true;
    left -= lengths[i];
  }
  for (bool changed = true; changed;) {
    changed = false;
    double targets = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!settled[i]) targets += std::max(0.1, zone_at(program, zones[i]).target_m2);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (settled[i]) continue;
      const double target = std::max(0.1, zone_at(program, zones[i]).target_m2);
      lengths[i] = static_cast<int>(std::max(0, left) * target / targets);
      const int least = min_length(room, program, zone_at(program, zones[i]));
      if (lengths[i] >= least) continue;
      lengths[i] = least;
      settled[i] = changed = true;
      left -= lengths[i];
      break;
    }
  }
  return lengths;
}

}  // namespace

Strip make_strip(const std::vector<int>& zones,
                 const StoreProgram& program,
                 const StripRoom& room) {
  Strip strip;
  const int length = room.length_mm - (static_cast<int>(zones.size()) - 1) * room.gap_mm;
  std::vector<int> lengths = lengths_of(zones, program, room, length);
  const int sum = std::accumulate(lengths.begin(), lengths.end(), 0);
  strip.crowding = std::max(0, sum - length) * 1e-3;
  *std::ranges::max_element(lengths) +=
      length - sum;  // rounding, or what zones of fixed size leave
  strip.slice = cut_slice(room.axis);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    strip.slice.add(zone_slice(zones[i]), lengths[i], room.gap_mm);
  }
  strip.slice = simplified(std::move(strip.slice));
  return strip;
}

}  // namespace marketgen::intake
