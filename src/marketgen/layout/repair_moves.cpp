#include "layout/repair_moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "layout/design.h"
#include "layout/repair_candidates.h"
#include "plan/bsp.h"
#include "plan/egress.h"
#include "plan/patch.h"
#include "plan/plan_edit.h"

namespace marketgen::layout {
namespace {

constexpr std::array<double, 4> door_steps{0.06, -0.06, 0.14, -0.14};  // of the wall
constexpr int shortest_run_mm = 4000;
constexpr std::size_t min_zones = 3;
constexpr double till_floor_mm = 6500;  // side of the floor a pair of lanes needs

bool somebody_asked_for(const plan::Plan& plan, std::size_t zone) {
  const std::string& id = plan.zones[zone].id;
  const bool related = std::ranges::any_of(plan.relations, [&](const plan::Relation& r) {
    return r.a == id || r.b == id || r.c == id || r.a == plan.zones[zone].type ||
           r.b == plan.zones[zone].type;
  });
  const bool said = somebody_said(plan, "/zones/" + std::to_string(zone));
  const bool changed = std::ranges::any_of(
      plan.overrides, [&](const plan::Override& o) { return o.fixture.starts_with(id + "/"); });
  return related || said || changed;
}

bool holds_tills(const plan::Zone& zone, const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(zone.fixture.kind);
  return kind != nullptr && kind->role == catalog::FixtureRole::checkout;
}

// Somebody drew the doors, or spoke of emergency exits: there are those and no others.
bool somebody_said_which_exits(const plan::Plan& plan) {
  for (std::size_t i = 0; i < plan.shell.openings.size(); ++i) {
    const std::string path = fmt::format("/shell/openings/{}", i);
    const bool drawn = std::ranges::any_of(plan.provenance, [&](const plan::Provenance& p) {
      return p.path == path && p.source == plan::Source::drawing;
    });
    const bool emergency = plan.shell.openings[i].kind == plan::OpeningKind::emergency;
    if (drawn || (emergency && somebody_said(plan, path))) return true;
  }
  return false;
}

}  // namespace

std::vector<RepairCandidate> propose_drop_endcaps(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || task.plan.zones[*zone].fixture.endcaps == plan::Endcaps::none) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->endcaps = plan::Endcaps::none;
  add_candidate(out, task, patch, "left out the endcaps of zone " + task.plan.zones[*zone].id);
  return out;
}

std::vector<RepairCandidate> propose_narrow_aisles(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int least = make_design(task.plan, task.catalog).min_aisle_mm();
  if (task.plan.zones[*zone].fixture.aisle_mm.value_or(least + 1) <= least) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->aisle_mm = least;
  add_candidate(out,
                task,
                patch,
                fmt::format("let zone {} have aisles of {} mm", task.plan.zones[*zone].id, least));
  return out;
}

// As wide as the rule wants them, where nobody said how wide they shall be.
std::vector<RepairCandidate> propose_widen_aisles(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || !task.plan.zones[*zone].fixture.aisle_mm) return {};
  const int now = *task.plan.zones[*zone].fixture.aisle_mm;
  const int wide = static_cast<int>(std::ceil(task.violation.limit));
  const std::string path = fmt::format("/zones/{}/fixture/aisle_mm", *zone);
  if (now >= wide || somebody_said(task.plan, path)) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->aisle_mm = wide;
  add_candidate(
      out,
      task,
      patch,
      fmt::format(
          "widened the aisles of zone {} from {} to {} mm", task.plan.zones[*zone].id, now, wide));
  return out;
}

std::vector<RepairCandidate> propose_shorten_runs(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone) return {};
  const int longest =
      std::min(task.plan.zones[*zone].fixture.run_max_mm, static_cast<int>(task.violation.value));
  const int shorter = std::max(shortest_run_mm, longest / 2);
  if (shorter >= task.plan.zones[*zone].fixture.run_max_mm) return {};
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.set_fixture.emplace().zone = task.plan.zones[*zone].id;
  patch.set_fixture->run_max_mm = shorter;
  add_candidate(
      out,
      task,
      patch,
      fmt::format(
          "put cross aisles into zone {}: runs of {} mm", task.plan.zones[*zone].id, shorter));
  return out;
}

std::vector<RepairCandidate> propose_move_opening(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  for (const plan::Opening& door : task.plan.shell.openings) {
    const bool named =
        task.violation.where == door.id || task.violation.message.ends_with(" " + door.id);
    const bool exit =
        task.violation.code == "CHECKOUT_NOT_AT_EXIT" && door.kind == plan::OpeningKind::exit;
    if (!named && !exit) continue;
    for (const double step : door_steps) {
      const double center = std::round(1e4 * (door.center + step)) * 1e-4;
      if (center <= 0 || center >= 1) continue;
      plan::Patch patch;
      patch.move_opening.emplace().opening = door.id;
      patch.move_opening->center = center;
      add_candidate(
          out,
          task,
          patch,
          fmt::format(
              "moved door {} along its wall from {:.2f} to {:.2f}", door.id, door.center, center));
    }
  }
  return out;
}

std::vector<RepairCandidate> propose_add_exits(const RepairTask& task) {
  if (somebody_said_which_exits(task.plan)) return {};
  std::vector<plan::Patch> patches;
  std::string change = "put emergency exits into the";
  for (plan::Opening& exit : plan::lacking_exits(task.plan.shell)) {
    change += fmt::format("{} {}", patches.empty() ? "" : ",", name_of(exit.wall));
    patches.emplace_back().add_opening = plan::AddOpening{std::move(exit)};
  }
  std::vector<RepairCandidate> out;
  if (patches.empty()) return out;
  if (auto made = candidate(task, patches, change + (patches.size() == 1 ? " wall" : " walls")))
    out.push_back(std::move(*made));
  return out;
}

// Cuts a part for tills off the leaf at the exit.
std::vector<RepairCandidate> propose_add_checkout(const RepairTask& task) {
  std::vector<RepairCandidate> out;
  const Floor floor = make_floor(task.plan.shell);
  const Doorway* exit = exit_of(floor, task.plan.shell);
  if (exit == nullptr) return out;
  const std::vector<RectMm> rects = plan::zone_rectangles(task.plan);
  std::size_t zone = 0;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    if (rects[i].contains(exit->approach.center())) zone = i;
  }
  for (const plan::Axis axis : {plan::Axis::x, plan::Axis::y}) {
    const int length = axis == plan::Axis::x ? rects[zone].width() : rects[zone].depth();
    const int at = (axis == plan::Axis::x ? exit->threshold[0] - rects[zone].x0
                                          : exit->threshold[1] - rects[zone].y0);
    const bool first = at < length / 2;
    plan::Patch patch;
    plan::AddZone& tills = patch.add_zone.emplace();
    tills.zone.id = plan::unused_id(task.plan, "checkout");
    tills.zone.type = "checkout";
    tills.zone.fixture.kind = "checkout_lane";
    tills.beside = task.plan.zones[zone].id;
    tills.side = axis == plan::Axis::x ? (first ? plan::Wall::west : plan::Wall::east)
                                       : (first ? plan::Wall::south : plan::Wall::north);
    tills.share = std::clamp(till_floor_mm / std::max(1, length), min_ratio, max_ratio);
    add_candidate(out, task, patch, "put a checkout zone at the exit");
  }
  return out;
}

// Never the place to pay.
std::vector<RepairCandidate> propose_drop_zone(const RepairTask& task) {
  const auto zone = zone_of(task);
  if (!zone || task.plan.zones.size() <= min_zones || somebody_asked_for(task.plan, *zone))
    return {};
  if (holds_tills(task.plan.zones[*zone], task.catalog)) return {};
  const std::string id = task.plan.zones[*zone].id;
  std::vector<RepairCandidate> out;
  plan::Patch patch;
  patch.drop_zone = {id};
  add_candidate(out, task, patch, "left out zone " + id + ", for which there is no room");
  return out;
}

std::string_view words_of(RepairMove move) {
  switch (move) {
#define REPAIR_MOVE(name, what) \
  case RepairMove::name:        \
    return what;
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE
  }
  return {};
}

std::vector<RepairCandidate> propose(RepairMove move, const RepairTask& task) {
  switch (move) {
#define REPAIR_MOVE(name, what) \
  case RepairMove::name:        \
    return propose_##name(task);
#include "layout/repair_moves.inc"
#undef REPAIR_MOVE
  }
  return {};
}

}  // namespace marketgen::layout
