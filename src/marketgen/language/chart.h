// All readings of a row of tokens by a grammar: a bottom-up chart.
//
// What the grammar cannot read is no error: the chart holds what it made of parts of the row, and
// best_cover() chooses among them.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "language/grammar.h"

namespace marketgen::language {

// What the lexicon knows of some tokens.
struct LexicalEntry {
  int begin = 0, end = 0;  // tokens, [begin, end)
  std::string category;
  Meaning meaning;  // its slots; words and span are filled in by the chart
  double cost = 1;
};

struct InputToken {
  std::string stem;     // what 'words' of rules are compared with
  IntRange span{0, 0};  // bytes of the text
  // Passing over it within a construction costs so much; negative: it may not be passed over.
  double skip_cost = -1;
  bool counts = true;  // a word that should be understood
};

struct Input {
  std::vector<InputToken> tokens;
  std::vector<LexicalEntry> entries;
};

struct Constituent;
using ConstituentPtr = std::shared_ptr<const Constituent>;
struct Constituent {
  Category category = 0;
  int begin = 0, end = 0;  // tokens, [begin, end)
  double cost = 0;         // of its words, rules and what was passed over
  MeaningPtr meaning;
  int rule = -1;  // index; -1 for a word
};

struct ChartLimits {
  double max_gap_cost = 5;         // between two items
  int max_readings = 6;            // of one category over the same tokens, the cheapest
  std::size_t max_edges = 200000;  // of a sentence; then it ends with what it has
};

class Chart {
 public:
  Chart(const Grammar& grammar, const Input& input, ChartLimits limits = {});

  // Everything of that category.
  std::vector<ConstituentPtr> of(Category category) const;
  // Whether some constituent was made by the rule: a test of examples.
  bool used(int rule) const;
  bool full() const { return edges_ >= limits_.max_edges; }  // some readings were not looked for

 private:
  struct Begun {              // a rule whose first items were found
    int rule = 0, found = 0;  // items
    int begin = 0, end = 0;
    double cost = 0;
    std::vector<MeaningPtr> items;
  };
  void read();
  void add(const ConstituentPtr& made);
  void extend(const Begun& begun, const ConstituentPtr& next, double gap_cost);
  void finish(const Begun& begun);

  const Grammar& grammar_;
  const Input& input_;
  ChartLimits limits_;
  std::vector<std::vector<ConstituentPtr>> ending_;            // by end
  std::vector<std::map<Category, std::vector<Begun>>> begun_;  // by end and the category awaited
  std::vector<ConstituentPtr> agenda_;                         // end at the position that is read
  std::vector<std::vector<std::pair<int, double>>> gaps_;  // by position: where what came before
                                                           // may end, and what lies between costs
  std::size_t edges_ = 0;
};

struct CoverRules {
  double of_word = 10;        // that is understood
  double of_filler = 2;       // that has a part in it
  double of_constituent = 3;  // few large ones rather than many small ones
};

// Constituents of that category, one after the other without overlap, that understand the most at
// the least cost. Deterministic: of two alike the earlier and longer.
std::vector<ConstituentPtr> best_cover(const Chart& chart,
                                       Category category,
                                       const Input& input,
                                       CoverRules rules = {});

}  // namespace marketgen::language
