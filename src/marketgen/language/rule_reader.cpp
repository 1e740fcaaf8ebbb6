#include "language/rule_reader.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <tuple>
#include <utility>

namespace marketgen::language {
namespace {

constexpr int max_optional_items = 4;

bool is_name_byte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '#';
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The rule, and the example after "//".
std::pair<std::string, std::string> parted(std::string_view line) {
  const std::size_t comment = line.find("//");
  if (comment == std::string_view::npos) return {std::string(line), ""};
  const std::size_t example = line.find_first_not_of(" \t", comment + 2);
  return {std::string(line.substr(0, comment)),
          example == std::string_view::npos ? "" : std::string(line.substr(example))};
}

}  // namespace

Result<void> RuleReader::read(std::string_view line, int number) {
  Rule rule;
  std::tie(line_, rule.example) = parted(line);
  rule.line = number_ = number;
  at_ = 0;
  MARKETGEN_TRY(const std::string made, read_name("the category that is made"));
  rule.made = grammar_.category_named(made);
  if (!take(':')) return fault("after the category comes ':'");
  std::vector<OptionalItem> items;
  MARKETGEN_CHECK(read_items(items));
  if (take('=')) MARKETGEN_CHECK(read_assignments(rule, static_cast<int>(items.size())));
  if (take('!')) {
    MARKETGEN_TRY(rule.cost, read_number());
  }
  if (!at_end()) return fault(fmt::format("\"{}\" is left over", line_.substr(at_)));
  if (rule.assignments.empty() && items.size() == 1)
    rule.assignments.push_back({"", {{Term::Kind::item, 0, "", 1}}});
  add_choices(rule, items);
  return {};
}

Result<void> RuleReader::read_items(std::vector<OptionalItem>& items) {
  int optional = 0;
  for (skip_space(); !at_end() && line_[at_] != '=' && line_[at_] != '!'; skip_space()) {
    MARKETGEN_TRY(OptionalItem item, read_item());
    item.item.number = static_cast<int>(items.size()) + 1;
    optional += item.optional ? 1 : 0;
    items.push_back(std::move(item));
  }
  if (static_cast<int>(items.size()) == optional)
    return fault("a rule has an item that must be there");
  if (optional > max_optional_items)
    return fault(fmt::format("at most {} items may be missing", max_optional_items));
  return {};
}

Result<RuleReader::OptionalItem> RuleReader::read_item() {
  OptionalItem item;
  if (take('\'')) {
    MARKETGEN_TRY(const std::string word, read_quoted());
    item.item.category = grammar_.category_named("'" + word + "'");
  } else {
    MARKETGEN_TRY(const std::string name, read_name("an item"));
    item.item.category = grammar_.category_named(name);
  }
  if (at_ < line_.size() && line_[at_] == '[') {
    MARKETGEN_TRY(item.item.constraints, read_constraints());
  }
  if (at_ < line_.size() && line_[at_] == '?') {
    item.optional = true;
    ++at_;
  }
  return item;
}

Result<std::vector<Constraint>> RuleReader::read_constraints() {
  std::vector<Constraint> constraints;
  take('[');
  do {
    Constraint constraint;
    if (take('!')) constraint.test = Constraint::Test::absent;
    MARKETGEN_TRY(constraint.slot, read_name("a slot"));
    const bool unequal = constraint.test != Constraint::Test::absent && take('!');
    if (take('=')) {
      constraint.test = unequal ? Constraint::Test::unequal : Constraint::Test::equal;
      if (take('\'')) {
        MARKETGEN_TRY(constraint.value, read_quoted());
      } else {
        MARKETGEN_TRY(constraint.value, read_name("what the slot says"));
      }
    } else if (unequal) {
      return fault("after '!' comes '='");
    }
    constraints.push_back(std::move(constraint));
  } while (take(','));
  if (!take(']')) return fault("what an item must say ends with ']'");
  return constraints;
}

Result<void> RuleReader::read_assignments(Rule& rule, int items) {
  do {
    MARKETGEN_TRY(Assignment assignment, read_assignment(items));
    rule.assignments.push_back(std::move(assignment));
  } while (take(','));
  return {};
}

Result<Assignment> RuleReader::read_assignment(int items) {
  Assignment assignment;
  skip_space();
  if (take('@')) {
    MARKETGEN_TRY(Term term, read_term(items));
    if (term.kind != Term::Kind::item) return fault("after '@' comes the number of an item");
    assignment.terms.push_back(std::move(term));
    return assignment;
  }
  MARKETGEN_TRY(assignment.slot, read_name("a slot"));
  if (!take(':')) return fault(fmt::format("after the slot \"{}\" comes ':'", assignment.slot));
  for (bool more = true; more;) {
    MARKETGEN_TRY(Term term, read_term(items));
    assignment.terms.push_back(std::move(term));
    const bool times = take('*');
    assignment.product = assignment.product || times;
    more = times || take('+');
  }
  return assignment;
}

// "1" is item 1 and "1.value" what it says; "1000" is a number since no rule has so many items.
Result<Term> RuleReader::read_term(int items) {
  skip_space();
  Term term;
  const bool numeric = at_ < line_.size() && (is_digit(line_[at_]) || line_[at_] == '-');
  if (!numeric) {
    MARKETGEN_TRY(term.name, read_name("what the slot says"));
    return term;
  }
  const std::size_t start = at_;
  MARKETGEN_TRY(term.number, read_number());
  const auto item = static_cast<int>(term.number);
  const bool whole = line_.find('.', start) >= at_ || line_.find('.', start) == std::string::npos;
  term.kind = Term::Kind::number;
  if (!whole || item < 1 || item > items) return term;
  term.item = item;
  term.kind = Term::Kind::item;
  if (at_ < line_.size() && line_[at_] == '.') {
    ++at_;
    term.kind = Term::Kind::slot;
    MARKETGEN_TRY(term.name, read_name("a slot"));
  }
  return term;
}

// After the first '.
Result<std::string> RuleReader::read_quoted() {
  const std::size_t start = at_, end = line_.find('\'', at_);
  if (end == std::string::npos || end == start) return fault("a word ends with a second '");
  at_ = end + 1;
  return line_.substr(start, end - start);
}

Result<std::string> RuleReader::read_name(std::string_view what) {
  skip_space();
  const std::size_t start = at_;
  while (at_ < line_.size() && is_name_byte(line_[at_]))
    ++at_;
  if (at_ == start) return fault(fmt::format("{} is missing", what));
  return line_.substr(start, at_ - start);
}

// A fraction only where digits follow the point: "1.value" is item 1.
Result<double> RuleReader::read_number() {
  skip_space();
  const std::size_t start = at_;
  if (at_ < line_.size() && line_[at_] == '-') ++at_;
  while (at_ < line_.size() && is_digit(line_[at_]))
    ++at_;
  if (at_ + 1 < line_.size() && line_[at_] == '.' && is_digit(line_[at_ + 1])) {
    for (++at_; at_ < line_.size() && is_digit(line_[at_]);)
      ++at_;
  }
  double value = 0;
  const auto [end, failure] = std::from_chars(line_.data() + start, line_.data() + at_, value);
  if (failure != std::errc() || end != line_.data() + at_) return fault("a number is missing");
  return value;
}

void RuleReader::add_choices(const Rule& rule, const std::vector<OptionalItem>& items) {
  int optional = 0;
  for (const OptionalItem& item : items)
    optional += item.optional ? 1 : 0;
  for (int missing = 0; missing < (1 << optional); ++missing) {
    Rule chosen = rule;
    chosen.written_items = static_cast<int>(items.size());
    int bit = 0;
    for (const OptionalItem& item : items) {
      const bool left_out = item.optional && ((missing >> bit++) & 1) != 0;
      if (!left_out) chosen.items.push_back(item.item);
    }
    grammar_.add(std::move(chosen));
  }
}

void RuleReader::skip_space() {
  while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t'))
    ++at_;
}

bool RuleReader::take(char c) {
  skip_space();
  if (at_ >= line_.size() || line_[at_] != c) return false;
  ++at_;
  return true;
}

bool RuleReader::at_end() {
  skip_space();
  return at_ >= line_.size();
}

Error RuleReader::fault(const std::string& message) const {
  return {"grammar.bad_rule", fmt::format("{}:{}", where_, number_), message};
}

}  // namespace marketgen::language
