#include "intake/plan_zones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "intake/core_columns.h"
#include "intake/drawn_runs.h"
#include "intake/plan_look.h"
#include "intake/relation_geometry.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr int six_levels_from_mm = 1900;     // gondolas this high hold a sixth level
constexpr int endcaps_front_from_mm = 5200;  // runs this long spare the floor for an endcap
constexpr int endcaps_both_from_mm = 8000;
constexpr int min_turned_run_mm = 1800;    // shorter runs show nobody their front
constexpr double min_area_share = 0.6;     // of the target
constexpr double no_gap_from_fill = 0.99;  // "to the brim": nothing is sold out, either
constexpr int low_goods_mm = 80;           // tins and packs that stand over the highest board
constexpr std::size_t max_words = 40;      // of StockSpec::exclude and must_stock
constexpr int canopy_mm = 160;             // of wall units, over the highest level's goods

class ZoneWriter {
 public:
  explicit ZoneWriter(const PlanSources& sources)
      : sources_(sources),
        found_(sources.understanding),
        program_(sources.program),
        floor_(named_floor(sources.candidate, sources.program)) {}

  plan::Zone write(std::size_t index) const {
    const ProgramZone& from = program_.zones[index];
    const RectMm& rect = sources_.candidate.rects[index];
    plan::Zone zone;
    zone.id = from.id;
    zone.type = from.type->type;
    zone.label = from.type->label;
    zone.area_m2.target = rounded(rect.area_m2());
    zone.area_m2.min = rounded(rect.area_m2() * min_area_share);
    zone.anchor = from.type->anchor;
    zone.temperature = from.kind != nullptr ? from.kind->temperature : from.type->temperature;
    zone.fixture = fixture_of(from, rect);
    std::vector<plan::FixtureSpec> also = beside_of(from);
    if (const auto walls = walls_of(from)) also.push_back(*walls);
    if (!also.empty()) zone.also = std::move(also);
    zone.stock = stock_of(zone.type);
    return zone;
  }

 private:
  static double rounded(double m2) { return std::max(0.5, std::floor(m2 * 10 + 0.5) / 10); }

  // Runs lie as they are drawn; else across the way to what words say they face; else they lead
  // away from the front wall, or lie along it where the zone has room for that.
  bool runs_along_y(const ProgramZone& zone, const RectMm& rect) const {
    if (zone.drawn_runs) return !zone.drawn_runs->along_x;
    for (const plan::Requirement& wish : found_.requirements) {
      const bool of_zone = wish.subject == zone.type->type || wish.object == zone.type->type;
      if (wish.kind != Kind::relation || !of_zone) continue;
      const auto sight = sight_of(wish, floor_);
      const int along = sight == plan::Axis::x ? rect.depth() : rect.width();
      if (sight && along >= min_turned_run_mm) return sight == plan::Axis::x;
    }
    const bool runs_east = front_runs_east(sources_.candidate);
    const int along_front = runs_east ? rect.width() : rect.depth();
    const bool turned = program_.across && along_front >= min_cell_mm;
    return runs_east != turned;
  }

  static bool is_gondola(const ProgramZone& zone) {
    return zone.kind != nullptr && zone.kind->generator == "gondola";
  }

  int run_aisle_mm(const ProgramZone& zone, const RectMm& rect) const {
    const int usual = sources_.candidate.drafted.run_aisle_mm;
    return zone.drawn_runs ? drawn_aisle_mm(zone, rect, usual, *program_.profile) : usual;
  }

  plan::FixtureSpec fixture_of(const ProgramZone& zone, const RectMm& rect) const {
    plan::FixtureSpec spec;
    spec.kind = zone.kind != nullptr ? zone.kind->kind : "";
    if (zone.kind == nullptr) return spec;
    spec.count = zone.count;
    if (zone.kind->generator == "checkout_lane") {
      spec.depth_mm = lane_length_mm(*zone.kind, program_);
    }
    if (zone.kind->role != catalog::FixtureRole::shelving) return spec;
    if (zone.drawn_runs || zone.stance == Stance::central)
      spec.axis = runs_along_y(zone, rect) ? plan::RunAxis::y : plan::RunAxis::x;
    if (zone.stance == Stance::central)
      spec.aisle_mm = run_aisle_mm(zone, rect);
    else if (min_aisle_holds(zone))
      spec.aisle_mm = program_.aisle_mm;
    spec.color = shelf_color(found_);
    choose_runs(spec, zone.main);
    if (is_gondola(zone))
      choose_gondola(spec, zone, rect);
    else
      spec.height_mm = wished_height(zone, zone.kind->height_mm);
    choose_levels(spec, zone);
    choose_pitch(spec, zone);
    return spec;
  }

  // "No aisle narrower than 1.8 m" is said of the aisle before every shelf, also along walls.
  bool min_aisle_holds(const ProgramZone& zone) const {
    const plan::Requirement* wish = found_.find(Kind::aisle_width);
    return wish != nullptr && wish->comparison == plan::Comparison::at_least &&
           std::ranges::find(wish->except, zone.type->type) == wish->except.end();
  }

  static void choose_runs(plan::FixtureSpec& spec, const KindWish& wish) {
    spec.runs = wish.runs;
    if (wish.runs && wish.sides != 0) spec.double_sided = wish.sides == 2;
  }

  std::vector<plan::FixtureSpec> beside_of(const ProgramZone& zone) const {
    std::vector<plan::FixtureSpec> specs;
    for (const KindWish& wish : zone.beside) {
      plan::FixtureSpec& spec = specs.emplace_back();
      spec.kind = wish.kind->kind;
      spec.count = wish.count;
      choose_runs(spec, wish);
    }
    return specs;
  }

  // How the wall units beside the zone's own fixtures are built, where the words say so and they
  // are not built like its gondolas anyhow (layout/module_spec.cpp).
  std::optional<plan::FixtureSpec> walls_of(const ProgramZone& from) const {
    if (from.kind == nullptr || from.kind->role != catalog::FixtureRole::shelving)
      return std::nullopt;
    ProgramZone walls = from;
    walls.kind = kind_on_walls(*from.kind, sources_.catalog);
    if (walls.kind == nullptr || walls.kind == from.kind || walls.kind->generator != "wall_unit")
      return std::nullopt;
    const bool counted = std::ranges::any_of(
        from.beside, [&](const KindWish& wish) { return wish.kind == walls.kind; });
    Wishes of_walls = wishes_of(Kind::height, &plan::Requirement::object, from.type->type);
    std::erase_if(of_walls,
                  [&](const plan::Requirement* wish) { return wish->subject != walls.kind->kind; });
    if (counted || (is_gondola(from) && of_walls.empty())) return std::nullopt;
    plan::FixtureSpec spec;
    spec.kind = walls.kind->kind;
    spec.height_mm = wished_height(walls, walls.kind->height_mm);
    choose_levels(spec, walls);
    choose_pitch(spec, walls);
    if (!spec.height_mm && !spec.levels && !spec.spacing_mm) return std::nullopt;
    spec.color = shelf_color(found_);
    return spec;
  }

  void choose_gondola(plan::FixtureSpec& spec, const ProgramZone& zone, const RectMm& rect) const {
    const catalog::FixtureKind& kind = *zone.kind;
    const int usual = program_.profile->gondola_height_mm;
    spec.height_mm = std::clamp(wished_height(zone, usual).value_or(usual),
                                kind.height_range_mm[0],
                                kind.height_range_mm[1]);
    spec.levels = gondola_levels(*spec.height_mm);
    const int run = runs_along_y(zone, rect) ? rect.depth() : rect.width();
    spec.endcaps =
        run >= endcaps_both_from_mm
            ? plan::Endcaps::both
            : (run >= endcaps_front_from_mm ? plan::Endcaps::front : plan::Endcaps::none);
    const plan::Requirement* endcaps = found_.find(Kind::endcaps);
    if (endcaps == nullptr) return;
    if (endcaps->value == 0) spec.endcaps = plan::Endcaps::none;
    if (endcaps->value != 0 && spec.endcaps == plan::Endcaps::none)
      spec.endcaps = plan::Endcaps::front;
  }

  using Wishes = std::vector<const plan::Requirement*>;

  // What is asked of a zone type: by name, or else of every zone that is not excepted.
  Wishes wishes_of(Kind kind, std::string plan::Requirement::*zone, const std::string& type) const {
    Wishes own, general;
    for (const plan::Requirement& wish : found_.requirements) {
      if (wish.kind != kind) continue;
      if (wish.*zone == type) own.push_back(&wish);
      const bool excepted = std::ranges::find(wish.except, type) != wish.except.end();
      if ((wish.*zone).empty() && !excepted) general.push_back(&wish);
    }
    return own.empty() ? general : own;
  }

  // The number nearest to the usual one that all of them allow; the last said counts.
  static int bounded(const Wishes& wishes, int usual) {
    for (const plan::Requirement* wish : wishes) {
      const int value = static_cast<int>(std::lround(wish->value));
      if (wish->comparison == plan::Comparison::at_least)
        usual = std::max(usual, value);
      else if (wish->comparison == plan::Comparison::at_most)
        usual = std::min(usual, value);
      else
        usual = value;
    }
    return usual;
  }

  std::optional<int> wished_height(const ProgramZone& zone, int usual) const {
    Wishes wishes = wishes_of(Kind::height, &plan::Requirement::object, zone.type->type);
    std::erase_if(wishes, [&](const plan::Requirement* wish) {
      // What is no gondola is as high as its kind is, unless that is too high.
      const bool shelves = wish->subject == "fixture" &&
                           (is_plain(zone) || wish->comparison == plan::Comparison::at_most);
      return !shelves && wish->subject != zone.kind->kind;
    });
    if (wishes.empty()) return std::nullopt;
    return std::clamp(
        bounded(wishes, usual), zone.kind->height_range_mm[0], zone.kind->height_range_mm[1]);
  }

  // Boards over one another, without doors: what people mean by shelves.
  static bool is_plain(const ProgramZone& zone) {
    return is_gondola(zone) || (zone.kind != nullptr && zone.kind->generator == "wall_unit");
  }

  // Of levels and of their distance: a wish about all shelves is one about plain ones.
  Wishes shelf_wishes(Kind kind, const ProgramZone& zone) const {
    Wishes wishes = wishes_of(kind, &plan::Requirement::subject, zone.type->type);
    if (!is_plain(zone))
      std::erase_if(wishes, [](const plan::Requirement* wish) { return wish->subject.empty(); });
    return wishes;
  }

  void choose_levels(plan::FixtureSpec& spec, const ProgramZone& zone) const {
    const Wishes wishes = shelf_wishes(Kind::levels, zone);
    if (zone.kind->level_range[1] < 2) return;
    const int usual = spec.levels.value_or(zone.kind->levels);
    if (!wishes.empty())
      spec.levels = std::clamp(bounded(wishes, usual),
                               std::max(1, zone.kind->level_range[0]),
                               zone.kind->level_range[1]);
    else if (shows_levels(zone))
      spec.levels = std::clamp(
          found_.photographed.levels->value, zone.kind->level_range[0], zone.kind->level_range[1]);
  }

  // Photos say how many levels the zone's gondolas have.
  bool shows_levels(const ProgramZone& zone) const {
    return found_.photographed.levels && is_gondola(zone) &&
           shelf_wishes(Kind::levels, zone).empty();
  }

  // As many levels at that distance as were asked for, or as the height holds; a height that nobody
  // asked for gives way to the levels. Levels or a height that were asked for set the distance,
  // too: then the shelves along the walls are built like the others (layout/module_spec.cpp).
  void choose_pitch(plan::FixtureSpec& spec, const ProgramZone& zone) const {
    const catalog::FixtureKind& kind = *zone.kind;
    const int height = spec.height_mm.value_or(kind.height_mm);
    const int usual = spec.levels.value_or(kind.levels);
    const Wishes wishes = shelf_wishes(Kind::shelf_pitch, zone);
    const bool levels_asked = !shelf_wishes(Kind::levels, zone).empty() || shows_levels(zone);
    const bool height_asked = wished_height(zone, height).has_value();
    const bool asked = !wishes.empty() || (is_gondola(zone) && (levels_asked || height_asked));
    if (!asked || kind.level_range[1] < 2 || usual < 2) return;
    const int pitch = bounded(wishes, (height - kind.base_mm - canopy_mm) / usual);
    // Over the highest board stand goods as high as others, or what room asked-for levels leave.
    const int over_top = levels_asked && height_asked ? std::min(pitch, low_goods_mm) : pitch;
    const auto levels_in = [&](int mm) {
      return 1 + (mm - kind.base_mm - canopy_mm - over_top) / pitch;
    };
    int levels = levels_asked || wishes.empty() ? usual : levels_in(height);
    levels = std::min(levels, levels_in(height_asked ? height : kind.height_range_mm[1]));
    levels = std::clamp(levels, kind.level_range[0], kind.level_range[1]);
    const int needed = kind.base_mm + (levels - 1) * pitch + over_top + canopy_mm;
    constexpr int closest_mm = 80;  // of FixtureSpec::spacing_mm
    if (needed > kind.height_range_mm[1] || pitch < closest_mm) return;  // no room for them
    spec.levels = levels;
    spec.spacing_mm = pitch;
    spec.height_mm = std::max(height, needed);
  }

  plan::StockSpec stock_of(const std::string& type) const {
    plan::StockSpec stock;
    stock.fill = program_.profile->stock_fill;
    for (const plan::Requirement& wish : found_.requirements) {
      if (wish.kind == Kind::product_absent) stock.exclude.push_back(wish.subject);
      if (wish.kind == Kind::zone_absent) exclude_goods_of(wish.subject, stock);
    }
    apply_stock_wishes(type, stock);
    std::ranges::sort(stock.exclude);
    const auto repeated = std::ranges::unique(stock.exclude);
    stock.exclude.erase(repeated.begin(), repeated.end());
    if (stock.exclude.size() > max_words) stock.exclude.resize(max_words);
    if (stock.out_of_stock < 1) stock.must_stock = goods_wished(type);
    return stock;
  }

  // Goods that were asked for by name and that this type of zone sells.
  std::optional<std::vector<std::string>> goods_wished(const std::string& type) const {
    std::vector<std::string> words;
    for (const plan::Requirement& wish : found_.requirements) {
      const bool here = wish.kind == Kind::product_present && wish.object == type;
      const bool known = std::ranges::find(words, wish.subject) != words.end();
      if (here && !known && words.size() < max_words) words.push_back(wish.subject);
    }
    return words.empty() ? std::nullopt : std::optional(std::move(words));
  }

  // Wishes about all goods first, those about the zone's own after them.
  void apply_stock_wishes(const std::string& type, plan::StockSpec& stock) const {
    for (const bool own : {false, true}) {
      for (const plan::Requirement& wish : found_.requirements) {
        const bool excepted = std::ranges::find(wish.except, type) != wish.except.end();
        if (wish.kind == Kind::stock && wish.object == (own ? type : "") && !excepted)
          apply_stock(wish, stock, own);
      }
    }
  }

  static void apply_stock(const plan::Requirement& wish, plan::StockSpec& stock, bool own) {
    if (wish.subject == "fill") {
      const bool floor = wish.comparison == plan::Comparison::at_least;
      stock.fill = floor && !own ? std::max(stock.fill, wish.value) : wish.value;
      if (wish.value >= no_gap_from_fill) stock.out_of_stock = 0;
    }
    if (wish.subject == "out_of_stock") stock.out_of_stock = wish.value;
    if (wish.subject == "misplaced") stock.misplaced = wish.value;
    set_price_tags(stock.price_tags, wish.subject, wish.value);
    if (wish.subject != "jitter") return;
    // "Tidy" is faced up: not one item stands out.
    stock.jitter = wish.comparison == plan::Comparison::at_most ? 0 : wish.value;
    if (wish.value >= untidy_jitter) stock.misplaced = std::max(stock.misplaced, untidy_misplaced);
  }

  // "No alcohol" keeps beer out of the offers too: what only that zone type sells is sold nowhere.
  void exclude_goods_of(const std::string& type, plan::StockSpec& stock) const {
    const catalog::ZoneTypeRow* refused = sources_.catalog.zone_type(type);
    if (refused == nullptr) return;
    const auto sold_elsewhere = [&](const std::string& goods, auto list) {
      return std::ranges::any_of(sources_.catalog.zone_types, [&](const catalog::ZoneTypeRow& row) {
        return row.type != type && std::ranges::find(row.*list, goods) != (row.*list).end();
      });
    };
    for (const std::string& goods : refused->subcategories) {
      if (!sold_elsewhere(goods, &catalog::ZoneTypeRow::subcategories))
        stock.exclude.push_back(goods);
    }
    if (!refused->subcategories.empty()) return;
    for (const std::string& goods : refused->categories) {
      if (!sold_elsewhere(goods, &catalog::ZoneTypeRow::categories)) stock.exclude.push_back(goods);
    }
  }

  const PlanSources& sources_;
  const Understanding& found_;
  const StoreProgram& program_;
  plan::NamedFloor floor_;
};

}  // namespace

int gondola_levels(int height_mm) {
  return height_mm >= six_levels_from_mm ? 6 : 5;
}

bool set_price_tags(std::optional<plan::PriceTagSpec>& tags,
                    std::string_view subject,
                    double share) {
  constexpr std::array<std::pair<std::string_view, double plan::PriceTagSpec::*>, 4> faults = {
      {{"tags_missing", &plan::PriceTagSpec::missing},
       {"tags_wrong_price", &plan::PriceTagSpec::wrong_price},
       {"tags_wrong_product", &plan::PriceTagSpec::wrong_product},
       {"tags_doubled", &plan::PriceTagSpec::doubled}}};
  for (const auto& [name, fault] : faults) {
    if (name != subject) continue;
    if (!tags) tags.emplace();
    *tags.*fault = share;
    return true;
  }
  return false;
}

std::vector<plan::Zone> zones_of(const PlanSources& sources) {
  const ZoneWriter writer(sources);
  std::vector<plan::Zone> zones;
  for (std::size_t i = 0; i < sources.program.zones.size(); ++i)
    zones.push_back(writer.write(i));
  return zones;
}

}  // namespace marketgen::intake
