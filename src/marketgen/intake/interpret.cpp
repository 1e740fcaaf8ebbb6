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
  reading.found.size_factor *= said.number("number", 1);
  return true;
}

bool interpret_light(Reading& reading, const Meaning& said) {
  plan::Requirement& light = reading.add(plan::RequirementKind::light, said.span);
  light.subject = said.text("value");
  light.value = said.number("number");
  return true;
}

// Full shelves and gaps are floors, order is a ceiling; the row says which side its number is on.
bool interpret_stock(Reading& reading, const Meaning& said) {
  plan::Requirement& stock = reading.add(plan::RequirementKind::stock, said.span);
  stock.subject = said.text("value");
  stock.value = said.number("number");
  stock.comparison =
      value_named<plan::Comparison>(said.text("comparison")).value_or(plan::Comparison::equal);
  return true;
}

using Interpreter = bool (*)(Reading&, const Meaning&);
struct StatementKind {
  std::string_view name;
  Interpreter interpreter;
};
constexpr StatementKind statement_kinds[] = {
    {"floor", interpret_floor},
    {"side", interpret_side},
    {"profile", interpret_profile},
    {"shop", interpret_nothing},
    {"nothing", interpret_nothing},
    {"list", interpret_list},
    {"style", interpret_style},
    {"size_word", interpret_size_word},
    {"mention", interpret_mention},
    {"absent", interpret_absent},
    {"only", interpret_only},
    {"doors", interpret_doors},
    {"held", interpret_held},
    {"placed", interpret_placed},
    {"levels", interpret_levels},
    {"rows", interpret_rows},
    {"aisles", interpret_aisles},
    {"aisle_width", interpret_aisle_width},
    {"height", interpret_height},
    {"surface", interpret_surface},
    {"light", interpret_light},
    {"stock", interpret_stock},
    {"swap", interpret_swap},
    {"resize", interpret_resize},
    {"more", interpret_more},
    {"fewer", interpret_fewer},
    {"zone_value", interpret_zone_value},
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
  made.value = number.number("value") + (whole ? number.number("shift") : 0);
  made.comparison =
      value_named<plan::Comparison>(number.text("comparison")).value_or(plan::Comparison::equal);
  if (number.has("upper")) made.comparison = plan::Comparison::at_least;
  reading.found.requirements.push_back(made);
  if (!number.has("upper")) return;
  made.value = number.number("upper");
  made.comparison = plan::Comparison::at_most;
  reading.found.requirements.push_back(std::move(made));
}

}  // namespace marketgen::intake
