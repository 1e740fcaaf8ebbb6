#include "intake/exclusions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "intake/clauses.h"
#include "intake/fixture_wishes.h"
#include "intake/goods_words.h"
#include "intake/vaguer_wishes.h"

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;
using Wish = plan::Requirement;
using plan::Comparison;
using plan::RelationKind;

constexpr double round_mm = 1;
constexpr double same_floor = 0.05;  // a size and an area are the same floor within this

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

bool apart(const Wish& a, const Wish& b) {
  const std::array<double, 2> first = bounds_of(a), second = bounds_of(b);
  return first[1] < second[0] || second[1] < first[0];
}

bool wants_some(const Wish& wish) {
  return bounds_of(wish)[0] > 0;
}

bool excepts(const Wish& wish, const std::string& zone) {
  return std::ranges::find(wish.except, zone) != wish.except.end();
}

// ---- Numbers ----

bool sizes_differ(const Wish& a, const Wish& b, const Surroundings&) {
  const auto differ = [](double x, double y) {
    return x > 0 && y > 0 && std::abs(x - y) > round_mm;
  };
  return differ(a.value, b.value) || differ(a.second_value, b.second_value);
}

// A size, and the area of the shop or of a zone in it.
bool floor_differs(const Wish& size, const Wish& area, const Surroundings&) {
  if (size.value <= 0 || size.second_value <= 0) return false;
  const double m2 = 1e-6 * size.value * size.second_value;
  const auto [low, high] = bounds_of(area);
  const bool too_small = m2 < low * (1 - same_floor);
  return too_small || (area.subject.empty() && m2 > high * (1 + same_floor));
}

bool areas_differ(const Wish& a, const Wish& b, const Surroundings&) {
  if (a.subject == b.subject) return apart(a, b);
  if (!a.subject.empty() && !b.subject.empty()) return false;
  const Wish& shop = a.subject.empty() ? a : b;
  const Wish& zone = a.subject.empty() ? b : a;
  return bounds_of(zone)[0] > bounds_of(shop)[1];
}

// Of the same kind of fixture: in one place, or more in a zone than in the store.
bool counts_differ(const Wish& a, const Wish& b, const Surroundings&) {
  if (a.subject != b.subject) return false;
  if (a.kind == Kind::run_count && a.second_value != b.second_value && a.second_value > 0 &&
      b.second_value > 0)
    return false;  // double-sided runs and single-sided ones
  if (a.second_object == b.second_object) return apart(a, b);
  if (!a.second_object.empty() && !b.second_object.empty()) return false;
  const Wish& store = a.second_object.empty() ? a : b;
  const Wish& zone = a.second_object.empty() ? b : a;
  return !excepts(store, zone.second_object) && bounds_of(zone)[0] > bounds_of(store)[1];
}

bool fixtures_are_banned(const Wish& count, const Wish& runs, const Surroundings&) {
  return count.subject == runs.subject && asks_for_none(count) && wants_some(runs) &&
         (count.second_object.empty() || count.second_object == runs.second_object);
}

// Names of fixtures that several kinds bear, and the kinds.
struct Family {
  std::array<std::string_view, 6> words;
  std::array<std::string_view, 3> kinds;
};
constexpr Family families[] = {{{"fridges", "coolers", "refrigerators", "冷柜", "冷櫃", "冰箱"},
                                {"multideck", "glass_door_cooler", "serve_over"}},
                               {{"freezers", "freezer", "冷柜", "冷櫃", "冰柜", "冰箱"},
                                {"chest_freezer", "island_freezer", "glass_door_freezer"}}};

// "No freezers" and "three chest freezers".
bool families_clash(const Wish& a, const Wish& b) {
  if (asks_for_none(a) == asks_for_none(b)) return false;
  const Wish& none = asks_for_none(a) ? a : b;
  const Wish& some = asks_for_none(a) ? b : a;
  if (!wants_some(some) || !none.second_object.empty() || none.subject == some.subject)
    return false;
  return std::ranges::any_of(families, [&](const Family& family) {
    const bool named = has_any_word(none.text, family.words);
    const bool plain =
        !names_any(none.text, {"chest", "glass", "island", "islands", "卧式", "立式", "岛"});
    const auto is_kind = [&](const std::string& kind) {
      return std::ranges::find(family.kinds, kind) != family.kinds.end();
    };
    return named && plain && is_kind(some.subject);
  });
}

bool fixture_counts_differ(const Wish& a, const Wish& b, const Surroundings& around) {
  return counts_differ(a, b, around) || families_clash(a, b);
}

// Whether what is said of `general` is said of `special`, too.
bool covers(const Wish& general, const Wish& special, std::string Wish::*zone) {
  return general.*zone == special.*zone ||
         ((general.*zone).empty() && !excepts(general, special.*zone));
}

// Numbers of all shelves, and of those of a zone: an exception, unless the general one is a limit.
bool zone_numbers_differ(const Wish& a, const Wish& b, std::string Wish::*zone) {
  if (a.*zone == b.*zone) return apart(a, b);
  const Wish& general = (a.*zone).empty() ? a : b;
  const Wish& special = (a.*zone).empty() ? b : a;
  return covers(general, special, zone) && general.comparison != Comparison::equal &&
         apart(general, special);
}

bool shelf_numbers_differ(const Wish& a, const Wish& b, const Surroundings&) {
  return zone_numbers_differ(a, b, &Wish::subject);
}

// "Shelves" are gondolas unless the words name another kind; a limit holds for every kind.
bool heights_differ(const Wish& a, const Wish& b, const Surroundings&) {
  const auto kind = [](const Wish& wish) {
    return wish.subject == "gondola" ? std::string_view("fixture") : std::string_view(wish.subject);
  };
  const bool ceiling = kind(a) == "ceiling", other_ceiling = kind(b) == "ceiling";
  if (ceiling != other_ceiling) {  // nothing is taller than the room
    const Wish& room = ceiling ? a : b;
    const Wish& fixture = ceiling ? b : a;
    return bounds_of(fixture)[0] > bounds_of(room)[1];
  }
  if (kind(a) == kind(b)) return zone_numbers_differ(a, b, &Wish::object);
  const bool general = a.subject == "fixture";
  if (!general && b.subject != "fixture") return false;
  const Wish& all = general ? a : b;
  const Wish& some = general ? b : a;
  return all.comparison == Comparison::at_most && !names_any(all.text, {"them"}) &&
         covers(all, some, &Wish::object) && apart(all, some);
}

bool numbers_differ(const Wish& a, const Wish& b, const Surroundings&) {
  return a.subject == b.subject && apart(a, b);
}

// Shelves full to the brim, and more sold out than that leaves.
bool stocks_differ(const Wish& a, const Wish& b, const Surroundings&) {
  constexpr double max_together = 1.25;
  if (a.object != b.object) return false;
  if (a.subject == b.subject) return apart(a, b);
  const bool shares = is_one_of(a.subject, {"fill", "out_of_stock"}) &&
                      is_one_of(b.subject, {"fill", "out_of_stock"});
  return shares && bounds_of(a)[0] + bounds_of(b)[0] > max_together;
}

bool lights_exclude(const Wish& a, const Wish& b, const Surroundings&) {
  return !may_be_one_light(a, b);
}

// ---- Choices ----

bool choices_differ(const Wish& a, const Wish& b, const Surroundings&) {
  return a.subject == b.subject && a.object != b.object;
}

// ---- Presence ----

bool same_subject(const Wish& a, const Wish& b, const Surroundings&) {
  return a.subject == b.subject;
}

// Meat and fish are one department: who wants none of the one may want the other.
bool are_halves(const Wish& absent, const Wish& wish) {
  if (absent.subject != "meat_fish" || names_fish(absent.text) == names_meat(absent.text))
    return false;
  const bool fish = names_fish(wish.text) || names_fish(wish.subject);
  return names_fish(absent.text) ? names_meat(wish.text) && !fish : fish && !names_meat(wish.text);
}

// "Only drinks" takes the chilled ones in.
bool is_within_only(const Wish& absent, const Wish& wish) {
  return absent.subject == "chilled" && wish.kind == Kind::product_present &&
         names_any(absent.text, {"only", "nothing", "alone", "exclusively", "只", "除了"}) &&
         names_any(absent.text, {"drinks", "beverages", "饮料", "饮品"});
}

bool is_plant_drink(const Wish& absent, const Wish& wish) {
  return absent.subject == "dairy" && wish.kind == Kind::product_present &&
         names_plant_drink(wish.text);
}

// The zone type that there must be for the wish to hold; empty: any will do.
std::string_view zone_needed(const Wish& wish, const Surroundings& around) {
  const auto mentioned = [&](const std::string& zone) {  // or only where some fixture usually is
    return around.mentioned.contains(zone) ? std::string_view(zone) : "";
  };
  switch (wish.kind) {
    case Kind::zone_present:
      return wish.subject;
    case Kind::levels:
    case Kind::shelf_pitch:
      return mentioned(wish.subject);
    case Kind::zone_count:
    case Kind::area:
      return wants_some(wish) ? std::string_view(wish.subject) : "";
    case Kind::product_present:
      return wish.object;
    case Kind::height:
    case Kind::stock:
      return mentioned(wish.object);
    case Kind::fixture_count:
    case Kind::run_count: {
      if (!wants_some(wish)) return "";
      if (!wish.second_object.empty()) return wish.second_object;
      const bool own = is_one_of(wish.object, {"frozen", "checkout", "self_checkout"}) ||
                       is_one_of(wish.subject, {"wine_rack", "bakery_rack", "coffee_counter"}) ||
                       (wish.subject == "serve_over" && names_counter(wish.text));
      return own ? std::string_view(wish.object) : "";  // other shelves hold anything
    }
    case Kind::relation: {
      const bool away = is_one_of(name_of(wish.relation), {"far", "not_adjacent"});
      return away || !around.things_of(wish).subject.empty() ? "" : std::string_view(wish.subject);
    }
    default:
      return "";
  }
}

bool needs_absent(const Wish& absent, const Wish& wish, const Surroundings& around) {
  const std::string_view zone = zone_needed(wish, around);
  return !zone.empty() && zone == absent.subject && !are_halves(absent, wish) &&
         !is_within_only(absent, wish) && !is_plant_drink(absent, wish);
}

// ---- Places ----

bool opposite(RelationKind a, RelationKind b) {
  const auto pair = [&](RelationKind x, RelationKind y) {
    return (a == x && b == y) || (a == y && b == x);
  };
  return pair(RelationKind::near, RelationKind::far) ||
         pair(RelationKind::near, RelationKind::not_adjacent) ||
         pair(RelationKind::facing, RelationKind::far) ||
         pair(RelationKind::left_of, RelationKind::right_of) ||
         pair(RelationKind::along, RelationKind::far) || pair(RelationKind::at, RelationKind::far);
}

std::string_view facing_wall(std::string_view wall) {
  constexpr std::array<std::array<std::string_view, 2>, 4> walls = {
      {{"north", "south"}, {"south", "north"}, {"east", "west"}, {"west", "east"}}};
  for (const auto& [name, other] : walls)
    if (name == wall) return other;
  return "";
}

// The side of the room that a zone is to stand at, or center; empty: the wish says none.
std::string_view side_of(const Wish& wish, const Surroundings& around) {
  const bool stands = wish.relation == RelationKind::at || wish.relation == RelationKind::along;
  const bool by_door = (stands || wish.relation == RelationKind::near) && wish.object == "entrance";
  if (by_door) return around.front;
  return stands ? std::string_view(wish.object) : "";
}

bool sides_exclude(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty() || a == b) return false;
  return facing_wall(a) == b || a == "center" || b == "center";
}

bool differ(const std::string& a, const std::string& b) {
  return !a.empty() && !b.empty() && a != b;
}

// Of one zone the goods or fixtures that were named: cheese here and milk there may be, drinks in
// the middle and pallets of water by the door.
bool are_of_different_things(const Wish& a, const Wish& b, const Surroundings& around) {
  const NamedThings first = around.things_of(a), second = around.things_of(b);
  return first.by_fixture != second.by_fixture || differ(first.subject, second.subject) ||
         differ(first.object, second.object);
}

// "Along the north wall and the west wall": one thing in two places.
bool is_one_statement(const Wish& a, const Wish& b) {
  return a.span[0] == b.span[0];
}

// "Between bread and wine", and far from one of them.
bool is_between_and_far(const Wish& a, const Wish& b) {
  const bool far = is_one_of(name_of(b.relation), {"far", "not_adjacent"});
  return a.relation == RelationKind::between && far && a.subject == b.subject &&
         (b.object == a.object || b.object == a.second_object);
}

bool relations_exclude(const Wish& a, const Wish& b, const Surroundings& around) {
  if (are_of_different_things(a, b, around)) return false;
  if (is_between_and_far(a, b) || is_between_and_far(b, a)) return true;
  const bool placed_twice =
      a.subject == b.subject && (is_one_statement(a, b) || around.several.contains(a.subject) ||
                                 is_one_more(around.prompt, b.span));
  if (a.subject == b.subject && a.object == b.object)
    return opposite(a.relation, b.relation) && !around.several.contains(a.subject);
  if (a.subject == b.subject)
    return !placed_twice && sides_exclude(side_of(a, around), side_of(b, around));
  if (a.subject != b.object || a.object != b.subject) return false;
  const bool sideways = a.relation == RelationKind::left_of || a.relation == RelationKind::right_of;
  if (a.relation == b.relation) return sideways || a.relation == RelationKind::behind;
  return opposite(a.relation, b.relation) && !sideways;
}

bool is_single_door(const Wish& wish) {
  return is_one_of(wish.subject, {"entrance", "exit", "service"});
}

// Where the doors are, and how many; that there are none.
bool openings_exclude(const Wish& a, const Wish& b, const Surroundings& around) {
  if (a.subject != b.subject) return false;
  const auto none = [](const Wish& wish) {
    return wish.comparison == Comparison::at_most && wish.value == 0;
  };
  if (none(a) || none(b)) return none(a) != none(b);
  const bool elsewhere = differ(a.object, b.object) || differ(a.second_object, b.second_object);
  if (a.value > 0 && b.value > 0 && !elsewhere)
    return a.object == b.object && a.second_object == b.second_object && apart(a, b);
  const auto at_one_place = [&](const Wish& wish) {  // "only one entrance, in the south wall"
    return wish.value == 1 && !wish.object.empty() && is_no_more(around.prompt, wish.span);
  };
  if (elsewhere && is_moved(around.prompt, a.span, b.span)) return true;
  if (elsewhere && !is_one_statement(a, b) && (at_one_place(a) || at_one_place(b))) return true;
  const bool more = around.several.contains(a.subject) || is_one_statement(a, b) ||
                    (a.value > 0 && b.value > 0) || is_one_more(around.prompt, b.span);
  return elsewhere && is_single_door(a) && !more;
}

struct Exclusion {
  Kind a, b;
  bool (*exclude)(const Wish& of_a, const Wish& of_b, const Surroundings& around);
};
constexpr Exclusion exclusions[] = {
    {Kind::size, Kind::size, sizes_differ},
    {Kind::size, Kind::area, floor_differs},
    {Kind::area, Kind::area, areas_differ},
    {Kind::zone_count, Kind::zone_count, numbers_differ},
    {Kind::fixture_count, Kind::fixture_count, fixture_counts_differ},
    {Kind::run_count, Kind::run_count, counts_differ},
    {Kind::fixture_count, Kind::run_count, fixtures_are_banned},
    {Kind::aisle_count, Kind::aisle_count, numbers_differ},
    {Kind::aisle_width, Kind::aisle_width, numbers_differ},
    {Kind::levels, Kind::levels, shelf_numbers_differ},
    {Kind::shelf_pitch, Kind::shelf_pitch, shelf_numbers_differ},
    {Kind::height, Kind::height, heights_differ},
    {Kind::stock, Kind::stock, stocks_differ},
    {Kind::light, Kind::light, lights_exclude},
    {Kind::endcaps, Kind::endcaps, numbers_differ},
    {Kind::style, Kind::style, choices_differ},
    {Kind::profile, Kind::profile, choices_differ},
    {Kind::time, Kind::time, choices_differ},
    {Kind::material, Kind::material, choices_differ},
    {Kind::color, Kind::color, choices_differ},
    {Kind::product_present, Kind::product_absent, same_subject},
    {Kind::zone_absent, Kind::zone_present, needs_absent},
    {Kind::zone_absent, Kind::zone_count, needs_absent},
    {Kind::zone_absent, Kind::area, needs_absent},
    {Kind::zone_absent, Kind::product_present, needs_absent},
    {Kind::zone_absent, Kind::fixture_count, needs_absent},
    {Kind::zone_absent, Kind::run_count, needs_absent},
    {Kind::zone_absent, Kind::levels, needs_absent},
    {Kind::zone_absent, Kind::shelf_pitch, needs_absent},
    {Kind::zone_absent, Kind::height, needs_absent},
    {Kind::zone_absent, Kind::stock, needs_absent},
    {Kind::zone_absent, Kind::relation, needs_absent},
    {Kind::relation, Kind::relation, relations_exclude},
    {Kind::opening, Kind::opening, openings_exclude},
};

bool exclude(const Wish& a, const Wish& b, const Surroundings& around) {
  for (const Exclusion& row : exclusions) {
    if (row.a == a.kind && row.b == b.kind) return row.exclude(a, b, around);
    if (row.a == b.kind && row.b == a.kind) return row.exclude(b, a, around);
  }
  return false;
}

}  // namespace

std::array<double, 2> bounds_of(const Wish& wish) {
  const double low = wish.comparison == Comparison::at_most ? 0 : wish.value;
  const double high = wish.comparison == Comparison::at_least ? HUGE_VAL : wish.value;
  return {low, high};
}

bool is_negative(const Wish& wish) {
  const bool counted = wish.kind == Kind::fixture_count || wish.kind == Kind::endcaps ||
                       (wish.kind == Kind::opening && wish.comparison == Comparison::at_most);
  return wish.kind == Kind::zone_absent || wish.kind == Kind::product_absent ||
         (counted && asks_for_none(wish));
}

NamedThings Surroundings::things_of(const Wish& wish) const {
  const auto found = std::ranges::find_if(things, [&](const NamedThings& named) {
    return wish.kind == Kind::relation && named.span == wish.span;
  });
  return found == things.end() ? NamedThings{} : *found;
}

Surroundings surroundings_of(const Understanding& found,
                             std::string_view prompt,
                             plan::Wall entrance) {
  Surroundings around{prompt, std::string(name_of(entrance)), {}, {}, found.named};
  for (const Wish& wish : found.requirements) {
    if (wish.kind == Kind::zone_present || wish.kind == Kind::zone_count)
      around.mentioned.insert(wish.subject);
    if (wish.kind == Kind::product_present) around.mentioned.insert(wish.object);
    const bool counted = wish.kind == Kind::zone_count || wish.kind == Kind::opening;
    if (counted && bounds_of(wish)[0] >= 2) around.several.insert(wish.subject);
    const bool front = wish.kind == Kind::opening && wish.subject == "entrance";
    if (front && !wish.object.empty()) around.front = wish.object;
  }
  return around;
}

Together together(const Wish& earlier, const Wish& later, const Surroundings& around) {
  if (is_same(earlier, later)) return Together::same;
  if (is_vaguer(earlier, later, around)) return Together::first_is_vaguer;
  if (is_vaguer(later, earlier, around)) return Together::second_is_vaguer;
  return exclude(earlier, later, around) ? Together::exclude : Together::hold;
}

}  // namespace marketgen::intake
