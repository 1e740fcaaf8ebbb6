// Every construction of the grammar is read in its own example.
#include <algorithm>

#include "intake/lexical_input.h"
#include "intake_fixture.h"
#include "language/chart.h"

namespace marketgen {
namespace {

bool reads(const language::Rule& rule) {
  const intake::Language& english = shipped_language();
  const std::vector<intake::Token> tokens = intake::tokenize(rule.example);
  const auto segments = intake::segments_of(tokens, english.lexicon);
  const language::Input input = intake::lexical_input(tokens, segments, english.lexicon);
  const language::Chart chart(*english.grammar, input);
  const std::vector<language::Rule>& rules = english.grammar->rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i].line == rule.line && chart.used(static_cast<int>(i))) return true;
  }
  return false;
}

TEST(GrammarExamples, EveryConstructionReadsItsExample) {
  int last_line = 0;
  for (const language::Rule& rule : shipped_language().grammar->rules()) {
    if (rule.line == std::exchange(last_line, rule.line)) continue;  // a choice of the same one
    EXPECT_FALSE(rule.example.empty()) << "line " << rule.line;
    EXPECT_TRUE(reads(rule)) << "line " << rule.line << ": " << rule.example;
  }
}

}  // namespace
}  // namespace marketgen
