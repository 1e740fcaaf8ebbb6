#include "intake/drawn_floor.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
  ProgramMap(const StoreProgram& program, const Understanding& found)
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
    take_from(giver_of_tills(zone, door), zone, door);
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

  int squares_of(double mm) const {
    return static_cast<int>(std::ceil(mm * map_.columns / program_.width_mm));
  }

  // How much of the giver's longer side the tills need, in squares; none when they have no room.
  std::optional<int> length_for_tills(std::size_t tills, const RectMm& giver) const {
    const int deep = squares_of(usual_front_mm);
    const int wide = squares_of(till_width_mm(program_.zones[tills], usual_front_mm));
    const int shorter = std::min(giver.width(), giver.depth());
    const int longer = std::max(giver.width(), giver.depth());
    for (const auto& [across, along] : {std::pair{wide, deep}, std::pair{deep, wide}})
      if (across <= shorter && along <= max_part * longer) return along;
    return std::nullopt;
  }

  // Of the zones that have room for the tills the one nearest to the door; none: the largest one,
  // with as many tills as find room.
  std::size_t giver_of_tills(std::size_t tills, PointMm door) const {
    std::optional<std::size_t> nearest;
    const auto away = [&](std::size_t zone) {
      return geometry::distance_mm(bounds_of(zone), geometry::point_rect(door));
    };
    for (std::size_t i = 0; i < program_.zones.size(); ++i) {
      const bool gives = i != tills && program_.zones[i].stance != Stance::front &&
                         length_for_tills(tills, bounds_of(i)).has_value();
      if (gives && (!nearest || away(i) < away(*nearest))) nearest = i;
    }
    return nearest.value_or(largest());
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
    const int longer = std::max(box.width(), box.depth());
    double part = std::clamp(program_.zones[zone].target_m2 / area_m2(giver), min_part, max_part);
    if (program_.zones[zone].stance == Stance::front)
      part =
          1.0 * length_for_tills(zone, box).value_or(static_cast<int>(max_part * longer)) / longer;
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

  const StoreProgram& program_;
  const Understanding& found_;
  drawing::ZoneMap map_;
};

bool is_drawn(const StoreProgram& program, const std::string& type) {
  return std::ranges::find(program.drawn->types, type) != program.drawn->types.end();
}

}  // namespace

DrawnFloor drawn_floor(const StoreProgram& program, const Understanding& found) {
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
