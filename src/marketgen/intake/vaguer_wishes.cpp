#include "intake/vaguer_wishes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "intake/clauses.h"
#include "intake/goods_words.h"

namespace marketgen::intake {
namespace {

using VagueWish = plan::Requirement;
using VagueKind = plan::RequirementKind;

// A word for light means what lies within a fifth of its number (second_value).
std::array<double, 2> light_of(const VagueWish& wish) {
  return {wish.value - wish.second_value, wish.value + wish.second_value};
}

// No meat, and no fish either.
bool are_both_halves(const VagueWish& a, const VagueWish& b) {
  return a.kind == VagueKind::zone_absent && a.subject == "meat_fish" &&
         names_fish(a.text) != names_fish(b.text);
}

// Every word for these is more telling than "supermarket".
bool is_kind_of_supermarket(const std::string& profile) {
  constexpr std::array<std::string_view, 8> telling = {"supermarket-us",
                                                       "supermarket-cn",
                                                       "discounter",
                                                       "organic-eu",
                                                       "hypermarket-eu",
                                                       "cash-and-carry",
                                                       "checkout-free",
                                                       "dark-store"};
  return std::ranges::find(telling, profile) != telling.end();
}

// Words that may mean a style, and more often something else ("food hall", "budget lines").
bool is_loose_style(const VagueWish& style, const Surroundings& around) {
  const bool loose = names_any(
      style.text,
      {"food hall", "market hall", "night",       "late",    "hospital", "bunker",   "barn",
       "budget",    "cheap",       "traditional", "bright",  "clean",    "fresh",    "family",
       "natural",   "raw",         "american",    "italian", "minimal",  "ordinary", "pastel",
       "urban",     "warehouse",   "bio",         "批发",    "农家"});
  const int end = clause_of(around.prompt, style.span)[1];
  const std::string_view after = text_at(around.prompt, {style.span[1], end});
  return loose &&
         !names_any(std::string(after), {"style", "look", "feel", "design", "theme", "风", "风格"});
}

// "Only drinks, snacks" without a comma, "no storeroom (backroom)": said in one breath.
bool is_one_breath(const VagueWish& absent, const VagueWish& present, std::string_view prompt) {
  constexpr int widest_gap = 3;  // bytes: a bracket, or one sign of full width
  return absent.kind == VagueKind::zone_absent && present.kind == VagueKind::zone_present &&
         absent.subject == present.subject && present.span[0] >= absent.span[1] &&
         present.span[0] - absent.span[1] <= widest_gap &&
         in_one_sentence(prompt, absent.span, present.span);
}

// Of two styles in one clause the last word says which it is: "a modern industrial loft".
bool is_vaguer_style(const VagueWish& a, const VagueWish& b, const Surroundings& around) {
  const bool loose = is_loose_style(a, around), other_loose = is_loose_style(b, around);
  if (loose != other_loose) return loose;
  const bool one_clause = clause_of(around.prompt, a.span) == clause_of(around.prompt, b.span);
  return one_clause && a.span[0] < b.span[0];
}

bool says_only(const VagueWish& absent) {
  return names_any(absent.text, {"only", "nothing", "exclusively", "solely", "只", "仅", "除了"});
}

}  // namespace

bool may_be_one_light(const VagueWish& a, const VagueWish& b) {
  const std::array<double, 2> first = light_of(a), second = light_of(b);
  return a.subject != b.subject || (first[1] >= second[0] && second[1] >= first[0]);
}

bool is_same(const VagueWish& a, const VagueWish& b) {
  if (are_both_halves(a, b)) return false;
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.second_object == b.second_object && a.relation == b.relation &&
         a.comparison == b.comparison && a.value == b.value &&
         (a.second_value == b.second_value || a.kind == VagueKind::profile) && a.except == b.except;
}

bool is_vaguer(const VagueWish& a, const VagueWish& b, const Surroundings& around) {
  if (is_one_breath(a, b, around.prompt)) return says_only(a);
  if (is_one_breath(b, a, around.prompt)) return !says_only(b);
  if (a.kind == VagueKind::style && b.kind == VagueKind::style)
    return is_vaguer_style(a, b, around);
  if (a.kind != b.kind || a.strength != b.strength) return false;
  if (a.kind == VagueKind::profile)
    return a.object == "supermarket-eu" && is_kind_of_supermarket(b.object);
  if (a.kind == VagueKind::opening)  // the wall, and its end
    return a.subject == b.subject && a.object == b.object && !a.object.empty() && a.value == 0 &&
           a.second_object.empty() && !b.second_object.empty();
  const bool lights = a.kind == VagueKind::light && a.subject == b.subject;
  return lights && b.second_value < a.second_value && may_be_one_light(a, b);
}

}  // namespace marketgen::intake
