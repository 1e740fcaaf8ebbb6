// Every construction of the grammar is read in its own example.
#include <algorithm>

#include "intake/lexical_input.h"
#include "intake_fixture.h"
#include "language/chart.h"

namespace marketgen {
namespace {

bool reads(const language::Grammar& grammar, const language::Rule& rule) {
  const intake::Lexicon& lexicon = shipped_lexicon();
  const std::vector<intake::Token> tokens = intake::tokenize(rule.example);
  const auto segments = intake::segments_of(tokens, lexicon);
  const language::Input input = intake::lexical_input(tokens, segments, lexicon);
  const language::Chart chart(grammar, input);
  const std::vector<language::Rule>& rules = grammar.rules();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i].line == rule.line && chart.used(static_cast<int>(i))) return true;
  }
  return false;
}

void expect_examples_read(const language::Grammar& grammar) {
  int last_line = 0;
  for (const language::Rule& rule : grammar.rules()) {
    if (rule.line == std::exchange(last_line, rule.line)) continue;  // a choice of the same one
    EXPECT_FALSE(rule.example.empty()) << "line " << rule.line;
    EXPECT_TRUE(reads(grammar, rule)) << "line " << rule.line << ": " << rule.example;
  }
}

TEST(GrammarExamples, EveryConstructionReadsItsExample) {
  expect_examples_read(*shipped_language().english.rules);
}

TEST(GrammarExamples, SoDoesEveryOneOfEdits) {
  const auto language = intake::Language::load_for_edits(MARKETGEN_SOURCE_DIR "/data");
  ASSERT_TRUE(language.ok()) << to_string(language.error());
  expect_examples_read(*language->english.rules);
}

TEST(GrammarExamples, EveryConstructionOfChineseReadsItsExample) {
  expect_examples_read(*shipped_language().chinese.rules);
}

}  // namespace
}  // namespace marketgen
