#include <utf8proc.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "intake/conflicts.h"
#include "intake/reading.h"
#include "intake/store_name.h"
#include "intake/tokens.h"
#include "intake/understanding.h"

namespace marketgen::intake {
namespace {

// Words that need no rule: grammar, and what only repeats that a shop is meant.
bool says_nothing(const Phrase& phrase) {
  switch (phrase.sense) {
    case Sense::filler:
    case Sense::separator:
    case Sense::strength:
    case Sense::shop:
    case Sense::suffix:
      return true;
    case Sense::relation:
      return phrase.value == "at" || phrase.value == "in";
    case Sense::times:
      return phrase.value == "by";
    default:
      return false;
  }
}

// An emoji, not punctuation.
bool is_picture(const Token& token) {
  utf8proc_int32_t code = 0;
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(token.text.data());
  utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(token.text.size()), &code);
  return token.kind == TokenKind::symbol && utf8proc_category(code) == UTF8PROC_CATEGORY_SO;
}

// A word said something when a reader used it; "please" and "must" alone do not.
bool anything_understood(const std::vector<Sentence>& sentences, const Understanding& found) {
  const auto says = [](const Phrase& phrase) {
    return phrase.used && phrase.sense != Sense::strength;
  };
  return found.name || std::ranges::any_of(sentences, [&](const Sentence& sentence) {
           return std::ranges::any_of(sentence.phrases, says);
         });
}

void collect_unparsed(const std::vector<Token>& tokens,
                      const std::vector<Sentence>& sentences,
                      Reading& reading) {
  auto token = tokens.begin();
  for (const Sentence& sentence : sentences) {
    for (const Phrase& phrase : sentence.phrases) {
      for (; token != tokens.end() && token->span[1] <= phrase.span[1]; ++token) {
        const bool word = token->kind == TokenKind::word || token->kind == TokenKind::number;
        const bool passed_over = phrase.used || (word && says_nothing(phrase));
        if (passed_over || !(word || is_picture(*token))) continue;
        reading.found.unparsed.push_back({reading.words(token->span), token->span});
      }
    }
  }
}

// The compass directions of front, back, left and right for someone who comes in through `entrance`
// and looks ahead.
struct Compass {
  std::array<std::string_view, 4> front_back_left_right;
};
constexpr std::array<Compass, 4> compasses = {{
    {{"north", "south", "east", "west"}},  // entrance in the north wall
    {{"south", "north", "west", "east"}},
    {{"east", "west", "south", "north"}},
    {{"west", "east", "north", "south"}},
}};

std::string absolute(const std::string& place, const Compass& compass) {
  constexpr std::array<std::string_view, 4> relative = {"front", "back", "left", "right"};
  for (std::size_t i = 0; i < relative.size(); ++i) {
    if (place == relative[i]) return std::string(compass.front_back_left_right[i]);
  }
  return place;
}

plan::Wall entrance_wall(const Understanding& found) {
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != plan::RequirementKind::opening || wish.subject != "entrance") continue;
    if (const auto wall = value_named<plan::Wall>(wish.object)) return *wall;
  }
  return plan::Wall::south;
}

// "front", "back", "left" and "right" become walls.
void resolve_directions(Understanding& found) {
  const Compass& compass = compasses[static_cast<std::size_t>(entrance_wall(found))];
  for (plan::Requirement& wish : found.requirements) {
    const bool placed =
        wish.kind == plan::RequirementKind::relation || wish.kind == plan::RequirementKind::opening;
    if (!placed) continue;
    wish.object = absolute(wish.object, compass);
    wish.second_object = absolute(wish.second_object, compass);
  }
}

}  // namespace

const plan::Requirement* Understanding::find(plan::RequirementKind kind) const {
  const auto found = std::ranges::find(requirements, kind, &plan::Requirement::kind);
  return found == requirements.end() ? nullptr : &*found;
}

const plan::Requirement* Understanding::find(plan::RequirementKind kind,
                                             std::string_view subject) const {
  const auto found = std::ranges::find_if(requirements, [&](const plan::Requirement& wish) {
    return wish.kind == kind && wish.subject == subject;
  });
  return found == requirements.end() ? nullptr : &*found;
}

Understanding understand(std::string_view prompt,
                         const Lexicon& lexicon,
                         const catalog::Catalog& catalog) {
  using Reader = void (*)(Sentence&, Reading&);
  constexpr std::array<Reader, 6> readers = {
      read_measures, read_counts, read_look, read_stock, read_places, read_character};
  Understanding found;
  Reading reading{prompt, catalog, found};
  std::vector<Token> tokens = tokenize(prompt);
  found.name = take_store_name(prompt, tokens, lexicon);
  std::vector<Sentence> sentences = make_sentences(tokens, lexicon);
  for (Sentence& sentence : sentences) {
    for (const Reader reader : readers)
      reader(sentence, reading);
  }
  found.understood = anything_understood(sentences, found);
  collect_unparsed(tokens, sentences, reading);
  resolve_directions(found);
  settle_conflicts(found);
  return found;
}

}  // namespace marketgen::intake
