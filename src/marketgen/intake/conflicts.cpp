#include "intake/conflicts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace marketgen::intake {
namespace {

using Kind = plan::RequirementKind;

bool is_number(Kind kind) {
  constexpr std::array kinds = {Kind::area,
                                Kind::zone_count,
                                Kind::fixture_count,
                                Kind::run_count,
                                Kind::aisle_count,
                                Kind::levels,
                                Kind::height,
                                Kind::aisle_width,
                                Kind::stock,
                                Kind::light,
                                Kind::endcaps,
                                Kind::size,
                                Kind::shelf_pitch};
  return std::ranges::find(kinds, kind) != kinds.end();
}

bool is_choice(Kind kind) {
  return kind == Kind::style || kind == Kind::profile || kind == Kind::material ||
         kind == Kind::color;
}

// Least and most that a number may be.
std::array<double, 2> bounds_of(const plan::Requirement& wish) {
  const double low = wish.comparison == plan::Comparison::at_most ? 0 : wish.value;
  const double high = wish.comparison == plan::Comparison::at_least ? HUGE_VAL : wish.value;
  return {low, high};
}

bool numbers_clash(const plan::Requirement& a, const plan::Requirement& b) {
  const std::array<double, 2> first = bounds_of(a);
  const std::array<double, 2> second = bounds_of(b);
  const bool apart = first[1] < second[0] || second[1] < first[0];
  return apart || (a.kind == Kind::size && a.second_value != b.second_value);
}

bool opposite(Kind a, Kind b) {
  const auto pair = [&](Kind x, Kind y) { return (a == x && b == y) || (a == y && b == x); };
  return pair(Kind::zone_present, Kind::zone_absent) ||
         pair(Kind::product_present, Kind::product_absent) ||
         pair(Kind::zone_count, Kind::zone_absent);
}

bool opposite(plan::RelationKind a, plan::RelationKind b) {
  const auto pair = [&](plan::RelationKind x, plan::RelationKind y) {
    return (a == x && b == y) || (a == y && b == x);
  };
  return pair(plan::RelationKind::near, plan::RelationKind::far) ||
         pair(plan::RelationKind::near, plan::RelationKind::not_adjacent) ||
         pair(plan::RelationKind::left_of, plan::RelationKind::right_of) ||
         pair(plan::RelationKind::along, plan::RelationKind::far) ||
         pair(plan::RelationKind::at, plan::RelationKind::far);
}

bool opposite_sides(std::string_view a, std::string_view b) {
  const auto pair = [&](std::string_view x, std::string_view y) {
    return (a == x && b == y) || (a == y && b == x);
  };
  return pair("north", "south") || pair("east", "west") ||
         ((a == "center") != (b == "center") && (a == "center" || b == "center"));
}

bool stands_at_side(const plan::Requirement& wish) {
  return (wish.relation == plan::RelationKind::at || wish.relation == plan::RelationKind::along);
}

bool relations_clash(const plan::Requirement& a, const plan::Requirement& b) {
  if (a.subject == b.subject && a.object == b.object) return opposite(a.relation, b.relation);
  const bool swapped = a.subject == b.object && a.object == b.subject;
  if (swapped && a.relation == b.relation) {
    return a.relation == plan::RelationKind::left_of ||
           a.relation == plan::RelationKind::right_of || a.relation == plan::RelationKind::behind;
  }
  if (swapped)
    return opposite(a.relation, b.relation) && a.relation != plan::RelationKind::left_of &&
           a.relation != plan::RelationKind::right_of;
  return a.subject == b.subject && stands_at_side(a) && stands_at_side(b) &&
         opposite_sides(a.object, b.object);
}

// The floor of a size, and an area said of the shop.
bool floor_clashes(const plan::Requirement& size, const plan::Requirement& area) {
  if (size.value == 0 || size.second_value == 0 || !area.subject.empty()) return false;
  constexpr double tolerance = 0.05;
  const double m2 = 1e-6 * size.value * size.second_value;
  const std::array<double, 2> bounds = bounds_of(area);
  return m2 < bounds[0] * (1 - tolerance) || m2 > bounds[1] * (1 + tolerance);
}

bool openings_clash(const plan::Requirement& a, const plan::Requirement& b) {
  const auto differ = [](const std::string& x, const std::string& y) {
    return !x.empty() && !y.empty() && x != y;
  };
  if (a.subject != b.subject) return false;
  if (a.value > 0 && b.value > 0)
    return a.object == b.object && a.second_object == b.second_object && numbers_clash(a, b);
  const auto none = [](const plan::Requirement& wish) {
    return wish.comparison == plan::Comparison::at_most && wish.value == 0;
  };
  if (none(a) != none(b)) return true;
  return a.value == 0 && b.value == 0 &&
         (differ(a.object, b.object) || differ(a.second_object, b.second_object));
}

// "No frozen food" and "eight chest freezers": what is wanted belongs to a zone that is not.
bool belongs_to_absent(const plan::Requirement& absent, const plan::Requirement& wish) {
  constexpr std::array<std::string_view, 3> own = {"frozen", "checkout", "self_checkout"};
  const bool goods = wish.kind == Kind::product_present;
  const bool fixtures = wish.kind == Kind::fixture_count &&
                        wish.comparison != plan::Comparison::at_most && wish.value > 0 &&
                        std::ranges::find(own, wish.object) != own.end();  // shelves hold anything
  return absent.kind == Kind::zone_absent && (goods || fixtures) && wish.object == absent.subject;
}

bool clash(const plan::Requirement& a, const plan::Requirement& b) {
  if (belongs_to_absent(a, b) || belongs_to_absent(b, a)) return true;
  if (a.kind == Kind::relation && b.kind == Kind::relation) return relations_clash(a, b);
  if (a.kind == Kind::size && b.kind == Kind::area) return floor_clashes(a, b);
  if (a.kind == Kind::area && b.kind == Kind::size) return floor_clashes(b, a);
  if (opposite(a.kind, b.kind)) return a.subject == b.subject;
  const bool place_of_absent = a.kind == Kind::zone_absent && b.kind == Kind::relation;
  if (place_of_absent) return a.subject == b.subject && b.relation != plan::RelationKind::far;
  if (b.kind == Kind::zone_absent && a.kind == Kind::relation) return clash(b, a);
  if (a.kind != b.kind) return false;
  if (a.kind == Kind::opening) return openings_clash(a, b);
  const bool elsewhere = a.kind == Kind::fixture_count || a.kind == Kind::run_count;
  if (elsewhere && a.second_object != b.second_object) return false;
  if (is_choice(a.kind)) return a.subject == b.subject && a.object != b.object;
  const bool of_a_zone = a.kind == Kind::height || a.kind == Kind::stock;  // its zone is the object
  if (of_a_zone && a.object != b.object) return false;
  return is_number(a.kind) && a.subject == b.subject && numbers_clash(a, b);
}

bool same_wish(const plan::Requirement& a, const plan::Requirement& b) {
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.second_object == b.second_object && a.relation == b.relation &&
         a.comparison == b.comparison && a.value == b.value && a.second_value == b.second_value &&
         a.except == b.except;
}

// What the two wishes are about.
std::string topic(const plan::Requirement& wish) {
  std::string text(name_of(wish.kind));
  if (!wish.subject.empty()) text += " " + wish.subject;
  return text;
}

// True when the later of two wishes gives way.
bool earlier_wins(const plan::Requirement& earlier, const plan::Requirement& later) {
  return earlier.strength == plan::Strength::must && later.strength == plan::Strength::prefer;
}

constexpr std::array<std::string_view, 14> clause_ends = {
    ",", ".", ";", ":", "!", "?", "(", ")", "\n", "，", "。", "；", "：", "！"};

bool is_end(std::string_view text, std::size_t at, std::string_view mark) {
  if (text.substr(at, mark.size()) != mark) return false;
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  return at == 0 || !digit(at - 1) || !digit(at + 1);  // "4.50 m"
}

// The words from one comma or full stop to the next that hold the span.
std::string clause_of(std::string_view prompt, IntRange span) {
  const auto first = static_cast<std::size_t>(span[0]), last = static_cast<std::size_t>(span[1]);
  std::size_t begin = 0, end = prompt.size();
  for (const std::string_view mark : clause_ends) {
    for (std::size_t at = prompt.find(mark); at < end; at = prompt.find(mark, at + mark.size())) {
      if (!is_end(prompt, at, mark)) continue;
      if (at < first)
        begin = std::max(begin, at + mark.size());
      else if (at >= last)
        end = at;
    }
  }
  const std::string_view blank = " \t\r";
  begin = std::min(prompt.find_first_not_of(blank, begin), first);
  end = std::max(prompt.find_last_not_of(blank, end - 1) + 1, last);
  return std::string(prompt.substr(begin, end - begin));
}

// Both clauses, and which of them holds.
std::string why_lost(std::string_view prompt,
                     const plan::Requirement& earlier,
                     const plan::Requirement& later,
                     bool equal) {
  const std::string first = clause_of(prompt, earlier.span), second = clause_of(prompt, later.span);
  const std::string both = first == second ? "the two" : '"' + first + "\" and \"" + second + '"';
  return both + " contradict each other; " +
         (equal ? "what was said last holds" : "what must be wins over what is preferred");
}

void note_loss(Understanding& understanding,
               const plan::Requirement& loser,
               const plan::Requirement& kept,
               std::string why) {
  understanding.conflicts.push_back({topic(loser), kept.text, loser.text, std::move(why)});
}

std::string describe_flag(const Brief& brief, Kind kind) {
  if (kind == Kind::profile) return "--profile " + *brief.profile;
  if (kind == Kind::style) return "--style " + *brief.style;
  return "--size " + std::to_string((*brief.size_mm)[0]) + " x " +
         std::to_string((*brief.size_mm)[1]) + " mm";
}

bool flag_contradicts(const Brief& brief, const plan::Requirement& wish) {
  constexpr double rounding_mm = 1;
  switch (wish.kind) {
    case Kind::profile:
      return brief.profile && *brief.profile != wish.object;
    case Kind::style:
      return brief.style && *brief.style != wish.object;
    case Kind::size: {
      const auto differ = [](double said, int flag) {  // 0: that side was not said
        return said > 0 && std::abs(flag - said) > rounding_mm;
      };
      return brief.size_mm && (differ(wish.value, (*brief.size_mm)[0]) ||
                               differ(wish.second_value, (*brief.size_mm)[1]));
    }
    default:
      return false;
  }
}

}  // namespace

void settle_conflicts(Understanding& understanding, std::string_view prompt) {
  const std::vector<plan::Requirement>& wishes = understanding.requirements;
  std::vector<bool> lost(wishes.size(), false);  // taken out at the end: texts are slow to move
  for (std::size_t later = 1; later < wishes.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later && !lost[later]; ++earlier) {
      if (lost[earlier]) continue;
      if (same_wish(wishes[earlier], wishes[later])) {
        lost[later] = true;
      } else if (clash(wishes[earlier], wishes[later])) {
        const bool first = earlier_wins(wishes[earlier], wishes[later]);
        const std::size_t loser = first ? later : earlier;
        const plan::Requirement& kept = wishes[first ? earlier : later];
        const bool equal = kept.strength == wishes[loser].strength;
        note_loss(understanding,
                  wishes[loser],
                  kept,
                  why_lost(prompt, wishes[earlier], wishes[later], equal));
        lost[loser] = true;
      }
    }
  }
  std::vector<plan::Requirement> left;
  for (std::size_t i = 0; i < wishes.size(); ++i)
    if (!lost[i]) left.push_back(std::move(understanding.requirements[i]));
  understanding.requirements = std::move(left);
}

void apply_flags(const Brief& brief, Understanding& understanding) {
  for (std::size_t i = 0; i < understanding.requirements.size();) {
    const plan::Requirement wish = understanding.requirements[i];
    if (!flag_contradicts(brief, wish)) {
      ++i;
      continue;
    }
    plan::Requirement flag = wish;
    flag.text = describe_flag(brief, wish.kind);
    note_loss(understanding, wish, flag, "a flag wins over the text");
    understanding.requirements.erase(understanding.requirements.begin() +
                                     static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace marketgen::intake
