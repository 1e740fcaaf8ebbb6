#include "intake/plan_zones.h"

#include <algorithm>
#include <cmath>

#include "intake/plan_look.h"
#include "intake/zone_sizes.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

constexpr int six_levels_from_mm = 1900;     // gondolas this high hold a sixth level
constexpr int endcaps_front_from_mm = 5200;  // runs this long spare the floor for an endcap
constexpr int endcaps_both_from_mm = 8000;
constexpr double min_area_share = 0.6;  // of the target
constexpr double untidy_jitter = 0.5;   // from here on, items stand in wrong places too
constexpr double untidy_misplaced = 0.03;

class ZoneWriter {
 public:
  explicit ZoneWriter(const PlanSources& sources)
      : sources_(sources), found_(sources.understanding), program_(sources.program) {}

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
    if (!from.beside.empty()) zone.also = beside_of(from);
    zone.stock = stock_of();
    return zone;
  }

 private:
  static double rounded(double m2) { return std::max(0.5, std::floor(m2 * 10 + 0.5) / 10); }

  bool runs_along_y() const {
    const plan::Wall wall = sources_.candidate.openings.front().wall;
    return wall == plan::Wall::south || wall == plan::Wall::north;
  }

  static bool is_gondola(const ProgramZone& zone) {
    return zone.kind != nullptr && zone.kind->generator == "gondola";
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
    if (zone.stance == Stance::central) {
      spec.axis = runs_along_y() ? plan::RunAxis::y : plan::RunAxis::x;
      spec.aisle_mm = sources_.candidate.drafted.run_aisle_mm;
    }
    spec.color = shelf_color(found_);
    choose_runs(spec, zone.main);
    if (is_gondola(zone)) choose_gondola(spec, *zone.kind, rect);
    choose_levels(spec, zone);
    return spec;
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

  void choose_gondola(plan::FixtureSpec& spec,
                      const catalog::FixtureKind& kind,
                      const RectMm& rect) const {
    const catalog::ProfileRow& profile = *program_.profile;
    spec.height_mm = std::clamp(wished_height(kind).value_or(profile.gondola_height_mm),
                                kind.height_range_mm[0],
                                kind.height_range_mm[1]);
    spec.levels = *spec.height_mm >= six_levels_from_mm ? 6 : 5;
    const int run = runs_along_y() ? rect.depth() : rect.width();
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

  std::optional<int> wished_height(const catalog::FixtureKind& kind) const {
    for (const plan::Requirement& wish : found_.requirements) {
      if (wish.kind != Kind::height) continue;
      if (wish.subject != "fixture" && wish.subject != kind.kind) continue;
      const int height = static_cast<int>(std::lround(wish.value));
      const int usual = program_.profile->gondola_height_mm;
      if (wish.comparison == plan::Comparison::at_most) return std::min(height, usual);
      if (wish.comparison == plan::Comparison::at_least) return std::max(height, usual);
      return height;
    }
    return std::nullopt;
  }

  // A wish about one zone beats a wish about all shelves.
  void choose_levels(plan::FixtureSpec& spec, const ProgramZone& zone) const {
    const plan::Requirement* wish = found_.find(Kind::levels, zone.type->type);
    if (wish == nullptr && is_gondola(zone)) wish = found_.find(Kind::levels, "");
    if (wish == nullptr || zone.kind->level_range[1] < 2) return;
    const int usual = spec.levels.value_or(zone.kind->levels);
    int levels = static_cast<int>(wish->value);
    if (wish->comparison == plan::Comparison::at_least) levels = std::max(levels, usual);
    if (wish->comparison == plan::Comparison::at_most) levels = std::min(levels, usual);
    spec.levels =
        std::clamp(levels, std::max(1, zone.kind->level_range[0]), zone.kind->level_range[1]);
  }

  plan::StockSpec stock_of() const {
    plan::StockSpec stock;
    stock.fill = program_.profile->stock_fill;
    for (const plan::Requirement& wish : found_.requirements) {
      if (wish.kind == Kind::product_absent) stock.exclude.push_back(wish.subject);
      if (wish.kind == Kind::zone_absent) exclude_goods_of(wish.subject, stock);
      if (wish.kind == Kind::stock) apply_stock(wish, stock);
    }
    std::ranges::sort(stock.exclude);
    const auto repeated = std::ranges::unique(stock.exclude);
    stock.exclude.erase(repeated.begin(), repeated.end());
    constexpr std::size_t max_excluded = 40;  // of StockSpec::exclude
    if (stock.exclude.size() > max_excluded) stock.exclude.resize(max_excluded);
    return stock;
  }

  static void apply_stock(const plan::Requirement& wish, plan::StockSpec& stock) {
    if (wish.subject == "fill" && wish.comparison == plan::Comparison::at_least) {
      stock.fill = std::max(stock.fill, wish.value);
    } else if (wish.subject == "fill") {
      stock.fill = wish.value;
    }
    if (wish.subject == "out_of_stock") stock.out_of_stock = wish.value;
    if (wish.subject == "misplaced") stock.misplaced = wish.value;
    if (wish.subject != "jitter") return;
    stock.jitter = wish.value;
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
};

}  // namespace

std::vector<plan::Zone> zones_of(const PlanSources& sources) {
  const ZoneWriter writer(sources);
  std::vector<plan::Zone> zones;
  for (std::size_t i = 0; i < sources.program.zones.size(); ++i)
    zones.push_back(writer.write(i));
  return zones;
}

}  // namespace marketgen::intake
