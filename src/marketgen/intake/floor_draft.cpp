#include "intake/floor_draft.h"

#include <algorithm>
#include <optional>

#include "intake/core_columns.h"
#include "intake/strips.h"
#include "intake/zone_sizes.h"
#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

constexpr int door_side_mm = 500;  // floor kept free beside a door (layout: approach_side_mm)
constexpr int wide_door_mm = 2000;
constexpr int narrow_door_mm = 1500;
constexpr double small_store_m2 = 220;
constexpr int min_cabinet_mm = 2100;     // a cabinet and a half: shorter is no department
constexpr int min_front_mm = 3400;       // trolleys and baskets take part of a front zone's window
constexpr int min_department_mm = 2000;  // behind corner tills
constexpr int roomy_store_mm =
    18000;  // from this depth on, aisles before cold cabinets have their full width
constexpr double band_share =
    0.0825;  // of what it is cut from: the least that BSP ratios can express

class FloorBuilder {
 public:
  FloorBuilder(const FloorDraft& draft,
               const StoreProgram& program,
               const catalog::Catalog& catalog,
               int width_mm,
               int depth_mm)
      : draft_(draft), program_(program), profile_(*program.profile), catalog_(catalog) {
    floor_.width_mm = width_mm;
    floor_.depth_mm = depth_mm;
    const bool small = program.area_m2() < small_store_m2;
    floor_.entrance_width_mm = floor_.exit_width_mm = small ? narrow_door_mm : wide_door_mm;
    floor_.run_aisle_mm = program.aisle_mm.value_or(profile_.secondary_aisle_mm);
  }

  DraftedFloor build() {
    if (draft_.corner_tills) {
      build_with_corner();
    } else {
      build_with_front();
    }
    keep_doors_apart();
    floor_.root = simplified(std::move(floor_.root));
    floor_.rects =
        zone_rects(floor_.root, {0, 0, floor_.width_mm, floor_.depth_mm}, program_.zones.size());
    return std::move(floor_);
  }

 private:
  const ProgramZone& zone(int index) const {
    return program_.zones[static_cast<std::size_t>(index)];
  }

  bool any_cold(Band band) const {
    return std::ranges::any_of(draft_.band(band), [&](int z) { return zone(z).cold; });
  }

  // ---- Bands along walls ----

  int gap_before(Band band) const {
    if (!any_cold(band)) return std::max(floor_.run_aisle_mm, profile_.secondary_aisle_mm);
    const bool roomy = std::min(floor_.width_mm, floor_.depth_mm) >= roomy_store_mm;
    const int cold =
        roomy ? profile_.cold_aisle_mm : (profile_.main_aisle_mm + profile_.cold_aisle_mm) / 2;
    return std::max(floor_.run_aisle_mm, cold);
  }

  int own_depth(int index, bool deep) const {
    const bool tables = zone(index).stance == Stance::hall &&
                        zone(index).type->temperature == catalog::Storage::ambient;
    return deep && tables ? hall_depth_mm(zone(index), profile_, catalog_)
                          : wall_depth_mm(zone(index), catalog_);
  }

  int band_depth(Band band, int length_mm) const {
    const bool deep =
        (band == Band::west && draft_.deep_west) || (band == Band::east && draft_.deep_east);
    int depth = 0;
    for (const int z : draft_.band(band))
      depth = std::max(depth, own_depth(z, deep));
    return std::max(depth, asked_depth(band, length_mm));
  }

  static bool is_asked(const ProgramZone& zone) {
    return zone.wanted_m2 && zone.wanted_how != plan::Comparison::at_most;
  }

  // How deep a band so long is for the floor that was asked for in it; the other zones of it keep
  // a department each.
  int asked_depth(Band band, int length_mm) const {
    constexpr double max_share = 0.5;  // of the shorter side of the floor
    double asked_m2 = 0;
    int others_mm = 0;
    for (const int z : draft_.band(band)) {
      if (is_asked(zone(z)))
        asked_m2 += *zone(z).wanted_m2;
      else
        others_mm += min_front_mm;
    }
    if (asked_m2 <= 0) return 0;
    const int free_mm = std::max(length_mm - others_mm, length_mm / 2);
    const int deepest = static_cast<int>(max_share * std::min(floor_.width_mm, floor_.depth_mm));
    return std::min(deepest, static_cast<int>(1e6 * asked_m2 / std::max(1, free_mm)));
  }

  Slice strip_slice(Band band, plan::Axis axis, int length_mm, int depth_mm) {
    const Strip strip = make_strip(
        draft_.band(band),
        program_,
        {axis, length_mm, depth_mm, 0, band == Band::front ? min_front_mm : min_cabinet_mm});
    floor_.crowding += strip.crowding;
    const double metres = 1e-3 * length_mm / static_cast<double>(draft_.band(band).size());
    for (const int z : draft_.band(band)) {
      if (is_asked(zone(z))) continue;
      floor_.waste_m2 += metres * 1e-3 * std::max(0, depth_mm - own_depth(z, true));
    }
    return strip.slice;
  }

  // ---- Middle: west band, core, east band ----

  // Columns from west to east; where runs lie along the front and have room for that, rows from
  // south to north.
  Core core_of(const CoreRoom& room) const {
    const std::vector<int>& zones = draft_.band(Band::core);
    if (!program_.across || room.width_mm < min_cell_mm)
      return make_core(zones, program_, room, draft_.stacked_core);
    const bool at_back_wall = draft_.band(Band::north).empty();
    Core core = make_core(zones,
                          program_,
                          {room.depth_mm, room.width_mm, room.run_aisle_mm, false, at_back_wall},
                          draft_.stacked_core);
    core.slice = transposed(std::move(core.slice));
    return core;
  }

  // With corner tills the middle ends at the till column instead of at one of the walls.
  Slice middle(int width_mm, int depth_mm, bool to_west_wall, bool to_east_wall) {
    const int west = to_west_wall ? band_depth(Band::west, depth_mm) : 0;
    const int east = to_east_wall ? band_depth(Band::east, depth_mm) : 0;
    const int west_gap = west > 0 ? gap_before(Band::west) : 0;
    const int east_gap = east > 0 ? gap_before(Band::east) : 0;
    const bool has_core = !draft_.band(Band::core).empty();
    const int core_width = width_mm - west - west_gap - east - east_gap;
    Slice slice = cut_slice(plan::Axis::x);
    if (west > 0) {
      slice.add(strip_slice(Band::west, plan::Axis::y, depth_mm, west),
                has_core ? west : width_mm - east - east_gap,
                0);
    }
    if (has_core) {
      const Core core = core_of({core_width,
                                 depth_mm,
                                 floor_.run_aisle_mm,
                                 to_west_wall && west == 0,
                                 to_east_wall && east == 0});
      floor_.crowding += core.crowding + std::max(0, plan::min_node_side_mm - core_width) * 1e-3;
      floor_.run_aisle_mm = core.run_aisle_mm;
      floor_.runs = core.runs;
      slice.add(core.slice, core_width, west_gap);
    }
    if (east > 0) {
      slice.add(strip_slice(Band::east, plan::Axis::y, depth_mm, east),
                has_core || west > 0 ? east : width_mm,
                east_gap);
    }
    return simplified(std::move(slice));
  }

  // What lies between the front and the back wall, with the back band.
  void add_back(
      Slice& slice, Slice before_back, int depth_mm, int back_mm, int gap_mm, int gap_before_mm) {
    slice.add(std::move(before_back), depth_mm, gap_before_mm);
    if (back_mm > 0) {
      slice.add(strip_slice(Band::north, plan::Axis::x, floor_.width_mm, back_mm), back_mm, gap_mm);
    }
  }

  struct Back {
    int band_mm = 0, gap_mm = 0;
  };
  Back back_of(int body_mm) const {
    Back back{band_depth(Band::north, floor_.width_mm), 0};
    if (back.band_mm == 0) return back;
    back.gap_mm = gap_before(Band::north);
    back.band_mm =
        std::max(back.band_mm, static_cast<int>((body_mm - back.gap_mm) * band_share) + 1);
    return back;
  }

  void need(int size_mm, int min_mm) { floor_.crowding += std::max(0, min_mm - size_mm) * 1e-3; }

  // ---- Tills along the front ----

  void build_with_front() {
    const int depth = floor_.depth_mm;
    const int gap = std::max(profile_.checkout_clear_mm, profile_.secondary_aisle_mm);
    const int front =
        std::max(front_depth_mm(program_, catalog_, std::min(gap, profile_.checkout_clear_mm)),
                 static_cast<int>((depth - gap) * band_share) + 1);
    const int body = depth - front - gap;
    const Back back = back_of(body);
    const int middle_depth = body - back.band_mm - back.gap_mm;
    need(middle_depth, 2600);
    Slice slice = cut_slice(plan::Axis::y);
    slice.add(front_row(front), front, 0);
    Slice upper = cut_slice(plan::Axis::y);
    const bool empty_middle = draft_.band(Band::west).empty() && draft_.band(Band::core).empty() &&
                              draft_.band(Band::east).empty();
    if (!empty_middle) {
      add_back(upper,
               middle(floor_.width_mm, middle_depth, true, true),
               middle_depth,
               back.band_mm,
               back.gap_mm,
               0);
    } else if (back.band_mm > 0) {
      upper.add(strip_slice(Band::north, plan::Axis::x, floor_.width_mm, body), body, 0);
    }
    if (!upper.parts.empty())
      slice.add(simplified(std::move(upper)), body, gap);
    else if (slice.parts.size() == 1)
      slice.sizes_mm[0] = depth;
    floor_.root = std::move(slice);
  }

  // Tills from the entrance's side outwards, as one slice.
  Slice till_slice(int width_mm, int front_mm) {
    Slice slice = cut_slice(plan::Axis::x);
    std::vector<int> tills = draft_.tills;
    if (!draft_.tills_east) std::ranges::reverse(tills);
    int used = 0;
    for (const int z : tills)
      used += till_width_mm(zone(z), front_mm);
    const int spare = width_mm - used;  // the lanes get it, or lack it
    for (const int z : tills) {
      const int own = till_width_mm(zone(z), front_mm);
      slice.add(zone_slice(z),
                std::max(plan::min_node_side_mm, own + (z == draft_.tills[0] ? spare : 0)),
                0);
    }
    return slice;
  }

  int tills_width(int front_mm) const {
    int width = 0;
    for (const int z : draft_.tills)
      width += till_width_mm(zone(z), front_mm);
    return width;
  }

  Slice front_row(int front_mm) {
    const std::vector<int>& zones = draft_.band(Band::front);
    const int width = floor_.width_mm;
    if (zones.empty()) return lone_tills(front_mm);
    const int entrance_gap =
        std::max(profile_.main_aisle_mm, floor_.entrance_width_mm + 2 * door_side_mm);
    const std::size_t before = std::clamp<std::size_t>(draft_.entrance_gap, 1, zones.size());
    const bool at_tills = before == zones.size();
    const int till_gap = at_tills ? entrance_gap : profile_.secondary_aisle_mm;
    const int inner_gap = at_tills ? 0 : entrance_gap;
    int tills = tills_width(front_mm);
    const int for_zones = width - tills - till_gap - inner_gap;
    need(for_zones, min_front_mm * static_cast<int>(zones.size()));
    // Zones far from the tills, then those between the entrance and the tills.
    std::vector<int> far(zones.begin(), zones.begin() + static_cast<std::ptrdiff_t>(before));
    std::vector<int> near(zones.begin() + static_cast<std::ptrdiff_t>(before), zones.end());
    int far_mm = near.empty() ? for_zones : share_of(far, near, for_zones);
    if (const auto door = asked_door_mm()) {
      const int least = std::min(for_zones, min_front_mm * static_cast<int>(far.size()));
      const int most = for_zones - min_front_mm * static_cast<int>(near.size());
      const int gap = at_tills ? till_gap : inner_gap;
      far_mm = std::clamp(*door - gap / 2, least, std::max(least, most));
      if (at_tills) tills += for_zones - far_mm;
    }
    Slice row = cut_slice(plan::Axis::x);
    row.add(front_strip(far, far_mm, front_mm), far_mm, 0);
    if (!near.empty()) {
      row.add(front_strip(near, for_zones - far_mm, front_mm), for_zones - far_mm, inner_gap);
    }
    row.add(simplified(till_slice(tills, front_mm)), tills, till_gap);
    const int door = far_mm + (at_tills ? till_gap : inner_gap) / 2;
    set_doors(door, width - exit_from_end(tills));
    if (!draft_.tills_east) mirror(row);
    return row;
  }

  // Where the middle of the entrance was asked to be, for tills in the east.
  std::optional<int> asked_door_mm() const {
    if (!program_.entrance_at) return std::nullopt;
    const double at = draft_.tills_east ? *program_.entrance_at : 1 - *program_.entrance_at;
    return static_cast<int>(at * floor_.width_mm);
  }

  int share_of(const std::vector<int>& far, const std::vector<int>& near, int length_mm) const {
    double a = 0, b = 0;
    for (const int z : far)
      a += zone(z).target_m2 + 1;
    for (const int z : near)
      b += zone(z).target_m2 + 1;
    return std::clamp(static_cast<int>(length_mm * a / (a + b)),
                      std::min(min_front_mm, length_mm / 2),
                      std::max(length_mm - min_front_mm, length_mm / 2));
  }

  Slice front_strip(const std::vector<int>& zones, int length_mm, int depth_mm) {
    const Strip strip =
        make_strip(zones, program_, {plan::Axis::x, length_mm, depth_mm, 0, min_front_mm});
    floor_.crowding += strip.crowding;
    return strip.slice;
  }

  // Nothing but tills: shoppers come in at the far end of the till zone.
  Slice lone_tills(int front_mm) {
    const int width = floor_.width_mm;
    set_doors(floor_.entrance_width_mm / 2 + door_side_mm,
              width - std::min(width / 4, exit_from_end(tills_width(front_mm))));
    need(width, tills_width(front_mm) + floor_.entrance_width_mm);
    return simplified(till_slice(width, front_mm));
  }

  // From the wall at the tills' end to the middle of the exit: before the lanes, or past the desk.
  int exit_from_end(int tills_mm) const {
    const catalog::FixtureKind* kind =
        draft_.tills.empty() ? nullptr : zone(draft_.tills.front()).kind;
    if (kind == nullptr || !kind->is_desk()) return tills_mm / 2;
    return desk_room_mm(*kind) + floor_.exit_width_mm / 2;
  }

  // Centres for tills in the east; mirrored when they are in the west.
  void set_doors(int entrance_mm, int exit_mm) {
    floor_.entrance_mm = draft_.tills_east ? entrance_mm : floor_.width_mm - entrance_mm;
    floor_.exit_mm = draft_.tills_east ? exit_mm : floor_.width_mm - exit_mm;
  }

  static void mirror(Slice& row) {
    std::ranges::reverse(row.parts);
    std::ranges::reverse(row.sizes_mm);
    std::ranges::reverse(row.gaps_mm);
  }

  // ---- Tills in a corner ----

  void build_with_corner() {
    const int width = floor_.width_mm, depth = floor_.depth_mm;
    const Back back = back_of(depth);
    const int lower = depth - back.band_mm - back.gap_mm;
    const int front = front_depth_mm(program_, catalog_, profile_.checkout_clear_mm);
    const int entrance_gap =
        std::max(profile_.main_aisle_mm, floor_.entrance_width_mm + 2 * door_side_mm);
    const Band side = draft_.tills_east ? Band::east : Band::west;
    const int column = std::max(tills_width(front), band_depth(side, lower));
    const int body = width - column - entrance_gap;
    // Shelves along a wall alone are served from the entrance's aisle.
    const Band far = draft_.tills_east ? Band::west : Band::east;
    const bool wall_only = draft_.band(Band::core).empty() && draft_.band(Band::front).empty();
    need(body, wall_only ? band_depth(far, lower) : 2600);
    set_doors(body + entrance_gap / 2, width - exit_from_end(column));
    Slice row = cut_slice(plan::Axis::x);
    row.add(corner_body(body, lower), body, 0);
    row.add(till_column(side, column, lower, front), column, entrance_gap);
    if (!draft_.tills_east) mirror(row);
    Slice slice = cut_slice(plan::Axis::y);
    add_back(slice, std::move(row), lower, back.band_mm, back.gap_mm, 0);
    floor_.root = std::move(slice);
  }

  // The middle, with a band along the front window when there are front zones.
  Slice corner_body(int width_mm, int depth_mm) {
    const std::vector<int>& zones = draft_.band(Band::front);
    const int front = band_depth(Band::front, width_mm);
    const int gap = zones.empty() ? 0 : gap_before(Band::front);
    const int rest = depth_mm - front - gap;
    need(rest, 2600);
    Slice inner = middle(width_mm, rest, draft_.tills_east, !draft_.tills_east);
    if (zones.empty()) return inner;
    Slice slice = cut_slice(plan::Axis::y);
    slice.add(strip_slice(Band::front, plan::Axis::x, width_mm, front), front, 0);
    slice.add(std::move(inner), rest, gap);
    return slice;
  }

  Slice till_column(Band side, int width_mm, int depth_mm, int front_mm) {
    const int gap = profile_.checkout_clear_mm;
    const int rest = depth_mm - front_mm - gap;
    if (draft_.band(side).empty()) {
      need(min_department_mm, rest);  // the floor behind the tills would stay empty
      return simplified(till_slice(width_mm, front_mm));
    }
    need(rest, min_department_mm);
    Slice slice = cut_slice(plan::Axis::y);
    slice.add(simplified(till_slice(width_mm, front_mm)), front_mm, 0);
    slice.add(strip_slice(side, plan::Axis::y, rest, width_mm), rest, gap);
    return slice;
  }

  // Doors lie within the wall and do not touch one another; a short wall gets narrower ones.
  void keep_doors_apart() {
    const int widest = (floor_.width_mm - 3 * door_side_mm) / 2;
    floor_.entrance_width_mm = std::min(floor_.entrance_width_mm, widest);
    floor_.exit_width_mm = std::min(floor_.exit_width_mm, widest);
    const auto within = [&](int center, int door) {
      const int margin = door / 2 + door_side_mm;
      return std::clamp(center, margin, floor_.width_mm - margin);
    };
    floor_.entrance_mm = within(floor_.entrance_mm, floor_.entrance_width_mm);
    floor_.exit_mm = within(floor_.exit_mm, floor_.exit_width_mm);
    const int least = (floor_.entrance_width_mm + floor_.exit_width_mm) / 2 + door_side_mm;
    if (std::abs(floor_.entrance_mm - floor_.exit_mm) >= least) return;
    const int away = draft_.tills_east ? -least : least;
    floor_.entrance_mm = within(floor_.exit_mm + away, floor_.entrance_width_mm);
    floor_.exit_mm = within(floor_.entrance_mm - away, floor_.exit_width_mm);
  }

  const FloorDraft& draft_;
  const StoreProgram& program_;
  const catalog::ProfileRow& profile_;
  const catalog::Catalog& catalog_;
  DraftedFloor floor_;
};

}  // namespace

DraftedFloor build_floor(const FloorDraft& draft,
                         const StoreProgram& program,
                         const catalog::Catalog& catalog,
                         int width_mm,
                         int depth_mm) {
  return FloorBuilder(draft, program, catalog, width_mm, depth_mm).build();
}

}  // namespace marketgen::intake
