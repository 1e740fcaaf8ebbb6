#include "intake/interpret.h"

#include <algorithm>
#include <string_view>

#include "intake/place_nouns.h"

namespace marketgen::intake {
namespace {

using language::Meaning;

bool interpret_list(Reading& reading, const Meaning& list) {
  interpret_also(reading, list);
  return true;
}

bool interpret_nothing(Reading&, const Meaning&) {
  return true;
}

// Of two words for the kind of shop the more specific one counts: "discount supermarket" is a
// discounter.
bool interpret_profile(Reading& reading, const Meaning& said) {
  const double weight = said.number("number");
  if (weight < reading.profile_weight) return true;
  std::vector<plan::Requirement>& wishes = reading.found.requirements;
  if (weight > reading.profile_weight && reading.profile_weight > 0)
    std::erase_if(wishes, [&](const plan::Requirement& wish) {
      return wish.kind == plan::RequirementKind::profile;
    });
  reading.profile_weight = weight;
  reading.add(plan::RequirementKind::profile, said.span).object = said.text("value");
  return true;
}

bool interpret_style(Reading& reading, const Meaning& said) {
  reading.add(plan::RequirementKind::style, said.span).object = said.text("value");
  return true;
}

bool interpret_size_word(Reading& reading, const Meaning& said) {
  const auto& segments = *reading.segments;
  const auto last = static_cast<std::size_t>(said.words.back());
  const auto next =
      std::ranges::find_if(segments, [&](const Segment& segment) { return segment.first > last; });
  const bool of_shop = next != segments.end() && names_a_shop(*next);
  reading.found.sizes.push_back({said.number("number", 1), of_shop, said.span});
  return true;
}

bool interpret_light(Reading& reading, const Meaning& said) {
  plan::Requirement& light = reading.add(plan::RequirementKind::light, said.span);
  light.subject = said.text("value");
  light.value = said.number("number");
  constexpr double word_reach = 0.2;  // what "warm" or "bright" means. Our own figure
  if (!said.has("said")) light.second_value = word_reach * light.value;
  return true;
}

using Interpreter = bool (*)(Reading&, const Meaning&);
struct StatementKind {
  std::string_view name;
  Interpreter interpreter;
};
constexpr StatementKind statement_kinds[] = {
    {"floor", interpret_floor},
    {"floor_of_last", interpret_floor_of_last},
    {"floor_each", interpret_floor_each},
    {"side", interpret_side},
    {"profile", interpret_profile},
    {"shop", interpret_nothing},
    {"nothing", interpret_nothing},
    {"list", interpret_list},
    {"style", interpret_style},
    {"size_word", interpret_size_word},
    {"mention", interpret_mention},
    {"absent", interpret_absent},
    {"absent_at", interpret_absent_at},
    {"replaced", interpret_replaced},
    {"absent_but", interpret_absent_but},
    {"only", interpret_only},
    {"only_named", interpret_only_named},
    {"doors", interpret_doors},
    {"held", interpret_held},
    {"placed", interpret_placed},
    {"placed_each", interpret_placed_each},
    {"equipped", interpret_equipped},
    {"mutual", interpret_mutual},
    {"correction", interpret_correction},
    {"levels", interpret_levels},
    {"shelf_pitch", interpret_shelf_pitch},
    {"gap", interpret_gap},
    {"rows", interpret_rows},
    {"aisles", interpret_aisles},
    {"aisle_width", interpret_aisle_width},
    {"height", interpret_height},
    {"limited", interpret_limited},
    {"excepting", interpret_excepting},
    {"respectively", interpret_respectively},
    {"same_as", interpret_same_as},
    {"ratio", interpret_ratio},
    {"lots", interpret_lots},
    {"surface", interpret_surface},
    {"light", interpret_light},
    {"time", interpret_time},
    {"stock", interpret_stock},
    {"stocks", interpret_stocks},
    {"swap", interpret_swap},
    {"resize", interpret_resize},
    {"more", interpret_more},
    {"fewer", interpret_fewer},
    {"zone_value", interpret_zone_value},
    {"floor_of_it", interpret_floor_of_it},
    {"lacking", interpret_lacking},
    {"levels_of", interpret_levels_of},
    {"doors_on", interpret_doors_on},
    {"doors_at", interpret_doors_at},
    {"surfaces", interpret_surfaces},
    {"none_of_stock", interpret_none_of_stock},
    {"floor_of_shop", interpret_floor_of_shop},
    {"doors_shared", interpret_doors_shared},
    {"runs_each", interpret_runs_each},
    {"count_of_it", interpret_count_of_it},
};

}  // namespace

bool interpret(Reading& reading, const Meaning& statement) {
  const auto kind =
      std::ranges::find(statement_kinds, statement.text("kind"), &StatementKind::name);
  return kind != std::end(statement_kinds) && kind->interpreter(reading, statement);
}

void interpret_also(Reading& reading, const Meaning& statement) {
  for (const language::MeaningPtr& also : statement.parts("also")) {
    if (also->has("type"))
      mention(reading, *also);
    else
      interpret(reading, *also);
  }
}

void add_number(Reading& reading,
                const plan::Requirement& wish,
                const Meaning& number,
                bool whole) {
  plan::Requirement made = wish;
  const bool falls = number.has("upper") && number.number("upper") < number.number("value");
  made.value = falls ? number.number("upper")  // "from 2 to 1.6 m"
                     : number.number("value") + (whole ? number.number("shift") : 0);
  made.comparison =
      value_named<plan::Comparison>(number.text("comparison")).value_or(plan::Comparison::equal);
  const bool range = number.has("upper") && !falls;
  if (range) made.comparison = plan::Comparison::at_least;
  reading.found.requirements.push_back(made);
  if (!range) return;
  made.value = number.number("upper");
  made.comparison = plan::Comparison::at_most;
  reading.found.requirements.push_back(std::move(made));
}

void add_limit(Reading& reading,
               const plan::Requirement& wish,
               std::string plan::Requirement::*zone,
               const Meaning& number,
               bool whole) {
  plan::Requirement limit = wish;
  const bool of_all = (limit.*zone).empty() && reading.about.empty();
  if (of_all) limit.except = reading.except;
  if (of_all || !(limit.*zone).empty()) return add_number(reading, limit, number, whole);
  for (const std::string& type : reading.about) {
    limit.*zone = type;
    add_number(reading, limit, number, whole);
  }
}

std::vector<std::string> zones_of(const language::Parts& things) {
  std::vector<std::string> zones;
  for (const language::MeaningPtr& thing : things) {
    const std::string& type = thing->text("zone");
    if (!type.empty() && std::ranges::find(zones, type) == zones.end()) zones.push_back(type);
  }
  return zones;
}

}  // namespace marketgen::intake
