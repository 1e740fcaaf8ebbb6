#include "intake/store_name.h"

#include <algorithm>

namespace marketgen::intake {
namespace {

constexpr std::size_t longest_name = 6;          // words
constexpr std::size_t longest_name_bytes = 120;  // of Plan::name

struct Stretch {
  std::size_t first = 0, last = 0;  // tokens, past the last
  bool empty() const { return first >= last; }
};

bool is_quote(const Token& token) {
  return token.kind == TokenKind::symbol && token.text == "\"";
}

// The words between a quotation mark at `i` and the next one.
Stretch quoted(const std::vector<Token>& tokens, std::size_t i) {
  if (i >= tokens.size() || !is_quote(tokens[i])) return {};
  for (std::size_t end = i + 1; end < tokens.size(); ++end) {
    if (is_quote(tokens[end])) return {i + 1, end};
  }
  return {};
}

// Where a name begins after "店招统一为": what says nothing before a quotation mark is passed over.
std::size_t past_small_words(const std::vector<Token>& tokens,
                             std::size_t i,
                             const Lexicon& lexicon) {
  constexpr int most = 3;  // phrases
  std::size_t at = i;
  for (int passed = 0; passed < most && at < tokens.size() && tokens[at].han; ++passed) {
    const auto match = lexicon.longest_match(tokens, at);
    if (!match || (match->row->sense != Sense::filler && match->row->sense != Sense::word)) break;
    at += match->tokens;
  }
  return at < tokens.size() && is_quote(tokens[at]) ? at : i;
}

// Capitalised words, with "&", "of" and "the" between them.
Stretch capitalised(const std::vector<Token>& tokens, std::size_t i) {
  std::size_t end = i;
  for (std::size_t k = i; k < tokens.size() && k < i + longest_name; ++k) {
    const Token& token = tokens[k];
    const bool link = token.text == "&" || token.text == "of" || token.text == "the";
    if (!token.capital && !link) break;
    if (token.capital) end = k + 1;
  }
  return {i, end};
}

// "called riverside fresh with …": words up to one that has a part in the sentence.
Stretch plain_words(const std::vector<Token>& tokens, std::size_t i, const Lexicon& lexicon) {
  std::size_t end = i;
  while (end < tokens.size() && end < i + longest_name && tokens[end].kind == TokenKind::word &&
         !lexicon.longest_match(tokens, end)) {
    ++end;
  }
  return {i, end};
}

// "I'd call the style "farmhouse"": a word that says something of the store is no name of it.
bool is_word_of_ours(const std::vector<Token>& tokens, Stretch quoted, const Lexicon& lexicon) {
  const auto match = lexicon.longest_match(tokens, quoted.first);
  const bool whole = match && quoted.first + match->tokens == quoted.last;
  return whole && !tokens[quoted.first].capital && !tokens[quoted.first].han;
}

StoreName name_of_stretch(std::string_view prompt,
                          const std::vector<Token>& tokens,
                          Stretch stretch) {
  StoreName name;
  name.span = {tokens[stretch.first].span[0], tokens[stretch.last - 1].span[1]};
  name.text = prompt.substr(static_cast<std::size_t>(name.span[0]),
                            static_cast<std::size_t>(name.span[1] - name.span[0]));
  return name;
}

// "A café called Rosa", "sweets named Haribo": not the shop's.
bool is_of_goods(const std::vector<Token>& tokens, std::size_t naming, const Lexicon& lexicon) {
  constexpr std::size_t longest_noun = 3;  // words
  for (std::size_t length = 1; length <= std::min(longest_noun, naming); ++length) {
    const auto match = lexicon.longest_match(tokens, naming - length);
    if (!match || match->tokens != length) continue;
    const Sense sense = match->row->sense;
    if (sense == Sense::zone || sense == Sense::product || sense == Sense::fixture) return true;
  }
  return false;
}

}  // namespace

std::vector<StoreName> take_store_names(std::string_view prompt,
                                        std::vector<Token>& tokens,
                                        const Lexicon& lexicon) {
  std::vector<StoreName> names;
  bool named = false;  // the shop, by a word for it, and not by quotation marks alone
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto match = lexicon.longest_match(tokens, i);
    const bool naming = match && match->row->sense == Sense::naming;
    const bool of_goods = naming && is_of_goods(tokens, i, lexicon);
    if (!names.empty() && (!naming || of_goods)) continue;
    const std::size_t at = naming ? past_small_words(tokens, i + match->tokens, lexicon) : i;
    Stretch name = quoted(tokens, at);
    const bool in_quotes = !name.empty();
    if (in_quotes && !naming && is_word_of_ours(tokens, name, lexicon)) {
      i = name.last;
      continue;
    }
    if (naming && name.empty()) name = capitalised(tokens, at);
    if (naming && name.empty()) name = plain_words(tokens, at, lexicon);
    if (name.empty()) continue;
    StoreName found = name_of_stretch(prompt, tokens, name);
    if (found.text.size() > longest_name_bytes) continue;
    if (naming && !named) names.clear();
    named = named || (naming && !of_goods);
    names.push_back(std::move(found));
    const std::size_t end = name.last + (in_quotes ? 1 : 0);
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                 tokens.begin() + static_cast<std::ptrdiff_t>(end));
    --i;  // goes on with what follows the name
  }
  return names;
}

}  // namespace marketgen::intake
