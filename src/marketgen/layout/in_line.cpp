#include "layout/in_line.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "layout/accessories.h"
#include "layout/faces.h"
#include "layout/lists.h"

namespace marketgen::layout {
namespace {

constexpr std::size_t min_run = 3;  // modules of a run that has any
constexpr int max_recess_mm = 260;  // how much shallower than its neighbours, against a wall
constexpr int max_waist_mm = 100;   // the same over both sides of what stands free

using Modules = std::vector<Fixture*>;  // modules of one run side by side, from the low end

Span span_of(const Fixture& fixture) {
  return along(footprint_of(fixture), facing_of(fixture.yaw_deg));
}

class InLine {
 public:
  InLine(std::vector<Fixture>& fixtures, const Build& build) : build_(build) {
    std::map<std::pair<std::string, std::string>, Modules> runs;  // by zone and run
    for (Fixture& fixture : fixtures) {
      if (fixture.endcap_of.empty() && !is_accessory(fixture))
        runs[{fixture.zone, fixture.run}].push_back(&fixture);
    }
    for (auto& [run, line] : runs)
      add_lines(std::move(line));
  }

  void put(const InLineRow& row, std::size_t index) {
    const Design& design = build_.design;
    const plan::Zone& zone = design.plan.zones[index];
    const catalog::FixtureKind* kind = design.catalog.fixture_kind(row.kind);
    const bool sold = row.profiles.empty() || lists(row.profiles, design.plan.profile);
    if (kind == nullptr || !sold || !lists(row.zones, zone.type)) return;
    Stream draw = build_.seed.child("in_line").child(row.kind).child(zone.id).stream();
    if (!draw.chance(row.chance)) return;
    const std::vector<Modules> places = places_for(row, *kind, zone);
    if (places.empty()) return;
    const int last = static_cast<int>(places.size()) - 1;
    for (Fixture* module : places[static_cast<std::size_t>(draw.integer(0, last))]) {
      replace(*module, *kind, zone);
      replaced_.insert(module);
    }
  }

 private:
  // A run in lines without gaps.
  void add_lines(Modules run) {
    std::ranges::sort(run, {}, [](const Fixture* one) { return span_of(*one).from; });
    Modules line;
    for (Fixture* module : run) {
      if (!line.empty() && !stand_together(*line.back(), *module))
        lines_[line.front()->zone].push_back(std::exchange(line, {}));
      line.push_back(module);
    }
    if (!line.empty()) lines_[line.front()->zone].push_back(std::move(line));
  }

  // Modules side by side, as many as the row wants, none of them at an end of its line nor beside
  // one that was replaced.
  std::vector<Modules> places_for(const InLineRow& row,
                                  const catalog::FixtureKind& kind,
                                  const plan::Zone& zone) {
    std::vector<Modules> places;
    for (const Modules& line : lines_[zone.id]) {
      if (line.size() < min_run) continue;
      const std::size_t wanted = std::min(static_cast<std::size_t>(row.modules), line.size() - 2);
      for (std::size_t first = 1; first + wanted < line.size(); ++first) {
        Modules place(line.begin() + static_cast<std::ptrdiff_t>(first),
                      line.begin() + static_cast<std::ptrdiff_t>(first + wanted));
        const auto before = line.begin() + static_cast<std::ptrdiff_t>(first - 1);
        const auto behind = before + static_cast<std::ptrdiff_t>(wanted + 2);
        const bool alone = std::none_of(
            before, behind, [&](const Fixture* one) { return replaced_.contains(one); });
        if (alone && std::ranges::all_of(place, [&](const Fixture* module) {
              return fits(row, kind, zone, *module);
            }))
          places.push_back(std::move(place));
      }
    }
    return places;
  }

  bool fits(const InLineRow& row,
            const catalog::FixtureKind& kind,
            const plan::Zone& zone,
            const Fixture& module) const {
    const catalog::FixtureKind* now = build_.design.catalog.fixture_kind(module.kind);
    if (now == nullptr || now->generator != row.among || now->kind == kind.kind ||
        now->temperature != kind.temperature)
      return false;
    const auto [narrowest, widest] = std::ranges::minmax(kind.module_widths_mm);
    if (module.width_mm < narrowest || module.width_mm > widest) return false;
    if ((module.sides == 2) != kind.double_sided) return false;
    const double aisle_mm = wanted_aisle_mm(build_.design, zone);
    if (kind.door_swing_mm > now->door_swing_mm ||
        kind.front_clearance_mm > std::max(now->front_clearance_mm, aisle_mm))
      return false;
    if (kind.against_wall && !now->against_wall && !stands_at_wall(module)) return false;
    const int less = module.depth_mm - depth_of(kind, module);
    return less >= 0 && less <= (module.sides == 2 ? max_waist_mm : max_recess_mm) &&
           (module.sides == 2 || less == 0 || stands_at_wall(module));
  }

  static int depth_of(const catalog::FixtureKind& kind, const Fixture& module) {
    return std::clamp(module.depth_mm, kind.depth_range_mm[0], kind.depth_range_mm[1]);
  }

  bool stands_at_wall(const Fixture& module) const {
    constexpr int behind_mm = 100;
    const Side back = opposite(facing_of(module.yaw_deg));
    return !on_floor(build_.design.floor, strip_beyond(footprint_of(module), back, behind_mm));
  }

  // One that is shallower stays at the wall.
  void replace(Fixture& module, const catalog::FixtureKind& kind, const plan::Zone& zone) const {
    ModuleSpec spec = module_spec(build_.design, zone, kind);
    spec.depth_mm = depth_of(kind, module);
    Fixture unit = make_module(spec, zone);
    unit.id = module.id;
    unit.run = module.run;
    unit.yaw_deg = module.yaw_deg;
    unit.width_mm = module.width_mm;
    const RectMm floor = footprint_of(module);
    const RectMm rect =
        module.sides == 2 ? floor
                          : strip_inside(floor, opposite(facing_of(module.yaw_deg)), spec.depth_mm);
    unit.x_mm = rect.center()[0];
    unit.y_mm = rect.center()[1];
    module = std::move(unit);
  }

  const Build& build_;
  std::map<std::string, std::vector<Modules>> lines_;  // by zone
  std::set<const Fixture*> replaced_;
};

}  // namespace

const std::vector<InLineRow>& in_line_rows() {
#define LIST(...) \
  { __VA_ARGS__ }
#define IN_LINE(kind, among, zones, profiles, ...) {kind, among, zones, profiles, __VA_ARGS__},
  static const std::vector<InLineRow> rows{
#include "layout/in_line.inc"
  };
#undef IN_LINE
#undef LIST
  return rows;
}

void put_in_line(std::vector<Fixture>& fixtures, const Build& build) {
  if (build.design.plan.outfit != plan::Outfit::full) return;
  InLine in_line(fixtures, build);
  for (std::size_t i = 0; i < build.zones.size(); ++i) {
    if (build.zones[i].stands || is_described(build.design.plan, i)) continue;
    for (const InLineRow& row : in_line_rows())
      in_line.put(row, i);
  }
}

void close_joints_of_kinds(std::vector<Fixture>& fixtures) {
  std::map<std::string, Modules> lines;
  for (Fixture& fixture : fixtures)
    lines[fixture.run].push_back(&fixture);
  for (auto& [run, line] : lines) {
    std::ranges::sort(line, {}, [](const Fixture* one) { return span_of(*one).from; });
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      if (line[k]->kind == line[k + 1]->kind) continue;
      const Side left = left_of(facing_of(line[k]->yaw_deg));
      const bool left_is_low = left == Side::west || left == Side::south;
      (left_is_low ? line[k]->run_end : line[k]->run_start) = true;
      (left_is_low ? line[k + 1]->run_start : line[k + 1]->run_end) = true;
    }
  }
}

}  // namespace marketgen::layout
