#include "intake/drawn_runs.h"

#include <algorithm>
#include <string>

#include "layout/layout.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr double sure = 0.6;  // a lone stroke may be anything

std::string counted(int runs) {
  return std::to_string(runs) + (runs == 1 ? " run" : " runs");
}

// What the drawing has on the zone of that id.
std::optional<drawing::DrawnRuns> runs_of(const DrawnZones& drawn, const std::string& id) {
  const std::vector<std::string> ids = drawn.ids();
  const auto at = static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin());
  return at < drawn.runs.size() ? drawn.runs[at] : std::nullopt;
}

int side_across(const drawing::DrawnRuns& runs, const RectMm& floor) {
  return runs.along_x ? floor.depth() : floor.width();
}

// How many runs stand side by side on the zone's floor, with aisles of that width between them.
int runs_with_room(const ProgramZone& zone,
                   const drawing::DrawnRuns& runs,
                   const RectMm& floor,
                   int aisle_mm) {
  return std::max(1, (side_across(runs, floor) + aisle_mm) / (zone.kind->depth_mm + aisle_mm));
}

void lower(ProgramZone& zone, int runs, Understanding& found) {
  const int drawn = zone.drawn_runs->count;
  const std::string what = "runs of " + zone.id;
  std::erase_if(found.conflicts, [&](const Conflict& one) { return one.what == what; });
  found.conflicts.push_back({what,
                             "the zone's floor, which has room for " + counted(runs),
                             "the drawing: " + counted(drawn),
                             "shelves keep the aisles that people and robots need"});
  // Along walls as many as fit are more than a few of those that are drawn.
  const bool lost = runs <= 0 || (zone.stance == Stance::wall && runs < drawn);
  zone.main.runs = lost ? std::nullopt : std::optional(runs);
}

class RunsOnFloor {
 public:
  RunsOnFloor(StoreProgram& program, const Concessions& concessions, Understanding& found)
      : program_(program), concessions_(concessions), found_(found) {}

  void settle(ProgramZone& zone, const RectMm& floor) {
    const auto drawn = runs_of(*program_.drawn, zone.id);
    const bool shelves = zone.kind != nullptr && zone.kind->role == catalog::FixtureRole::shelving;
    if (!drawn || !shelves || drawn->confidence < sure) return;
    if (zone.main.runs || zone.main.count) return settle_words(zone, *drawn);
    zone.drawn_runs = drawn;
    const int room = runs_with_room(zone, *drawn, floor, program_.profile->minimum_aisle_mm);
    const auto conceded = concessions_.max_count.find(zone.type->type + "/runs");
    int runs = std::min(drawn->count, room);
    if (conceded != concessions_.max_count.end()) runs = std::min(runs, conceded->second);
    zone.main.runs = runs;
    if (runs < drawn->count) lower(zone, runs, found_);
  }

 private:
  void settle_words(const ProgramZone& zone, const drawing::DrawnRuns& drawn) {
    const auto wish = std::ranges::find_if(found_.requirements, [&](const plan::Requirement& one) {
      return one.kind == Kind::run_count && (one.object == zone.type->type || one.object.empty());
    });
    if (!zone.main.runs || *zone.main.runs == drawn.count || wish == found_.requirements.end())
      return;
    found_.conflicts.push_back({"runs of " + zone.id,
                                wish->text,
                                "the drawing: " + counted(drawn.count),
                                "words win over a drawing"});
  }

  StoreProgram& program_;
  const Concessions& concessions_;
  Understanding& found_;
};

}  // namespace

bool lower_runs(StoreProgram& program,
                const plan::Plan& plan,
                const catalog::Catalog& catalog,
                Understanding& found) {
  const Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(0));
  if (!layout.ok()) return false;
  bool lowered = false;
  for (const layout::Violation& fault : layout->violations) {
    if (fault.code != "COUNT_SHORT") continue;
    const auto zone = std::ranges::find_if(program.zones, [&](const ProgramZone& one) {
      return one.drawn_runs && one.main.runs && fault.where == one.id + "/runs";
    });
    if (zone == program.zones.end()) continue;
    lower(*zone, std::min(static_cast<int>(fault.value), *zone->main.runs - 1), found);
    lowered = true;
  }
  return lowered;
}

int drawn_aisle_mm(const ProgramZone& zone,
                   const RectMm& floor,
                   int usual_mm,
                   const catalog::ProfileRow& profile) {
  const int runs = std::max(1, zone.main.runs.value_or(1));
  const int left = side_across(*zone.drawn_runs, floor) - runs * zone.kind->depth_mm;
  return std::clamp(left / runs, std::min(profile.minimum_aisle_mm, usual_mm), usual_mm);
}

void settle_runs(StoreProgram& program,
                 const Candidate& candidate,
                 const Concessions& concessions,
                 Understanding& found) {
  RunsOnFloor runs(program, concessions, found);
  for (std::size_t i = 0; i < program.zones.size(); ++i)
    runs.settle(program.zones[i], candidate.rects[i]);
}

}  // namespace marketgen::intake
