#include "layout/module_spec.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "io/json.h"

namespace marketgen::layout {
namespace {

constexpr int back_panel_mm = 60;  // between the shelves of the two sides of a gondola
constexpr int slot_pitch_mm = 50;  // European gondolas: shelves hang every 50 mm
constexpr int max_fill_changes =
    6;  // preferred modules that may be given up for others to fill a run better

// What stands along the walls of a zone whose own fixtures stand free.
struct WallKind {
  std::string_view generator;  // of the zone's main fixture
  std::string_view kind;       // along its walls
};
constexpr std::array<WallKind, 10> wall_kinds{{{"gondola", "wall_unit"},
                                               {"serve_over", "serve_over"},
                                               {"produce_table", "produce_table"},
                                               {"wine_rack", "wine_rack"},
                                               {"bin", "wall_unit"},
                                               {"pallet", "wall_unit"},
                                               {"promo_stack", "wall_unit"},
                                               {"island_freezer", "glass_door_freezer"},
                                               {"chest_freezer", "glass_door_freezer"},
                                               {"endcap", "wall_unit"}}};

bool nothing_wished(const plan::FixtureSpec& spec) {
  static const std::string untouched = io::write_json(plan::FixtureSpec{});
  return io::write_json(spec) == untouched;
}

const catalog::FixtureKind* main_kind(const plan::Zone& zone, const catalog::Catalog& catalog) {
  const catalog::ZoneTypeRow* type = catalog.zone_type(zone.type);
  const catalog::FixtureKind* usual =
      type == nullptr ? nullptr : catalog.fixture_kind(type->fixture);
  if (type != nullptr && type->fixture.empty()) return nullptr;
  if (usual != nullptr && nothing_wished(zone.fixture)) return usual;
  const catalog::FixtureKind* wished = catalog.fixture_kind(zone.fixture.kind);
  if (wished == nullptr || usual == nullptr) return wished != nullptr ? wished : usual;
  // "gondola" is what a wish says that names no kind: goods that need a cabinet or a counter get
  // theirs.
  const bool unnamed = zone.fixture.kind == plan::FixtureSpec{}.kind;
  const bool unsuited = usual->temperature != catalog::Storage::ambient ||
                        usual->role != catalog::FixtureRole::shelving;
  return unnamed && unsuited ? usual : wished;
}

const catalog::FixtureKind* wall_kind(const catalog::FixtureKind& main,
                                      const catalog::Catalog& catalog) {
  if (main.role != catalog::FixtureRole::shelving) return nullptr;
  if (main.against_wall) return &main;
  for (const WallKind& row : wall_kinds) {
    if (row.generator != main.generator) continue;
    const catalog::FixtureKind* kind = catalog.fixture_kind(row.kind);
    return kind != nullptr && kind->temperature == main.temperature ? kind : nullptr;
  }
  return nullptr;
}

int clamped(int value, const IntRange& range) {
  return std::clamp(value, range[0], range[1]);
}

void choose_depth_and_height(ModuleSpec& spec,
                             const Design& design,
                             const plan::FixtureSpec& wish) {
  const catalog::FixtureKind& kind = *spec.kind;
  spec.depth_mm = kind.depth_mm;
  spec.height_mm = kind.height_mm;
  if (kind.generator == "gondola") {
    spec.depth_mm = 2 * design.profile.gondola_shelf_mm + back_panel_mm;
    spec.height_mm = design.profile.gondola_height_mm;
  }
  if (kind.generator == "gondola" && spec.sides == 1) {
    spec.depth_mm = design.profile.gondola_shelf_mm + back_panel_mm;
  }
  spec.depth_mm = clamped(wish.depth_mm.value_or(spec.depth_mm), kind.depth_range_mm);
  spec.height_mm = clamped(wish.height_mm.value_or(spec.height_mm), kind.height_range_mm);
}

// Levels and their spacing within the height; the height gives way only when nobody asked for it.
void choose_levels(ModuleSpec& spec, const plan::FixtureSpec& wish) {
  const catalog::FixtureKind& kind = *spec.kind;
  spec.base_mm = kind.base_mm;
  spec.levels = kind.levels;
  const int room = spec.height_mm - spec.base_mm;
  if (wish.spacing_mm && !wish.levels && kind.levels > 0) {
    spec.levels = clamped(1 + (room - min_top_gap_mm) / *wish.spacing_mm, kind.level_range);
  }
  if (wish.levels) spec.levels = clamped(*wish.levels, kind.level_range);
  if (spec.levels <= 1) {
    spec.spacing_mm = std::clamp(room, 0, max_spacing_mm);
    return;
  }
  if (wish.spacing_mm && !wish.height_mm) {
    const int needed = spec.base_mm + (spec.levels - 1) * *wish.spacing_mm + min_top_gap_mm;
    spec.height_mm = clamped(std::max(spec.height_mm, needed), kind.height_range_mm);
  }
  const int even = (spec.height_mm - spec.base_mm) / spec.levels;
  const int most = (spec.height_mm - spec.base_mm - min_top_gap_mm) / (spec.levels - 1);
  spec.spacing_mm = std::min(wish.spacing_mm.value_or(std::min(most, even)), most);
  const bool slotted = !wish.spacing_mm && spec.spacing_mm > 4 * slot_pitch_mm;
  if (slotted) spec.spacing_mm -= spec.spacing_mm % slot_pitch_mm;
}

void choose_widths(ModuleSpec& spec, const Design& design, const plan::FixtureSpec& wish) {
  spec.widths_mm = spec.kind->module_widths_mm;
  const auto prefer = [&](int width) {
    std::erase(spec.widths_mm, width);
    spec.widths_mm.insert(spec.widths_mm.begin(), width);
  };
  const std::string& generator = spec.kind->generator;
  // A make that a full store has is built in its row's widths.
  const bool any_width = design.plan.outfit != plan::Outfit::full || spec.kind->kind == generator;
  if ((generator == "gondola" || generator == "wall_unit") && any_width)
    prefer(design.profile.module_mm);
  if (wish.module_mm) spec.widths_mm = {*wish.module_mm};
}

void choose_finish(ModuleSpec& spec, const Design& design, const plan::FixtureSpec& wish) {
  spec.material = spec.kind->material;
  spec.color = spec.kind->color;
  const catalog::MaterialRow* look = design.catalog.material(design.plan.look.fixture);
  if (takes_look(*spec.kind) && look != nullptr) {
    spec.material = look->id;
    spec.color = look->color;
  }
  if (wish.material) spec.material = *wish.material;
  if (wish.material && !wish.color) {
    const catalog::MaterialRow* row = design.catalog.material(*wish.material);
    if (row != nullptr) spec.color = row->color;
  }
  if (wish.color) spec.color = *wish.color;
}

int sum(const std::vector<int>& widths) {
  return std::accumulate(widths.begin(), widths.end(), 0);
}

// Whether the kind is the one that was asked for, or what this store has in its place.
bool is_or_is_made_as(const Design& design,
                      const plan::Zone& zone,
                      const catalog::FixtureKind& kind,
                      const catalog::FixtureKind* asked) {
  return asked != nullptr && (&kind == asked || &kind == &design.makes.of(*asked, zone.type));
}

// What `also` says of the kind that lines the walls. Else a zone that says how far its boards are
// apart has all its shelves alike: wall units, too, take levels, distance and height.
plan::FixtureSpec wish_along_walls(const Design& design,
                                   const plan::Zone& zone,
                                   const catalog::FixtureKind& kind) {
  plan::FixtureSpec wish;
  for (std::size_t k = 0; zone.also && k < zone.also->size(); ++k)
    if (is_or_is_made_as(design, zone, kind, design.catalog.fixture_kind((*zone.also)[k].kind)))
      return (*zone.also)[k];
  if (kind.generator != "wall_unit" || !zone.fixture.spacing_mm) return wish;
  wish.height_mm = zone.fixture.height_mm;
  wish.levels = zone.fixture.levels;
  wish.spacing_mm = zone.fixture.spacing_mm;
  return wish;
}

// The zone's module by itself, as it would be built.
Result<assets::FixtureModel> model_of(const Design& design,
                                      const plan::Zone& zone,
                                      const catalog::FixtureKind& kind) {
  const ModuleSpec spec = module_spec(design, zone, kind);
  Fixture fixture = make_module(spec, zone);
  fixture.width_mm = spec.widths_mm.front();
  return assets::make_fixture_model(fixture_shape(fixture, kind, design.plan.look), design.catalog);
}

// What a plan may say about the size of a module.
struct ModuleMeasure {
  std::string_view name;
  std::optional<int> plan::FixtureSpec::*field;
};
constexpr std::array<ModuleMeasure, 5> module_measures{
    {{"module_mm", &plan::FixtureSpec::module_mm},
     {"depth_mm", &plan::FixtureSpec::depth_mm},
     {"height_mm", &plan::FixtureSpec::height_mm},
     {"levels", &plan::FixtureSpec::levels},
     {"spacing_mm", &plan::FixtureSpec::spacing_mm}}};

// The measure without which the zone's module can be built: one alone, else the last of the first
// few that are too much together. Nothing when it is the kind's row that cannot be built.
std::optional<std::string_view> measure_at_fault(const Design& design,
                                                 const plan::Zone& zone,
                                                 const catalog::FixtureKind& kind) {
  plan::Zone fewer = zone;
  for (const ModuleMeasure& measure : module_measures) {
    plan::Zone without = zone;
    (without.fixture.*measure.field).reset();
    if (model_of(design, without, kind).ok()) return measure.name;
  }
  for (const ModuleMeasure& measure : module_measures) {
    (fewer.fixture.*measure.field).reset();
    if (model_of(design, fewer, kind).ok()) return measure.name;
  }
  return std::nullopt;
}

Result<void> check_module(const Design& design,
                          const plan::Zone& zone,
                          const catalog::FixtureKind* kind,
                          const std::string& pointer) {
  if (kind == nullptr || std::ranges::none_of(module_measures, [&](const ModuleMeasure& measure) {
        return (zone.fixture.*measure.field).has_value();
      }))
    return {};
  const Result<assets::FixtureModel> model = model_of(design, zone, *kind);
  if (model.ok()) return {};
  const auto name = measure_at_fault(design, zone, *kind);
  if (!name) return {};
  return Error{"plan.bad_value",
               pointer + "/" + std::string(*name),
               model.error().message + "; leave " + std::string(*name) + " out for what is usual"};
}

// `count` modules of the preferred width, then the widest that fit, over and over.
std::vector<int> greedy_fill(const ModuleSpec& spec, int count, int length_mm) {
  std::vector<int> widths(static_cast<std::size_t>(count), spec.widths_mm.front());
  int left = length_mm - sum(widths);
  std::vector<int> others(spec.widths_mm.begin() + 1, spec.widths_mm.end());
  std::ranges::sort(others, std::greater<>());
  for (const int width : others) {
    for (; width <= left; left -= width)
      widths.push_back(width);
  }
  return widths;
}

}  // namespace

bool takes_look(const catalog::FixtureKind& kind) {
  constexpr std::array<std::string_view, 4> plain{"gondola", "wall_unit", "endcap", "peg_wall"};
  return std::ranges::find(plain, kind.generator) != plain.end();
}

int ModuleSpec::door_swing_mm() const {
  return static_cast<int>(kind->door_swing_mm);
}

int ModuleSpec::clear_mm(const Design& design) const {
  return std::max({design.min_aisle_mm() + door_swing_mm(),
                   static_cast<int>(kind->front_clearance_mm),
                   wished_aisle_mm + (wished_aisle_mm > 0 ? door_swing_mm() : 0)});
}

int ModuleSpec::narrowest_mm() const {
  return *std::ranges::min_element(widths_mm);
}

ZoneKinds kinds_of(const plan::Zone& zone, const catalog::Catalog& catalog) {
  ZoneKinds kinds;
  kinds.main = main_kind(zone, catalog);
  if (kinds.main != nullptr) kinds.wall = wall_kind(*kinds.main, catalog);
  return kinds;
}

plan::Zone with_fixtures(plan::Zone zone, const plan::FixtureSpec& also) {
  zone.fixture = also;
  return zone;
}

ZoneKinds kinds_beside(const plan::FixtureSpec& also, const catalog::Catalog& catalog) {
  ZoneKinds kinds;
  kinds.main = catalog.fixture_kind(also.kind);
  const bool walls =
      kinds.main != nullptr && (kinds.main->against_wall || kinds.main->generator == "serve_over");
  if (walls) kinds.wall = kinds.main;
  return kinds;
}

ModuleSpec module_spec(const Design& design,
                       const plan::Zone& zone,
                       const catalog::FixtureKind& kind) {
  const bool own = kind.kind == zone.fixture.kind ||
                   is_or_is_made_as(design, zone, kind, kinds_of(zone, design.catalog).main);
  const plan::FixtureSpec wish = own ? zone.fixture : wish_along_walls(design, zone, kind);
  ModuleSpec spec;
  spec.kind = &kind;
  spec.sides = wish.double_sided.value_or(kind.double_sided) && kind.double_sided ? 2 : 1;
  choose_depth_and_height(spec, design, wish);
  choose_levels(spec, wish);
  choose_widths(spec, design, wish);
  choose_finish(spec, design, wish);
  if (!own && zone.fixture.color && takes_look(kind)) spec.color = *zone.fixture.color;
  if (own && !kind.double_sided) spec.wished_aisle_mm = wish.aisle_mm.value_or(0);
  return spec;
}

ModuleSpec one_sided(ModuleSpec spec) {
  if (spec.sides == 1) return spec;
  spec.sides = 1;
  spec.depth_mm = clamped(spec.depth_mm / 2, spec.kind->depth_range_mm);
  return spec;
}

std::vector<int> fill_widths(const ModuleSpec& spec, int length_mm) {
  if (spec.widths_mm.empty() || length_mm <= 0) return {};
  const int most = length_mm / spec.widths_mm.front();
  std::vector<int> best;
  for (int count = most; count >= std::max(0, most - max_fill_changes); --count) {
    std::vector<int> widths = greedy_fill(spec, count, length_mm);
    if (sum(widths) > sum(best)) best = std::move(widths);
  }
  return best;
}

Fixture lone_module(const catalog::FixtureKind& kind) {
  Fixture fixture;
  fixture.kind = kind.kind;
  fixture.width_mm = kind.module_widths_mm.front();
  fixture.depth_mm = kind.depth_mm;
  fixture.height_mm = kind.height_mm;
  fixture.levels = kind.levels;
  fixture.base_mm = kind.base_mm;
  fixture.spacing_mm = kind.levels > 0 ? (kind.height_mm - kind.base_mm) / kind.levels : 0;
  fixture.sides = kind.double_sided ? 2 : 1;
  fixture.run_start = fixture.run_end = true;
  fixture.material = kind.material;
  fixture.color = kind.color;
  return fixture;
}

Fixture make_module(const ModuleSpec& spec, const plan::Zone& zone) {
  Fixture fixture;
  fixture.kind = spec.kind->kind;
  fixture.zone = zone.id;
  fixture.depth_mm = spec.depth_mm;
  fixture.height_mm = spec.height_mm;
  fixture.levels = spec.levels;
  fixture.base_mm = spec.base_mm;
  fixture.spacing_mm = spec.spacing_mm;
  fixture.sides = spec.sides;
  fixture.material = spec.material;
  fixture.color = spec.color;
  return fixture;
}

assets::FixtureShape fixture_shape(const Fixture& fixture,
                                   const catalog::FixtureKind& kind,
                                   const plan::Look& look) {
  return {.generator = kind.generator,
          .width_mm = fixture.width_mm,
          .depth_mm = fixture.depth_mm,
          .height_mm = fixture.height_mm,
          .levels = fixture.levels,
          .base_mm = fixture.base_mm,
          .spacing_mm = fixture.spacing_mm,
          .sides = fixture.sides,
          .start = fixture.run_start,
          .end = fixture.run_end,
          .material = fixture.material,
          .color = fixture.color,
          .accent = kind.accent.empty() ? look.accent : kind.accent,
          .spacings_mm = fixture.spacings_mm.value_or(kind.spacings_mm),
          .back_spacings_mm = fixture.back_spacings_mm.value_or(std::vector<int>{}),
          .board_mm = kind.board_mm,
          .shelf_tilt_deg = kind.shelf_tilt_deg,
          .fence_mm = kind.fence_mm,
          .header_mm = kind.header_mm};
}

Result<void> check_modules(const Design& design) {
  for (std::size_t i = 0; i < design.plan.zones.size(); ++i) {
    const plan::Zone& zone = design.plan.zones[i];
    const std::string pointer = "/zones/" + std::to_string(i);
    MARKETGEN_CHECK(
        check_module(design, zone, kinds_of(zone, design.catalog).main, pointer + "/fixture"));
    for (std::size_t k = 0; zone.also && k < zone.also->size(); ++k) {
      const plan::FixtureSpec& also = (*zone.also)[k];
      MARKETGEN_CHECK(check_module(design,
                                   with_fixtures(zone, also),
                                   design.catalog.fixture_kind(also.kind),
                                   pointer + "/also/" + std::to_string(k)));
    }
  }
  return {};
}

}  // namespace marketgen::layout
