#include "language/grammar.h"

#include <algorithm>

#include "base/text.h"
#include "io/file.h"
#include "language/rule_reader.h"

namespace marketgen::language {
namespace {

// Slots that a missing item or an empty slot leaves empty.
std::optional<SlotValue> value_of(const Term& term, const std::vector<MeaningPtr>& items) {
  if (term.kind == Term::Kind::number) return term.number;
  if (term.kind == Term::Kind::name) return term.name;
  const MeaningPtr& item = items[static_cast<std::size_t>(term.item) - 1];
  if (!item) return std::nullopt;
  if (term.kind == Term::Kind::item) return Parts{item};
  const auto found = item->slots.find(term.name);
  if (found == item->slots.end()) return std::nullopt;
  return found->second;
}

// Parts follow one another; numbers are multiplied or added; of names the last counts.
SlotValue joined(const SlotValue& a, const SlotValue& b, bool product) {
  if (const Parts* more = std::get_if<Parts>(&b)) {
    Parts parts;
    if (const Parts* first = std::get_if<Parts>(&a)) parts = *first;
    parts.insert(parts.end(), more->begin(), more->end());
    return parts;
  }
  const double *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return b;
  return product ? *x * *y : *x + *y;
}

}  // namespace

bool Constraint::holds(const Meaning& meaning) const {
  switch (test) {
    case Test::present:
      return meaning.has(slot);
    case Test::absent:
      return !meaning.has(slot);
    case Test::equal:
      return meaning.is(slot, value);
    default:
      return !meaning.is(slot, value);
  }
}

bool Item::takes(const Meaning& meaning) const {
  return std::ranges::all_of(
      constraints, [&](const Constraint& constraint) { return constraint.holds(meaning); });
}

Result<Grammar> Grammar::parse(std::string_view text, const std::string& where) {
  Grammar grammar;
  RuleReader reader(grammar, where);
  std::string rule;
  int begun = 0, number = 0;
  const auto finish = [&]() -> Result<void> {
    if (!rule.empty()) MARKETGEN_CHECK(reader.read(rule, begun));
    rule.clear();
    return {};
  };
  for (const std::string& line : split(text, '\n')) {
    ++number;
    const bool goes_on = line.starts_with(' ') || line.starts_with('\t');
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
    if (goes_on && !rule.empty()) {
      rule += line;
      continue;
    }
    MARKETGEN_CHECK(finish());
    rule = line;
    begun = number;
  }
  MARKETGEN_CHECK(finish());
  return grammar;
}

Result<Grammar> Grammar::load(const std::filesystem::path& file) {
  MARKETGEN_TRY(const std::string text, io::read_file(file));
  return parse(text, file.string());
}

const std::vector<int>& Grammar::beginning_with(Category category) const {
  return beginning_with_[static_cast<std::size_t>(category)];
}

std::optional<Category> Grammar::category(std::string_view name) const {
  const auto found = categories_.find(name);
  if (found == categories_.end()) return std::nullopt;
  return found->second;
}

bool Grammar::has_word(std::string_view stem) const {
  return categories_.contains("'" + std::string(stem) + "'");
}

Category Grammar::category_named(std::string_view name) {
  const auto [at, is_new] =
      categories_.try_emplace(std::string(name), static_cast<Category>(beginning_with_.size()));
  if (is_new) beginning_with_.emplace_back();
  return at->second;
}

void Grammar::add(Rule rule) {
  beginning_with_[static_cast<std::size_t>(rule.items.front().category)].push_back(
      static_cast<int>(rules_.size()));
  rules_.push_back(std::move(rule));
}

Meaning composed(const Rule& rule, const std::vector<MeaningPtr>& items) {
  Meaning whole;
  for (const Assignment& assignment : rule.assignments) {
    if (assignment.slot.empty()) {
      const MeaningPtr& item = items[static_cast<std::size_t>(assignment.terms[0].item) - 1];
      if (item) {
        for (const auto& [slot, value] : item->slots)
          whole.slots.insert_or_assign(slot, value);
      }
      continue;
    }
    std::optional<SlotValue> value;
    for (const Term& term : assignment.terms) {
      std::optional<SlotValue> next = value_of(term, items);
      if (!next) continue;
      value = value ? joined(*value, *next, assignment.product) : std::move(*next);
    }
    if (value) whole.slots.insert_or_assign(assignment.slot, std::move(*value));
  }
  return whole;
}

}  // namespace marketgen::language
