#include "layout/overrides.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <set>

#include "base/text.h"
#include "layout/accessories.h"
#include "layout/module_spec.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int max_place_mm = 200'000;  // a store is at most so wide

std::string pointer(std::size_t index, std::string_view field) {
  return "/overrides/" + std::to_string(index) + "/" + std::string(field);
}

Error unknown_reference(std::size_t index,
                        std::string_view field,
                        std::string_view what,
                        const std::string& name,
                        const std::vector<std::string_view>& known) {
  return {"plan.unknown_reference",
          pointer(index, field),
          "there is no " + std::string(what) + " \"" + name + "\"" + did_you_mean(name, known)};
}

Result<int> whole_number(const plan::Override& change, std::size_t index, const IntRange& range) {
  int number = 0;
  const char* end = change.value.data() + change.value.size();
  const auto [stop, fault] = std::from_chars(change.value.data(), end, number);
  if (fault != std::errc{} || stop != end || number < range[0] || number > range[1]) {
    return Error{"plan.bad_value",
                 pointer(index, "value"),
                 "\"" + change.value + "\" is not a whole number from " + std::to_string(range[0]) +
                     " to " + std::to_string(range[1]) +
                     ", which this kind of fixture allows for " + change.field_name};
  }
  return number;
}

// Levels spread over the height again.
void respace(Fixture& fixture) {
  const int room = fixture.height_mm - fixture.base_mm;
  fixture.spacing_mm =
      fixture.levels <= 1
          ? std::clamp(room, 0, max_spacing_mm)
          : std::min(room / fixture.levels, (room - min_top_gap_mm) / (fixture.levels - 1));
}

Result<void> change_kind(Fixture& fixture,
                         const plan::Override& change,
                         std::size_t index,
                         const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(change.value);
  if (kind == nullptr) {
    std::vector<std::string_view> known;
    for (const catalog::FixtureKind& row : catalog.fixture_kinds)
      known.push_back(row.kind);
    return unknown_reference(index, "value", "fixture kind", change.value, known);
  }
  const bool fits =
      fixture.depth_mm >= kind->depth_range_mm[0] && fixture.depth_mm <= kind->depth_range_mm[1];
  if (!fits) {
    return Error{"plan.bad_value",
                 pointer(index, "value"),
                 "a " + kind->name + " is " + std::to_string(kind->depth_range_mm[0]) + " to " +
                     std::to_string(kind->depth_range_mm[1]) + " mm deep; \"" + fixture.id +
                     "\" is " + std::to_string(fixture.depth_mm) + " mm deep"};
  }
  fixture.kind = kind->kind;
  fixture.height_mm =
      std::clamp(fixture.height_mm, kind->height_range_mm[0], kind->height_range_mm[1]);
  fixture.levels = kind->levels;
  fixture.base_mm = kind->base_mm;
  fixture.sides = kind->double_sided ? fixture.sides : 1;
  fixture.material = kind->material;
  fixture.color = kind->color;
  respace(fixture);
  return {};
}

Result<void> change_material(Fixture& fixture,
                             const plan::Override& change,
                             std::size_t index,
                             const catalog::Catalog& catalog) {
  const catalog::MaterialRow* material = catalog.material(change.value);
  if (material == nullptr) {
    std::vector<std::string_view> known;
    for (const catalog::MaterialRow& row : catalog.materials)
      known.push_back(row.id);
    return unknown_reference(index, "value", "material", change.value, known);
  }
  fixture.material = material->id;
  fixture.color = material->color;
  return {};
}

bool is_place(const plan::Override& change) {
  return change.field_name == "x_mm" || change.field_name == "y_mm";
}

// move_runs has moved all others.
Result<void> check_may_move(const Fixture& fixture, std::size_t index) {
  if (!is_accessory(fixture)) return {};
  return Error{"plan.bad_value",
               pointer(index, "field"),
               "\"" + fixture.id +
                   "\" stands beside what its zone is for, wherever there is room: its place "
                   "cannot be pinned; that of a run of shelves can"};
}

// Whether two fixtures stand back to back, with at most the floor for staff between them.
bool back_to_back(const Fixture& a, const Fixture& b) {
  constexpr int between_mm = 1000;
  const Side back = opposite(facing_of(a.yaw_deg));
  return a.zone == b.zone && a.kind == b.kind && a.sides == 1 && b.sides == 1 &&
         facing_of(b.yaw_deg) == back &&
         overlap(strip_beyond(footprint_of(a), back, between_mm), footprint_of(b));
}

// The runs that move with one: itself and what stands back to back with it.
std::set<std::string> moving_runs(const std::vector<Fixture>& fixtures, const std::string& run) {
  std::set<std::string> runs{run};
  for (const Fixture& own : fixtures) {
    if (own.run != run) continue;
    for (const Fixture& other : fixtures)
      if (other.run != run && back_to_back(own, other)) runs.insert(other.run);
  }
  return runs;
}

bool on_zone(const Fixture& fixture, const std::vector<ZoneFloor>& floors) {
  return std::ranges::any_of(floors, [&](const ZoneFloor& floor) {
    return floor.zone == fixture.zone && overlap(floor.rect, footprint_of(fixture));
  });
}

Error beside_its_zone(const Fixture& fixture, std::size_t index) {
  return {"plan.bad_value",
          pointer(index, "value"),
          "\"" + fixture.id + "\" would not stand on the floor of its zone \"" + fixture.zone +
              "\"; pin a place on it, or set the fixture free (set_override without a value)"};
}

Result<void> move_run(std::vector<Fixture>& fixtures,
                      const Fixture& pinned,
                      const plan::Override& change,
                      std::size_t index,
                      const std::vector<ZoneFloor>& floors) {
  int Fixture::*const axis = change.field_name == "x_mm" ? &Fixture::x_mm : &Fixture::y_mm;
  MARKETGEN_TRY(const int to, whole_number(change, index, {0, max_place_mm}));
  const int by = to - pinned.*axis;
  if (by == 0) return {};
  const std::set<std::string> runs = moving_runs(fixtures, pinned.run);
  bool stands = false;  // a run along a wall reaches over half of the gap to the next zone
  for (Fixture& fixture : fixtures) {
    if (!runs.contains(fixture.run) && !runs.contains(fixture.endcap_of)) continue;
    fixture.*axis += by;
    stands |= on_zone(fixture, floors);
  }
  if (!stands) return beside_its_zone(pinned, index);
  return {};
}

Result<void> apply(Fixture& fixture,
                   const plan::Override& change,
                   std::size_t index,
                   const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  if (change.field_name == "kind") return change_kind(fixture, change, index, catalog);
  if (change.field_name == "material") return change_material(fixture, change, index, catalog);
  if (change.field_name == "color") {
    fixture.color = change.value;
    return {};
  }
  if (kind != nullptr && change.field_name == "levels") {
    MARKETGEN_TRY(fixture.levels, whole_number(change, index, kind->level_range));
    respace(fixture);
    return {};
  }
  if (kind != nullptr && change.field_name == "height_mm") {
    MARKETGEN_TRY(fixture.height_mm, whole_number(change, index, kind->height_range_mm));
    respace(fixture);
    return {};
  }
  if (is_place(change)) return check_may_move(fixture, index);
  return Error{"plan.bad_value",
               pointer(index, "field"),
               "\"" + change.field_name +
                   "\" cannot be overridden; levels, height_mm, color, material, kind, x_mm and "
                   "y_mm can"};
}

// The kind's generator knows what it can build.
Result<void> check_buildable(const Fixture& fixture,
                             const plan::Look& look,
                             std::size_t index,
                             const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
  if (kind == nullptr) return {};
  const auto model = assets::make_fixture_model(fixture_shape(fixture, *kind, look), catalog);
  if (model.ok() || model.error().code != "assets.bad_row") return {};
  return Error{"plan.bad_value", pointer(index, "value"), model.error().message};
}

}  // namespace

std::vector<plan::Override> pinned_places(const plan::Plan& plan) {
  std::vector<plan::Override> places;
  std::ranges::copy_if(plan.overrides, std::back_inserter(places), is_place);
  return places;
}

Result<void> move_runs(std::vector<Fixture>& fixtures,
                       const plan::Plan& plan,
                       const std::vector<ZoneFloor>& floors) {
  for (std::size_t i = 0; i < plan.overrides.size(); ++i) {
    const plan::Override& change = plan.overrides[i];
    if (!is_place(change)) continue;
    const auto fixture = std::ranges::find(fixtures, change.fixture, &Fixture::id);
    if (fixture == fixtures.end() || is_accessory(*fixture)) continue;
    const Fixture pinned = *fixture;
    MARKETGEN_CHECK(move_run(fixtures, pinned, change, i, floors));
  }
  return {};
}

Result<void> apply_overrides(std::vector<Fixture>& fixtures,
                             const plan::Plan& plan,
                             const catalog::Catalog& catalog) {
  for (std::size_t i = 0; i < plan.overrides.size(); ++i) {
    const plan::Override& change = plan.overrides[i];
    const auto fixture = std::ranges::find(fixtures, change.fixture, &Fixture::id);
    if (fixture == fixtures.end()) {
      std::vector<std::string_view> known;
      for (const Fixture& f : fixtures)
        known.push_back(f.id);
      return unknown_reference(i, "fixture", "fixture", change.fixture, known);
    }
    MARKETGEN_CHECK(apply(*fixture, change, i, catalog));
    MARKETGEN_CHECK(check_buildable(*fixture, plan.look, i, catalog));
  }
  return {};
}

}  // namespace marketgen::layout
