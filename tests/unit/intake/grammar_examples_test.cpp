// Every construction of the grammar is read in its own example.
#include <algorithm>

#include "intake/lexical_input.h"
#include "intake_fixture.h"
#include "language/chart.h"

namespace marketgen {
namespace {

bool reads(const intake::Language& english, const language::Rule& rule) {
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

void expect_examples_read(const intake::Language& language) {
  int last_line = 0;
  for (const language::Rule& rule : language.grammar->rules()) {
    if (rule.line == std::exchange(last_line, rule.line)) continue;  // a choice of the same one
    EXPECT_FALSE(rule.example.empty()) << "line " << rule.line;
    EXPECT_TRUE(reads(language, rule)) << "line " << rule.line << ": " << rule.example;
  }
}

TEST(GrammarExamples, EveryConstructionReadsItsExample) {
  expect_examples_read(shipped_language());
}

TEST(GrammarExamples, SoDoesEveryOneOfEdits) {
  const auto language = intake::Language::load_for_edits(MARKETGEN_SOURCE_DIR "/data");
  ASSERT_TRUE(language.ok()) << to_string(language.error());
  expect_examples_read(language->with_words_of(committed_catalog()));
}

}  // namespace
}  // namespace marketgen
