#include "layout/faces.h"

#include <algorithm>
#include <map>

namespace marketgen::layout {
namespace {

constexpr int module_joint_mm = 10;  // modules nearer than this stand together

using Line = std::vector<std::size_t>;  // modules of one run, from the low end

std::map<std::string, Line> lines_of(const std::vector<Fixture>& fixtures) {
  std::map<std::string, Line> lines;
  for (std::size_t i = 0; i < fixtures.size(); ++i)
    lines[fixtures[i].run].push_back(i);
  for (auto& [run, line] : lines) {
    std::ranges::sort(line, {}, [&](std::size_t i) {
      return along(footprint_of(fixtures[i]), facing_of(fixtures[i].yaw_deg)).from;
    });
  }
  return lines;
}

}  // namespace

bool stand_together(const Fixture& low, const Fixture& high) {
  const Side front = facing_of(low.yaw_deg);
  const int gap = along(footprint_of(high), front).from - along(footprint_of(low), front).to;
  return low.yaw_deg == high.yaw_deg && gap <= module_joint_mm;
}

std::vector<Face> faces_of(const std::vector<Fixture>& fixtures, const catalog::Catalog& catalog) {
  std::vector<Face> faces;
  for (const auto& [run, line] : lines_of(fixtures)) {
    for (std::size_t begin = 0; begin < line.size();) {
      const Fixture& first = fixtures[line[begin]];
      Face face{run,
                first.zone,
                footprint_of(first),
                facing_of(first.yaw_deg),
                0,
                catalog::FixtureRole::shelving,
                !first.endcap_of.empty()};
      std::size_t end = begin;
      for (; end < line.size() &&
             (end == begin || stand_together(fixtures[line[end - 1]], fixtures[line[end]]));
           ++end) {
        const RectMm rect = footprint_of(fixtures[line[end]]);
        face.rect = {std::min(face.rect.x0, rect.x0),
                     std::min(face.rect.y0, rect.y0),
                     std::max(face.rect.x1, rect.x1),
                     std::max(face.rect.y1, rect.y1)};
        const catalog::FixtureKind* kind = catalog.fixture_kind(fixtures[line[end]].kind);
        if (kind == nullptr) continue;
        face.role = kind->role;
        face.door_swing_mm = std::max(face.door_swing_mm, static_cast<int>(kind->door_swing_mm));
      }
      faces.push_back(face);
      if (first.sides == 2) {
        face.front = opposite(face.front);
        faces.push_back(face);
      }
      begin = end;
    }
  }
  return faces;
}

void mark_run_ends(std::vector<Fixture>& fixtures) {
  for (const auto& [run, line] : lines_of(fixtures)) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      Fixture& fixture = fixtures[line[k]];
      const bool low_free = k == 0 || !stand_together(fixtures[line[k - 1]], fixture);
      const bool high_free =
          k + 1 == line.size() || !stand_together(fixture, fixtures[line[k + 1]]);
      const Side left = left_of(facing_of(fixture.yaw_deg));
      const bool left_is_low = left == Side::west || left == Side::south;
      fixture.run_start = left_is_low ? low_free : high_free;
      fixture.run_end = left_is_low ? high_free : low_free;
    }
  }
}

}  // namespace marketgen::layout
