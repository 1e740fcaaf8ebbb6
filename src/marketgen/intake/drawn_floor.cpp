#include "intake/drawn_floor.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "intake/drawn_tills.h"
#include "intake/fit_slices.h"
#include "intake/relation_geometry.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr double min_part = 0.15, max_part = 0.5;  // of a zone, for one that is not drawn

// The drawing's map in terms of the program's zones, with floor for those that are not drawn.
class ProgramMap {
 public:
  ProgramMap(StoreProgram& program, const Understanding& found)
      : program_(program), found_(found), map_(program.drawn->map) {
    const std::vector<std::string> ids = program.drawn->ids();
    std::vector<std::int16_t> becomes;
    for (const std::string& id : ids) {
      const auto zone = std::ranges::find(program.zones, id, &ProgramZone::id);
      becomes.push_back(zone == program.zones.end()
                            ? std::int16_t{drawing::ZoneMap::bare}
                            : static_cast<std::int16_t>(zone - program.zones.begin()));
    }
    for (std::int16_t& zone : map_.zone)
      if (zone >= 0) zone = becomes[static_cast<std::size_t>(zone)];
    for (const bool front : {true, false}) {
      for (std::size_t i = 0; i < program.zones.size(); ++i)
        if ((program.zones[i].stance == Stance::front) == front && squares(i) == 0) place(i);
    }
  }

  const drawing::ZoneMap& map() const { return map_; }

 private:
  std::int64_t squares(std::size_t zone) const {
    return std::ranges::count(map_.zone, static_cast<std::int16_t>(zone));
  }

  void place(std::size_t zone) {
    if (program_.zones[zone].stance != Stance::front)
      return take_from(largest(), zone, {map_.columns, map_.rows});
    const PointMm door = door_at_tills();
    const catalog::FixtureKind* kind = program_.zones[zone].kind;
    const bool asked = kind != nullptr && found_.find(Kind::fixture_count, kind->kind) != nullptr;
    const auto found = place_for_tills(map_, program_, zone, door, asked);
    if (!found) return take_from(largest(), zone, door);
    if (program_.zones[zone].count) program_.zones[zone].count = found->lanes;
    paint(found->squares, zone, [&](int at) { return at == found->giver; });
  }

  // Squares of the rectangle, of which those that `may` holds for become the zone's.
  template <class May>
  void paint(const RectMm& squares, std::size_t zone, May may) {
    for (int y = squares.y0; y < squares.y1; ++y) {
      for (int x = squares.x0; x < squares.x1; ++x) {
        std::int16_t& at = map_.zone[static_cast<std::size_t>(y) * map_.columns + x];
        if (at != drawing::ZoneMap::outside && may(at)) at = static_cast<std::int16_t>(zone);
      }
    }
  }

  RectMm bounds_of(std::size_t zone) const {
    RectMm box{map_.columns, map_.rows, 0, 0};
    for (int y = 0; y < map_.rows; ++y) {
      for (int x = 0; x < map_.columns; ++x) {
        if (map_.at(x, y) != static_cast<int>(zone)) continue;
        box = {std::min(box.x0, x),
               std::min(box.y0, y),
               std::max(box.x1, x + 1),
               std::max(box.y1, y + 1)};
      }
    }
    return box;
  }

  double square_m2() const {
    return 1e-6 * program_.width_mm * program_.depth_mm / (1.0 * map_.columns * map_.rows);
  }
  double area_m2(std::size_t zone) const {
    return square_m2() * static_cast<double>(squares(zone));
  }

  // The door at which people pay: the exit, else the entrance, else where a planner puts the exit.
  PointMm door_at_tills() const {
    const RectMm floor{0, 0, map_.columns, map_.rows};
    plan::Opening door{"", plan::OpeningKind::exit, entrance_wall_of(found_), 0.8, 2000};
    if (program_.shell) {
      for (const plan::OpeningKind kind : {plan::OpeningKind::entrance, plan::OpeningKind::exit}) {
        const auto drawn = std::ranges::find(program_.shell->openings, kind, &plan::Opening::kind);
        if (drawn != program_.shell->openings.end()) door = *drawn;
      }
    }
    return plan::point_inside(floor, door, 0);
  }

  std::size_t largest() const {
    std::size_t found = 0;
    for (std::size_t i = 1; i < program_.zones.size(); ++i)
      if (squares(i) > squares(found)) found = i;
    return found;
  }

  // The end of the giver's floor that is nearer to `near`, cut off across its longer side: one cut
  // more, and every other zone stays as it is drawn.
  void take_from(std::size_t giver, std::size_t zone, PointMm near) {
    const RectMm box = bounds_of(giver);
    if (box.empty()) return;
    const bool tills = program_.zones[zone].stance == Stance::front;
    const double part =
        tills ? max_part
              : std::clamp(program_.zones[zone].target_m2 / area_m2(giver), min_part, max_part);
    const PointMm center = box.center();
    RectMm end = box;
    if (box.width() >= box.depth()) {
      const int wide = std::max(1, static_cast<int>(part * box.width()));
      near[0] > center[0] ? end.x0 = box.x1 - wide : end.x1 = box.x0 + wide;
    } else {
      const int deep = std::max(1, static_cast<int>(part * box.depth()));
      near[1] > center[1] ? end.y0 = box.y1 - deep : end.y1 = box.y0 + deep;
    }
    paint(end, zone, [&](int at) { return at == static_cast<int>(giver); });
  }

  StoreProgram& program_;
  const Understanding& found_;
  drawing::ZoneMap map_;
};

bool is_drawn(const StoreProgram& program, const std::string& type) {
  return std::ranges::find(program.drawn->types, type) != program.drawn->types.end();
}

}  // namespace

DrawnFloor drawn_floor(StoreProgram& program, const Understanding& found) {
  const ProgramMap drawn(program, found);
  FittedSlices fitted =
      fit_slices(drawn.map(), program.zones.size(), program.width_mm, program.depth_mm);
  return {make_candidate(std::move(fitted.root), program, found), fitted.iou};
}

void settle_zones(const StoreProgram& program, Understanding& found) {
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::zone_absent || !is_drawn(program, wish.subject)) continue;
    found.conflicts.push_back({"zone " + wish.subject,
                               wish.text,
                               "the drawing's " + wish.subject,
                               "words win over a drawing"});
  }
  for (const ProgramZone& zone : program.zones) {
    const std::string& type = zone.type->type;
    const auto wish = std::ranges::find_if(found.requirements, [&](const plan::Requirement& one) {
      return one.subject == type || one.object == type;
    });
    if (is_drawn(program, type) || wish == found.requirements.end()) continue;
    found.conflicts.push_back({"zone " + type,
                               wish->text,
                               "the drawing, which has no such zone",
                               "words win over a drawing; the zone takes floor of drawn ones"});
  }
}

void settle_relations(const Candidate& candidate,
                      const StoreProgram& program,
                      Understanding& found,
                      plan::Plan& plan) {
  const plan::NamedFloor floor = named_floor(candidate, program);
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::relation) continue;
    const plan::RelationTerms terms = plan::terms_of(wish);
    const auto measure = plan::measure_relation(floor, terms);
    if (!measure || measure->slack_m() >= 0) continue;
    found.conflicts.push_back({"relation",
                               "the drawing: " + plan::words_of(floor, terms, measure),
                               wish.text,
                               "zones stand where they are drawn"});
    for (plan::Relation& relation : plan.relations) {
      const bool same =
          relation.kind == wish.relation && relation.a == wish.subject && relation.b == wish.object;
      if (same) relation.strength = plan::Strength::prefer;
    }
  }
}

}  // namespace marketgen::intake
