// The text of a grammar, line by line (grammar.h says how it is written).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/grammar.h"

namespace marketgen::language {

class RuleReader {
 public:
  RuleReader(Grammar& grammar, std::string where) : grammar_(grammar), where_(std::move(where)) {}

  // One construction, with its comment. Adds a rule for each choice of its optional items.
  Result<void> read(std::string_view line, int number);

 private:
  struct OptionalItem {
    Item item;
    bool optional = false;
  };

  Result<void> read_items(std::vector<OptionalItem>& items);
  Result<OptionalItem> read_item();
  Result<std::vector<Constraint>> read_constraints();
  Result<void> read_assignments(Rule& rule, int items);
  Result<Assignment> read_assignment(int items);
  Result<Term> read_term(int items);
  Result<std::string> read_name(std::string_view what);
  Result<std::string> read_quoted();
  Result<double> read_number();

  void add_choices(const Rule& rule, const std::vector<OptionalItem>& items);
  void skip_space();
  bool take(char c);
  bool at_end();
  Error fault(const std::string& message) const;

  Grammar& grammar_;
  std::string where_, line_;
  std::size_t at_ = 0;
  int number_ = 0;
};

}  // namespace marketgen::language
