// What the intake tests share: the shipped catalogue and lexicon, read once, and requirements as
// short lines of text.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/language.h"
#include "support/committed_catalog.h"

namespace marketgen {

inline const intake::Language& shipped_language() {
  static const intake::Language language = [] {
    auto loaded = intake::Language::load(MARKETGEN_SOURCE_DIR "/data");
    if (!loaded.ok()) fatal(to_string(loaded.error()).c_str());
    return loaded->with_words_of(committed_catalog());
  }();
  return language;
}
inline const intake::Lexicon& shipped_lexicon() {
  return shipped_language().lexicon;
}

inline const intake::Planner& shipped_planner() {
  static const std::unique_ptr<intake::Planner> planner = [] {
    auto made = intake::offline_planner();
    if (!made.ok()) fatal(to_string(made.error()).c_str());
    return std::move(made).value();
  }();
  return *planner;
}

// "relation left_of bakery entrance", "fixture_count checkout_lane >=3", "size 24000x15000",
// "?zone_present cafe" (a wish that is only preferred).
inline std::string line_of(const plan::Requirement& wish) {
  const auto number = [](double value) {
    std::string text = std::to_string(value);
    while (text.ends_with('0'))
      text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
  };
  std::string line = wish.strength == plan::Strength::prefer ? "?" : "";
  line += name_of(wish.kind);
  if (wish.kind == plan::RequirementKind::relation)
    line += " " + std::string(name_of(wish.relation));
  const bool implied = wish.kind == plan::RequirementKind::fixture_count ||
                       wish.kind == plan::RequirementKind::product_present ||
                       wish.kind == plan::RequirementKind::product_absent;
  for (const std::string* text : {&wish.subject, &wish.object, &wish.second_object}) {
    if (implied && text != &wish.subject) continue;  // the zone that goes with it
    if (!text->empty()) line += " " + *text;
  }
  for (const std::string& zone : wish.except)
    line += " but " + zone;
  if (wish.kind == plan::RequirementKind::size) {
    return line + " " + number(wish.value) + "x" + number(wish.second_value);
  }
  if (wish.value == 0 && wish.comparison == plan::Comparison::equal) return line;
  const std::string sign = wish.comparison == plan::Comparison::at_least  ? ">="
                           : wish.comparison == plan::Comparison::at_most ? "<="
                                                                          : "";
  return line + " " + sign + number(wish.value);
}

inline std::vector<std::string> sorted_lines(const std::vector<plan::Requirement>& wishes) {
  std::vector<std::string> lines;
  for (const plan::Requirement& wish : wishes)
    lines.push_back(line_of(wish));
  std::ranges::sort(lines);
  return lines;
}

}  // namespace marketgen
