#include "intake/drawn_floor.h"

#include <algorithm>
#include <optional>

#include "intake/fit_slices.h"
#include "intake/relation_geometry.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr double least_part = 0.2, most_part = 0.5;  // of a zone, for one that is not drawn
constexpr double tills_depth_share = 0.25, tills_width_share = 0.6;

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
        if ((program.zones[i].stance == Stance::front) == front && squares(i) == 0)
          front ? place_tills(i) : place_within_largest(i);
    }
  }

  const drawing::ZoneMap& map() const { return map_; }

 private:
  std::int64_t squares(std::size_t zone) const {
    return std::ranges::count(map_.zone, static_cast<std::int16_t>(zone));
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

  // Where along the entrance's wall the tills stand: at the exit, else at the end that is farther
  // from the entrance.
  double tills_center(plan::Wall front) const {
    std::optional<double> entrance;
    if (program_.shell) {
      for (const plan::Opening& opening : program_.shell->openings) {
        if (opening.wall != front) continue;
        if (opening.kind == plan::OpeningKind::exit) return opening.center;
        if (opening.kind == plan::OpeningKind::entrance && !entrance) entrance = opening.center;
      }
    }
    return entrance.value_or(0) > 0.5 ? 0 : 1;
  }

  // Tills share the strip: each takes the part of it that is left for it.
  void place_tills(std::size_t zone) {
    const plan::Wall front = entrance_wall_of(found_);
    const bool along_x = front == plan::Wall::south || front == plan::Wall::north;
    const int length = along_x ? map_.columns : map_.rows;
    const int depth = along_x ? map_.rows : map_.columns;
    const double length_mm = along_x ? program_.width_mm : program_.depth_mm;
    const double depth_mm = along_x ? program_.depth_mm : program_.width_mm;
    const double deep_mm = std::min<double>(usual_front_mm, tills_depth_share * depth_mm);
    const double wide_mm =
        std::clamp<double>(till_width_mm(program_.zones[zone], static_cast<int>(deep_mm)),
                           0.15 * length_mm,
                           tills_width_share * length_mm);
    const int wide = std::max(1, static_cast<int>(length * wide_mm / length_mm));
    const int deep = std::max(1, static_cast<int>(depth * deep_mm / depth_mm));
    const double center = tills_center(front) * length;
    int from = std::clamp(static_cast<int>(center - wide / 2.0), 0, length - wide);
    if (taken_ > 0)
      from =
          from > length / 2 ? std::max(0, from - taken_) : std::min(length - wide, from + taken_);
    taken_ += wide;
    RectMm rect{from, 0, from + wide, deep};
    if (front == plan::Wall::north) rect = {from, map_.rows - deep, from + wide, map_.rows};
    if (front == plan::Wall::west) rect = {0, from, deep, from + wide};
    if (front == plan::Wall::east) rect = {map_.columns - deep, from, map_.columns, from + wide};
    paint(rect, zone, [&](int) { return true; });
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

  void place_within_largest(std::size_t zone) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < program_.zones.size(); ++i)
      if (squares(i) > squares(largest)) largest = i;
    const RectMm box = bounds_of(largest);
    if (box.empty()) return;
    const double square_m2 =
        1e-6 * program_.width_mm * program_.depth_mm / (1.0 * map_.columns * map_.rows);
    const double area_m2 = square_m2 * static_cast<double>(squares(largest));
    const double part = std::clamp(program_.zones[zone].target_m2 / area_m2, least_part, most_part);
    RectMm end = box;
    if (box.width() >= box.depth())
      end.x0 = box.x1 - std::max(1, static_cast<int>(part * box.width()));
    else
      end.y0 = box.y1 - std::max(1, static_cast<int>(part * box.depth()));
    paint(end, zone, [&](int at) { return at == static_cast<int>(largest); });
  }

  const StoreProgram& program_;
  const Understanding& found_;
  drawing::ZoneMap map_;
  int taken_ = 0;  // of the tills' strip
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
