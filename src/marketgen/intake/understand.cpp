#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "intake/conflicts.h"
#include "intake/interpret.h"
#include "intake/language.h"
#include "intake/prompt_tables.h"
#include "intake/store_name.h"
#include "intake/tokens.h"
#include "intake/understanding.h"

namespace marketgen::intake {
namespace {

using Tokens = std::vector<Token>;

// Words that need no rule: grammar, and what only repeats that a shop is meant.
bool says_nothing(const Segment& segment) {
  switch (segment.sense) {
    case Sense::filler:
    case Sense::separator:
    case Sense::strength:
    case Sense::shop:
    case Sense::suffix:
      return true;
    case Sense::word:
      return !segment.content;
    case Sense::relation:
      return segment.value == "at" || segment.value == "in";
    case Sense::times:
      return segment.value == "by";
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

// A sentence that never ends is cut at a comma, or in the end anywhere: reading takes more than
// twice the time for twice the words.
bool is_cut(const Tokens& sentence, const Token& next) {
  constexpr std::size_t long_sentence = 80, max_sentence = 200;  // tokens
  return (sentence.size() >= long_sentence && next.text == ",") || sentence.size() >= max_sentence;
}

// Slips of the pen mended, one word at a time; cut into sentences.
std::vector<Tokens> sentences_of(const Tokens& tokens, const Language& language) {
  std::vector<Tokens> sentences(1);
  for (Token token : tokens) {
    const bool ends = token.kind == TokenKind::sentence_end;
    if ((ends || is_cut(sentences.back(), token)) && !sentences.back().empty())
      sentences.emplace_back();
    if (ends) continue;
    const bool mend =
        token.kind == TokenKind::word && !language.english.rules->has_word(token.stem);
    if (const auto better = mend ? language.lexicon.corrected(token.stem) : std::nullopt)
      token.stem = *better;
    sentences.back().push_back(std::move(token));
  }
  return sentences;
}

// By token. Only "ideally", "if possible" and their like change anything: what is said is meant
// otherwise. They hold for their clause, from one comma or "but" to the next.
std::vector<plan::Strength> strengths_of(const std::vector<Segment>& segments) {
  std::vector<plan::Strength> strengths;
  for (std::size_t first = 0; first < segments.size();) {
    std::size_t last = first;
    bool wish = false;
    for (; last < segments.size(); ++last) {
      const Segment& segment = segments[last];
      if (segment.sense == Sense::separator && segment.value != "and" && last > first) break;
      wish = wish || (segment.sense == Sense::strength && segment.value == "prefer");
    }
    for (; first < last; ++first)
      strengths.resize(segments[first].last, wish ? plan::Strength::prefer : plan::Strength::must);
  }
  return strengths;
}

class SentenceReader {
 public:
  SentenceReader(const Tokens& tokens, const Language& language, Reading reading)
      : tokens_(tokens),
        language_(language),
        segments_(segments_of(tokens, language.lexicon)),
        reading_(std::move(reading)) {
    reading_.segments = &segments_;
  }

  // Whether a word said something.
  bool run() {
    const language::Input input = lexical_input(tokens_, segments_, language_.lexicon);
    const SentenceGrammar& grammar = language_.grammar_of(tokens_);
    const language::Chart chart(*grammar.rules, input);
    const std::vector<plan::Strength> strengths = strengths_of(segments_);
    std::vector<bool> used(tokens_.size(), false);
    bool understood = false;
    for (const auto& statement : best_cover(chart, grammar.statement, input)) {
      reading_.strength = strengths[static_cast<std::size_t>(statement->begin)];
      const std::size_t first_wish = reading_.found.requirements.size();
      if (!interpret(reading_, *statement->meaning)) {
        reading_.senseless.clear();
        continue;
      }
      remember_statement(statement->meaning, first_wish);
      understood = true;
      for (const int word : statement->meaning->words)
        used[static_cast<std::size_t>(word)] = true;
      for (const int word : std::exchange(reading_.senseless, {}))
        used[static_cast<std::size_t>(word)] = false;
    }
    collect_unparsed(used);
    return understood;
  }

 private:
  // For a correction: what it says is the same as what was corrected, said otherwise.
  void remember_statement(const language::MeaningPtr& statement, std::size_t first_wish) {
    Memory& memory = *reading_.memory;
    memory.past_wish = reading_.found.requirements.size();
    if (statement->is("kind", "correction")) return;
    memory.last = statement;
    memory.first_wish = first_wish;
  }

  void collect_unparsed(const std::vector<bool>& used) {
    for (const Segment& segment : segments_) {
      for (std::size_t at = segment.first; at < segment.last; ++at) {
        const Token& token = tokens_[at];
        const bool word = token.kind == TokenKind::word || token.kind == TokenKind::number;
        const bool passed_over = used[at] || (word && says_nothing(segment));
        if (passed_over || !(word || is_picture(token))) continue;
        add_unparsed(token, at > 0 && token.han && tokens_[at - 1].han);
      }
    }
  }

  // Chinese characters that follow one another are one stretch.
  void add_unparsed(const Token& token, bool goes_on) {
    std::vector<UnparsedWord>& unparsed = reading_.found.unparsed;
    if (!goes_on || unparsed.empty() || unparsed.back().span[1] != token.span[0])
      return unparsed.push_back({reading_.words(token.span), token.span});
    unparsed.back().span[1] = token.span[1];
    unparsed.back().text = reading_.words(unparsed.back().span);
  }

  const Tokens& tokens_;
  const Language& language_;
  std::vector<Segment> segments_;
  Reading reading_;
};

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

// For someone inside who faces the wall: its left end is on the left hand.
const Compass& facing(plan::Wall wall) {
  switch (wall) {
    case plan::Wall::north:
      return compasses[static_cast<std::size_t>(plan::Wall::south)];
    case plan::Wall::south:
      return compasses[static_cast<std::size_t>(plan::Wall::north)];
    case plan::Wall::east:
      return compasses[static_cast<std::size_t>(plan::Wall::west)];
    case plan::Wall::west:
      break;
  }
  return compasses[static_cast<std::size_t>(plan::Wall::east)];
}

std::string absolute(const std::string& place, const Compass& compass) {
  constexpr std::array<std::string_view, 4> relative = {"front", "back", "left", "right"};
  for (std::size_t i = 0; i < relative.size(); ++i) {
    if (place == relative[i]) return std::string(compass.front_back_left_right[i]);
  }
  return place;
}

plan::Wall entrance_wall(const Understanding& found, plan::Wall otherwise) {
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != plan::RequirementKind::opening || wish.subject != "entrance") continue;
    if (const auto wall = value_named<plan::Wall>(wish.object)) return *wall;
  }
  return otherwise;
}

// A ratio to a floor that was said in numbers is a number; one to a floor that nobody knows is not
// understood.
void settle_ratios(Understanding& found) {
  for (const ZoneRatio& ratio : std::exchange(found.ratios, {})) {
    const plan::Requirement* model = found.find(plan::RequirementKind::area, ratio.of);
    if (model == nullptr) {
      found.unparsed.push_back({ratio.text, ratio.span});
      continue;
    }
    plan::Requirement area;
    area.kind = plan::RequirementKind::area;
    area.subject = ratio.zone;
    area.value = ratio.factor * model->value;
    area.comparison = model->comparison;
    area.strength = ratio.strength;
    area.text = ratio.text;
    area.span = ratio.span;
    found.requirements.push_back(std::move(area));
  }
}

// "The entrance is in the south wall, at its left end": an end without a wall is one of the wall
// that was said of that door.
void find_walls_of_ends(Understanding& found) {
  const auto is_door = [](const plan::Requirement& wish) {
    return wish.kind == plan::RequirementKind::opening;
  };
  std::vector<plan::Requirement>& wishes = found.requirements;
  for (plan::Requirement& wish : wishes) {
    if (!is_door(wish) || !wish.object.empty() || wish.second_object.empty()) continue;
    const auto of_wall = std::ranges::find_if(wishes, [&](const plan::Requirement& other) {
      return is_door(other) && other.subject == wish.subject && !other.object.empty();
    });
    if (of_wall != wishes.end()) wish.object = of_wall->object;
  }
}

// "front", "back", "left" and "right" become walls.
void resolve_directions(Understanding& found, plan::Wall entrance) {
  find_walls_of_ends(found);
  const Compass& compass = compasses[static_cast<std::size_t>(entrance_wall(found, entrance))];
  for (plan::Requirement& wish : found.requirements) {
    const bool placed =
        wish.kind == plan::RequirementKind::relation || wish.kind == plan::RequirementKind::opening;
    if (!placed) continue;
    wish.object = absolute(wish.object, compass);
    const auto wall = value_named<plan::Wall>(wish.object);
    const bool end_of_wall = wish.kind == plan::RequirementKind::opening && wall.has_value();
    wish.second_object = absolute(wish.second_object, end_of_wall ? facing(*wall) : compass);
  }
}

// Where nobody sits at a till, what is said of tills is said of the machines: "tills by the door,
// only self-checkouts".
void tills_are_machines(Understanding& found) {
  using Kind = plan::RequirementKind;
  const bool machines = found.find(Kind::fixture_count, "self_checkout") != nullptr ||
                        found.find(Kind::zone_present, "self_checkout") != nullptr;
  const bool lanes = found.find(Kind::fixture_count, "checkout_lane") != nullptr;
  if (!machines || lanes || found.find(Kind::zone_absent, "checkout") == nullptr) return;
  std::erase_if(found.requirements, [](const plan::Requirement& wish) {
    return wish.kind == Kind::zone_present && wish.subject == "checkout";
  });
  for (plan::Requirement& wish : found.requirements) {
    if (wish.kind != Kind::relation) continue;
    for (std::string* name : {&wish.subject, &wish.object, &wish.second_object})
      if (*name == "checkout") *name = "self_checkout";
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
                         const Language& language,
                         const catalog::Catalog& catalog,
                         plan::Wall entrance) {
  Understanding found;
  Tokens tokens = with_tables_spelled_out(prompt, tokenize(prompt), language.lexicon);
  found.names = take_store_names(prompt, tokens, language.lexicon);
  found.understood = !found.names.empty();
  bool first = true;
  Memory memory;
  for (const Tokens& sentence : sentences_of(tokens, language)) {
    Reading reading{prompt, catalog, found};
    reading.memory = &memory;
    reading.first_sentence = std::exchange(first, false);
    if (SentenceReader(sentence, language, std::move(reading)).run()) found.understood = true;
  }
  settle_ratios(found);
  resolve_directions(found, entrance);
  tills_are_machines(found);
  settle_conflicts(found, prompt, entrance);
  return found;
}

}  // namespace marketgen::intake
