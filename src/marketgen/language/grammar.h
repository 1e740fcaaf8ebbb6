// Rules that put constituents together, each with what the whole then says.
//
// A grammar is text, one rule a line:
//
//   length : number unit[value=length] = mm: 1.value * 2.number   // 24 m
//
// left of ':' the category that is made; right of it its items in their order: a category, or
// 'a word' by its stem. In brackets what an item must say: [slot=value], [slot=','], [slot!=value],
// [slot] (it says something), [!slot] (nothing). An item with ? may be missing. After '=' what the
// whole says, parted by commas: a number, a name, item 1 (what it says, as a part), 1.slot,
// products (numbers) and sums (numbers, or parts one after the other); @1 takes over all that item
// 1 says. A rule with one item and no '=' takes over what it says. "!2" before the comment is what
// the reading costs: of two readings of the same words the cheaper one is taken (chart.h). After //
// stands an example, which a test reads. A line that begins with # is a comment, and one that
// begins with white space goes on with the line before.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/meaning.h"

namespace marketgen::language {

using Category = int;  // a name of Grammar's, as an index

struct Constraint {
  enum class Test { equal, unequal, present, absent };
  std::string slot;
  Test test = Test::present;
  std::string value;

  bool holds(const Meaning& meaning) const;
};

struct Item {
  Category category = 0;
  std::vector<Constraint> constraints;
  int number = 0;  // counted from 1 in the rule as written, optional ones included

  bool takes(const Meaning& meaning) const;
};

struct Term {
  enum class Kind { number, name, item, slot };
  Kind kind = Kind::name;
  double number = 0;
  std::string name;  // of kind name, or the slot
  int item = 0;      // of kind item and slot
};

struct Assignment {
  std::string slot;  // "" takes over all that `terms[0].item` says
  std::vector<Term> terms;
  bool product = false;  // otherwise a sum
};

struct Rule {
  Category made = 0;
  std::vector<Item> items;
  int written_items = 0;  // with those that this choice leaves out
  std::vector<Assignment> assignments;
  double cost = 0;
  int line = 0;  // of its file; rules of one line are one construction
  std::string example;
};

class Grammar {
 public:
  // `where` is named in errors. Error: grammar.bad_rule, with the line and what is wrong there.
  static Result<Grammar> parse(std::string_view text, const std::string& where);
  static Result<Grammar> load(const std::filesystem::path& file);

  const std::vector<Rule>& rules() const { return rules_; }
  // Rules whose first item is of the category, by index.
  const std::vector<int>& beginning_with(Category category) const;
  // Nothing for names that no rule has.
  std::optional<Category> category(std::string_view name) const;
  // Whether some rule asks for that very word.
  bool has_word(std::string_view stem) const;

 private:
  friend class RuleReader;
  Category category_named(std::string_view name);
  void add(Rule rule);

  std::vector<Rule> rules_;
  std::vector<std::vector<int>> beginning_with_;  // by category
  std::map<std::string, Category, std::less<>> categories_;
};

// What the whole says when these are its items; null for one that is missing. By Item::number - 1.
Meaning composed(const Rule& rule, const std::vector<MeaningPtr>& items);

}  // namespace marketgen::language
