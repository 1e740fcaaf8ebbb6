// Fixture rows without keywords are not words of prompts: a longer asset library leaves the
// planner's language as it is.
#include "intake_fixture.h"

namespace marketgen {
namespace {

std::string meaning_of(const intake::Lexicon& lexicon, const std::string& phrase) {
  const std::vector<intake::Token> tokens = intake::tokenize(phrase);
  std::string meaning;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const auto match = lexicon.longest_match(tokens, at);
    if (!match) continue;
    meaning += std::to_string(at) + "+" + std::to_string(match->tokens) + " " +
               std::string(name_of(match->row->sense)) + " " + match->row->value + "; ";
  }
  return meaning;
}

TEST(FixtureWords, VariantsAndMachinesAddNone) {
  catalog::Catalog smaller = committed_catalog();
  std::erase_if(smaller.fixture_kinds,
                [](const catalog::FixtureKind& k) { return k.keywords.empty(); });
  ASSERT_LT(smaller.fixture_kinds.size(), committed_catalog().fixture_kinds.size());
  const auto own = intake::Lexicon::load(MARKETGEN_SOURCE_DIR "/data/lexicon");
  ASSERT_TRUE(own.ok()) << to_string(own.error());
  const intake::Lexicon before = own->with_words_of(smaller);
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    EXPECT_EQ(meaning_of(shipped_lexicon(), kind.name), meaning_of(before, kind.name));
    for (const std::string& tag : kind.tags)
      EXPECT_EQ(meaning_of(shipped_lexicon(), tag), meaning_of(before, tag));
  }
}

TEST(FixtureWords, KindsOfLayoutsKeepTheirs) {
  EXPECT_NE(meaning_of(shipped_lexicon(), "gondola").find("gondola"), std::string::npos);
  EXPECT_NE(meaning_of(shipped_lexicon(), "island freezer").find("island_freezer"),
            std::string::npos);
}

}  // namespace
}  // namespace marketgen
