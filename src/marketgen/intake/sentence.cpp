#include "intake/sentence.h"

#include <cmath>
#include <optional>

namespace marketgen::intake {
namespace {

Phrase known_phrase(const Lexicon::Match& match, const std::vector<Token>& tokens, std::size_t at) {
  Phrase phrase;
  phrase.sense = match.row->sense;
  phrase.value = match.row->value;
  phrase.number = phrase.written = match.row->number;
  phrase.zone = match.row->zone;
  phrase.in_words = true;
  phrase.span = joined(tokens[at].span, tokens[at + match.tokens - 1].span);
  return phrase;
}

Phrase single_token(const Token& token) {
  Phrase phrase;
  phrase.sense = token.kind == TokenKind::number ? Sense::number
                 : token.kind == TokenKind::symbol
                     ? Sense::filler  // punctuation that joins nothing
                     : Sense::ordinary;
  phrase.value = token.text;
  phrase.number = phrase.written = token.number;
  phrase.span = token.span;
  return phrase;
}

// Slips of the pen mended, one word at a time.
std::vector<Token> with_corrections(std::vector<Token> tokens, const Lexicon& lexicon) {
  for (Token& token : tokens) {
    if (token.kind != TokenKind::word) continue;
    if (const auto better = lexicon.corrected(token.stem)) token.stem = *better;
  }
  return tokens;
}

// What number words in a row make: 2 and 100 "two hundred", 20 and 5 "twenty-five", 300 and 20
// "three hundred and twenty"; nothing when they are two numbers.
std::optional<double> composed(double so_far, double next) {
  if ((next == 100 && so_far < 100) || (next == 1000 && so_far < 1000)) return so_far * next;
  const auto ends_in = [&](double unit) { return so_far >= unit && std::fmod(so_far, unit) == 0; };
  const bool digit_after_tens = ends_in(10) && !ends_in(100) && so_far >= 20 && next < 10;
  if (digit_after_tens || (ends_in(100) && next < 100) || (ends_in(1000) && next < 1000))
    return so_far + next;
  return std::nullopt;
}

// "two hundred and fifty" becomes one number.
std::vector<Phrase> with_number_words(const std::vector<Phrase>& phrases) {
  std::vector<Phrase> merged;
  const auto is_word = [](const Phrase& phrase) {
    return phrase.sense == Sense::number && phrase.in_words;
  };
  const auto is_digits = [](const Phrase& phrase) {
    return phrase.sense == Sense::number && !phrase.in_words;
  };
  for (std::size_t i = 0; i < phrases.size(); ++i) {
    const bool and_between = i + 1 < phrases.size() && phrases[i].sense == Sense::separator &&
                             phrases[i].value == "and" && is_word(phrases[i + 1]);
    const std::size_t at = and_between ? i + 1 : i;
    const bool follows = !merged.empty() && is_word(phrases[at]) &&
                         (is_word(merged.back()) || (is_digits(merged.back()) && !and_between &&
                                                     phrases[at].number >= 100)) &&
                         (!and_between || merged.back().number >= 100);
    const auto sum = follows ? composed(merged.back().number, phrases[at].number) : std::nullopt;
    if (!sum) {
      merged.push_back(phrases[i]);
      continue;
    }
    merged.back().number = merged.back().written = *sum;
    merged.back().span = joined(merged.back().span, phrases[at].span);
    i = at;
  }
  return merged;
}

bool is_unit_of(const Phrase& number, const Phrase& unit) {
  return number.sense == Sense::number && unit.sense == Sense::unit && !number.measured;
}

// "24 m" becomes one phrase.
std::vector<Phrase> with_measures(const std::vector<Phrase>& phrases) {
  std::vector<Phrase> merged;
  for (const Phrase& phrase : phrases) {
    if (merged.empty() || !is_unit_of(merged.back(), phrase)) {
      merged.push_back(phrase);
      continue;
    }
    Phrase& number = merged.back();
    number.number *= phrase.number;
    number.value = phrase.value;
    number.measured = true;
    number.span = joined(number.span, phrase.span);
  }
  return merged;
}

// Only "ideally", "if possible" and their like change anything: what is said is meant otherwise.
// They hold for their clause, from one comma or "but" to the next.
void spread_strengths(std::vector<Phrase>& phrases) {
  for (std::size_t first = 0; first < phrases.size();) {
    std::size_t last = first;
    bool wish = false;
    for (; last < phrases.size(); ++last) {
      const Phrase& phrase = phrases[last];
      if (phrase.sense == Sense::separator && phrase.value != "and" && last > first) break;
      wish = wish || (phrase.sense == Sense::strength && phrase.value == "prefer");
    }
    for (; first < last; ++first) {
      phrases[first].strength = wish ? plan::Strength::prefer : plan::Strength::must;
      if (phrases[first].sense == Sense::strength) phrases[first].used = true;
    }
  }
}

}  // namespace

const Phrase& Sentence::at(std::size_t i) const {
  static const Phrase nothing = [] {
    Phrase filler;
    filler.sense = Sense::filler;
    return filler;
  }();
  return i < phrases.size() ? phrases[i] : nothing;
}

std::size_t Sentence::skip_fillers(std::size_t i) const {
  while (i < phrases.size() && phrases[i].sense == Sense::filler)
    ++i;
  return i;
}

std::size_t Sentence::before(std::size_t i) const {
  while (i > 0) {
    --i;
    if (phrases[i].sense != Sense::filler) return i;
  }
  return phrases.size();
}

void Sentence::use(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i <= last && i < phrases.size(); ++i)
    phrases[i].used = true;
}

std::vector<Sentence> make_sentences(const std::vector<Token>& raw, const Lexicon& lexicon) {
  const std::vector<Token> tokens = with_corrections(raw, lexicon);
  std::vector<Sentence> sentences(1);
  for (std::size_t at = 0; at < tokens.size();) {
    if (tokens[at].kind == TokenKind::sentence_end) {
      if (!sentences.back().phrases.empty()) sentences.emplace_back();
      ++at;
      continue;
    }
    const auto match = lexicon.longest_match(tokens, at);
    sentences.back().phrases.push_back(match ? known_phrase(*match, tokens, at)
                                             : single_token(tokens[at]));
    at += match ? match->tokens : 1;
  }
  sentences.front().first = true;
  for (Sentence& sentence : sentences) {
    sentence.phrases = with_measures(with_number_words(sentence.phrases));
    spread_strengths(sentence.phrases);
  }
  return sentences;
}

}  // namespace marketgen::intake
