#include "intake/edit_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "intake/edit_ways.h"
#include "intake/plan_zones.h"
#include "plan/bsp.h"
#include "plan/style_look.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;
using Ways = Result<std::vector<Way>>;

constexpr std::size_t max_bytes = 20'000;  // as a brief's prompt

std::vector<Way> one_way(Way way) {
  return {std::move(way)};
}

Error not_by_an_edit(std::string_view text) {
  return {"usage.unavailable",
          "--say",
          fmt::format("\"{}\" is no change that an edit can make; generate the store again, or "
                      "write patches for --patch (docs/editing.md lists them)",
                      text)};
}

int module_count(const StandingStore& store, const std::string& zone) {
  const auto found = store.modules.find(zone);
  return found == store.modules.end() ? 0 : found->second;
}

plan::Patch set_fixture(const std::string& zone) {
  plan::Patch patch;
  patch.set_fixture.emplace().zone = zone;
  return patch;
}

plan::Patch set_stock(const std::string& zone) {
  plan::Patch patch;
  patch.set_stock.emplace().zone = zone;
  return patch;
}

const catalog::FixtureKind* kind_of(const StandingStore& store, const plan::Zone& zone) {
  return store.catalog.fixture_kind(zone.fixture.kind);
}

bool has_shelves(const StandingStore& store, const plan::Zone& zone) {
  const catalog::FixtureKind* kind = kind_of(store, zone);
  return kind != nullptr && kind->role == catalog::FixtureRole::shelving;
}

// A patch for each zone of the type, or for each that `takes` it when the words name no type.
template <class Takes, class Make>
Ways in_zones(const StandingStore& store, const std::string& type, Takes takes, Make make) {
  Way way;
  if (!type.empty()) MARKETGEN_CHECK(zones_called(store, type));
  for (const plan::Zone& zone : store.plan.zones) {
    if (type.empty() ? takes(zone) : zone.type == type) way.push_back(make(zone));
  }
  return one_way(std::move(way));
}

bool has_gondolas(const StandingStore& store, const plan::Zone& zone) {
  const catalog::FixtureKind* kind = kind_of(store, zone);
  return kind != nullptr && kind->generator == "gondola";
}

Ways set_levels(const StandingStore& store, const std::string& type, int levels) {
  const auto takes = [&](const plan::Zone& zone) { return has_gondolas(store, zone); };
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_fixture(zone.id);
    patch.set_fixture->levels = levels;
    return patch;
  });
}

Ways set_pitch(const StandingStore& store, const std::string& type, int spacing_mm) {
  const auto takes = [&](const plan::Zone& zone) { return has_gondolas(store, zone); };
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_fixture(zone.id);
    patch.set_fixture->spacing_mm = spacing_mm;
    return patch;
  });
}

Ways set_aisles(const StandingStore& store, const std::string& type, int width_mm) {
  const auto takes = [&](const plan::Zone& zone) { return zone.fixture.aisle_mm.has_value(); };
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_fixture(zone.id);
    patch.set_fixture->aisle_mm = width_mm;
    return patch;
  });
}

Ways set_height(const StandingStore& store,
                const std::string& type,
                std::string_view kind,
                int height_mm) {
  if (kind == "ceiling") {
    plan::Patch patch;
    patch.set_shell.emplace().ceiling_mm = height_mm;
    return one_way({patch});
  }
  const auto takes = [&](const plan::Zone& zone) {
    const catalog::FixtureKind* row = kind_of(store, zone);
    return row != nullptr &&
           (row->kind == kind || (kind == "fixture" && row->generator == "gondola"));
  };
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_fixture(zone.id);
    patch.set_fixture->height_mm = height_mm;
    return patch;
  });
}

Ways set_goods(const StandingStore& store,
               const std::string& type,
               const std::string& field,
               double value) {
  const auto takes = [&](const plan::Zone& zone) { return has_shelves(store, zone); };
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_stock(zone.id);
    if (field == "fill") patch.set_stock->fill = value;
    if (field == "out_of_stock") patch.set_stock->out_of_stock = value;
    if (field == "misplaced") patch.set_stock->misplaced = value;
    std::optional<plan::PriceTagSpec> tags = zone.stock.price_tags;
    if (set_price_tags(tags, field, value)) patch.set_stock->price_tags = tags;
    if (field == "jitter") {
      patch.set_stock->jitter = value;
      patch.set_stock->misplaced = value >= untidy_jitter ? untidy_misplaced : 0;
    }
    return patch;
  });
}

Way drop_zones(const StandingStore& store, std::string_view type) {
  Way way;
  for (const plan::Zone& zone : store.plan.zones) {
    if (zone.type != type) continue;
    plan::Patch patch;
    patch.drop_zone = {zone.id};
    way.push_back(patch);
  }
  return way;
}

// So many tills or desks of the zone, of which so many stand.
Ways set_count(const StandingStore& store, const std::string& zone, int count) {
  if (count <= 0) {
    plan::Patch patch;
    patch.drop_zone = {zone};
    return one_way({patch});
  }
  plan::Patch patch = set_fixture(zone);
  patch.set_fixture->count = count;
  if (count <= module_count(store, zone)) return one_way({patch});
  return with_more_room(store, zone, {patch});
}

bool has_zone(const StandingStore& store, std::string_view type) {
  return std::ranges::find(store.plan.zones, type, &plan::Zone::type) != store.plan.zones.end();
}

// "Five checkouts", "glass-door coolers" for dairy.
Ways fixtures_wished(const StandingStore& store, const plan::Requirement& wish) {
  const catalog::FixtureKind* kind = store.catalog.fixture_kind(wish.subject);
  const bool counted = kind != nullptr && kind->role != catalog::FixtureRole::shelving;
  const int wanted = static_cast<int>(std::lround(wish.value));
  if (wish.object.empty()) return not_by_an_edit(wish.text);
  if (!has_zone(store, wish.object)) {
    if (wanted == 0) return one_way({});
    return ways_to_add(store, wish.object, counted ? std::optional(wanted) : std::nullopt);
  }
  MARKETGEN_TRY(const std::vector<std::string> zones, zones_called(store, wish.object));
  if (!counted) {
    plan::Patch patch = set_fixture(zones.front());
    patch.set_fixture->kind = wish.subject;
    patch.set_fixture->usual = {"module_mm", "depth_mm", "height_mm", "levels", "spacing_mm"};
    return one_way({patch});
  }
  const int stand = module_count(store, zones.front());
  const bool so_already = (wish.comparison == plan::Comparison::at_least && stand >= wanted) ||
                          (wish.comparison == plan::Comparison::at_most && stand <= wanted);
  return so_already ? Ways(one_way({})) : set_count(store, zones.front(), wanted);
}

const plan::Opening* opening_of(const plan::Plan& plan, std::string_view kind) {
  const auto found = std::ranges::find_if(
      plan.shell.openings, [&](const plan::Opening& o) { return name_of(o.kind) == kind; });
  return found == plan.shell.openings.end() ? nullptr : &*found;
}

// Along the wall, near the end that was said, or wherever there is room.
Ways opening_wished(const StandingStore& store, const plan::Requirement& wish) {
  const plan::Opening* opening = opening_of(store.plan, wish.subject);
  if (opening == nullptr) {
    return Error{
        "plan.unknown_reference",
        "--say",
        fmt::format("the store has no {} of its own; its doors serve as that, too", wish.subject)};
  }
  if (wish.object.empty() && wish.second_object.empty()) return not_by_an_edit(wish.text);
  const auto wall = value_named<plan::Wall>(wish.object);
  std::vector<double> centers{0.5, 0.25, 0.75, 0.35, 0.65, 0.15, 0.85};
  if (wish.second_object == "west" || wish.second_object == "south")
    centers = {0.2, 0.25, 0.15, 0.3};
  if (wish.second_object == "east" || wish.second_object == "north")
    centers = {0.8, 0.75, 0.85, 0.7};
  if (wish.second_object == "center") centers = {0.5, 0.45, 0.55};
  if (wish.second_object.empty()) centers.insert(centers.begin(), opening->center);
  std::vector<Way> ways;
  for (const double center : centers) {
    plan::Patch patch;
    patch.move_opening.emplace().opening = opening->id;
    if (wall) patch.move_opening->wall = *wall;
    patch.move_opening->center = center;
    ways.push_back({patch});
  }
  return ways;
}

Ways look_wished(const StandingStore& store, const plan::Requirement& wish) {
  plan::Patch patch;
  plan::SetLook& look = patch.set_look.emplace();
  if (wish.kind == Kind::style) {
    MARKETGEN_TRY(const catalog::StyleRow* style,
                  plan::style_called(store.catalog, wish.object, "--say"));
    const plan::Look of_style = plan::look_of(*style);
    look = {of_style.floor,
            of_style.wall,
            of_style.ceiling,
            of_style.fixture,
            of_style.accent,
            of_style.light_kelvin,
            of_style.light_lux,
            of_style.lamps,
            of_style.daylight,
            of_style.neon,
            {}};
  }
  if (wish.kind == Kind::material) {
    if (wish.subject == "floor") look.floor = wish.object;
    if (wish.subject == "wall") look.wall = wish.object;
    if (wish.subject == "ceiling") look.ceiling = wish.object;
    if (wish.subject == "fixture") look.fixture = wish.object;
  }
  if (wish.kind == Kind::color && wish.subject == "accent") look.accent = wish.object;
  if (wish.kind == Kind::light) {
    const int value = static_cast<int>(std::lround(wish.value));
    (wish.subject == "light_lux" ? look.light_lux : look.light_kelvin) = value;
  }
  if (wish.kind == Kind::color && wish.subject == "fixture") {
    const auto takes = [&](const plan::Zone& zone) { return has_shelves(store, zone); };
    return in_zones(store, "", takes, [&](const plan::Zone& zone) {
      plan::Patch paint = set_fixture(zone.id);
      paint.set_fixture->color = wish.object;
      return paint;
    });
  }
  return one_way({patch});
}

Ways endcaps_wished(const StandingStore& store, bool wanted) {
  Way way;
  for (const plan::Zone& zone : store.plan.zones) {
    const bool has = zone.fixture.endcaps != plan::Endcaps::none;
    const catalog::FixtureKind* kind = kind_of(store, zone);
    if (has == wanted || kind == nullptr || kind->generator != "gondola") continue;
    plan::Patch patch = set_fixture(zone.id);
    patch.set_fixture->endcaps = wanted ? plan::Endcaps::front : plan::Endcaps::none;
    way.push_back(patch);
  }
  return one_way(std::move(way));
}

Ways goods_unwished(const StandingStore& store, const plan::Requirement& wish) {
  const auto takes = [&](const plan::Zone& zone) { return has_shelves(store, zone); };
  const std::string type = has_zone(store, wish.object) ? wish.object : "";
  return in_zones(store, type, takes, [&](const plan::Zone& zone) {
    plan::Patch patch = set_stock(zone.id);
    patch.set_stock->exclude = zone.stock.exclude;
    patch.set_stock->exclude->push_back(wish.subject);
    return patch;
  });
}

Ways size_wished(const plan::Requirement& wish) {
  plan::Patch patch;
  plan::SetShell& shell = patch.set_shell.emplace();
  if (wish.value > 0) shell.width_mm = static_cast<int>(std::lround(wish.value));
  if (wish.second_value > 0) shell.depth_mm = static_cast<int>(std::lround(wish.second_value));
  return one_way({patch});
}

Ways time_wished(const plan::Requirement& wish) {
  plan::Patch patch;
  patch.set_time.emplace().time = wish.object;
  return one_way({patch});
}

Ways ways_of_wish(const StandingStore& store, const plan::Requirement& wish) {
  const int number = static_cast<int>(std::lround(wish.value));
  switch (wish.kind) {
    case Kind::relation:
      return ways_to_move(store, plan::terms_of(wish));
    case Kind::zone_present:
    case Kind::product_present: {
      const std::string& type = wish.kind == Kind::zone_present ? wish.subject : wish.object;
      return has_zone(store, type) ? Ways(one_way({})) : ways_to_add(store, type, std::nullopt);
    }
    case Kind::zone_absent:
      return one_way(drop_zones(store, wish.subject));
    case Kind::product_absent:
      return goods_unwished(store, wish);
    case Kind::fixture_count:
      return fixtures_wished(store, wish);
    case Kind::area:
      if (wish.subject.empty()) return not_by_an_edit(wish.text);
      return ways_to_resize(store, wish.subject, wish.value);
    case Kind::levels:
      return set_levels(store, wish.subject, number);
    case Kind::shelf_pitch:
      return set_pitch(store, wish.subject, number);
    case Kind::height:
      return set_height(store, wish.object, wish.subject, number);
    case Kind::aisle_width:
      return set_aisles(store, "", number);
    case Kind::stock:
      return set_goods(store, wish.object, wish.subject, wish.value);
    case Kind::style:
    case Kind::material:
    case Kind::color:
    case Kind::light:
      return look_wished(store, wish);
    case Kind::endcaps:
      return endcaps_wished(store, wish.value > 0);
    case Kind::opening:
      return opening_wished(store, wish);
    case Kind::size:
      return size_wished(wish);
    case Kind::time:
      return time_wished(wish);
    case Kind::zone_count:
    case Kind::aisle_count:
    case Kind::run_count:
    case Kind::profile:
      break;
  }
  return not_by_an_edit(wish.text);
}

Ways ways_of_count(const StandingStore& store, const WordedChange& change) {
  const bool more = change.action == ChangeAction::more;
  const int by = static_cast<int>(std::lround(change.value));
  if (change.object.empty()) {
    if (more) return ways_to_add(store, change.subject, std::nullopt);
    MARKETGEN_CHECK(zones_called(store, change.subject));
    return one_way(drop_zones(store, change.subject));
  }
  if (more && !has_zone(store, change.subject)) return ways_to_add(store, change.subject, by);
  MARKETGEN_TRY(const std::vector<std::string> zones, zones_called(store, change.subject));
  const int stand = module_count(store, zones.front());
  return set_count(store, zones.front(), more ? stand + by : stand - by);
}

Ways ways_of_change(const StandingStore& store, const WordedChange& change) {
  switch (change.action) {
    case ChangeAction::swap: {
      MARKETGEN_TRY(const std::vector<std::string> a, zones_called(store, change.subject));
      MARKETGEN_TRY(const std::vector<std::string> b, zones_called(store, change.object));
      plan::Patch patch;
      patch.swap_leaves = {a.front(), b.front()};
      return one_way({patch});
    }
    case ChangeAction::resize: {
      MARKETGEN_TRY(const std::vector<std::string> zones, zones_called(store, change.subject));
      const std::size_t index = static_cast<std::size_t>(
          plan::find_zone(store.plan, zones.front()) - store.plan.zones.data());
      const double now_m2 = plan::zone_rectangles(store.plan)[index].area_m2();
      return ways_to_resize(
          store, change.subject, change.relative ? change.value * now_m2 : change.value);
    }
    case ChangeAction::more:
    case ChangeAction::fewer:
      return ways_of_count(store, change);
    case ChangeAction::set:
      break;
  }
  const int number = static_cast<int>(std::lround(change.value));
  if (change.object == "height_mm") return set_height(store, change.subject, "fixture", number);
  if (change.object == "aisle_mm") return set_aisles(store, change.subject, number);
  return set_goods(store, change.subject, change.object, change.value);
}

// "Lots of drinks": more of their floor, within reason.
WordedChange resized(const Emphasis& emphasis) {
  constexpr double least = 0.6, most = 1.5;
  WordedChange change;
  change.action = ChangeAction::resize;
  change.subject = emphasis.zone;
  change.value = std::clamp(emphasis.factor, least, most);
  change.relative = true;
  return change;
}

std::string text_of(std::string_view words, IntRange span) {
  return std::string(
      words.substr(static_cast<std::size_t>(span[0]), static_cast<std::size_t>(span[1] - span[0])));
}

}  // namespace

Result<EditWords> understand_edit(std::string_view words,
                                  const Language& language,
                                  const catalog::Catalog& catalog,
                                  plan::Wall entrance) {
  if (words.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return Error{"brief.empty", "--say", "say what shall change, as in \"swap dairy and bakery\""};
  if (words.size() > max_bytes)
    return Error{
        "brief.too_long", "--say", fmt::format("{} bytes; at most {}", words.size(), max_bytes)};
  if (!is_utf8(words)) return Error{"input.not_utf8", "--say", "the words are not UTF-8"};
  Understanding found = understand(words, language.with_words_of(catalog), catalog, entrance);
  EditWords said;
  for (plan::Requirement& wish : found.requirements)
    said.wishes.push_back({wish.text, wish.span, wish});
  for (WordedChange& change : found.changes)
    said.wishes.push_back({change.text, change.span, change});
  for (const Emphasis& emphasis : found.emphases)
    said.wishes.push_back({emphasis.text, emphasis.span, resized(emphasis)});
  std::ranges::stable_sort(said.wishes, {}, [](const EditWish& wish) { return wish.span[0]; });
  said.unparsed = std::move(found.unparsed);
  for (const WantedRows& rows : found.rows)
    said.unparsed.push_back({text_of(words, rows.span), rows.span});
  if (found.name) said.unparsed.push_back({found.name->text, found.name->span});
  said.conflicts = std::move(found.conflicts);
  return said;
}

Result<std::vector<Way>> ways_to(const EditWish& wish, const StandingStore& store) {
  if (const auto* change = std::get_if<WordedChange>(&wish.what))
    return ways_of_change(store, *change);
  return ways_of_wish(store, std::get<plan::Requirement>(wish.what));
}

}  // namespace marketgen::intake
