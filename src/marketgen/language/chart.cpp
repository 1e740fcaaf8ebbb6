#include "language/chart.h"

#include <algorithm>
#include <utility>

namespace marketgen::language {
namespace {

constexpr double literal_cost = 1;  // as of a word of the lexicon

IntRange span_of(const std::vector<int>& words, const Input& input) {
  const auto token = [&](int word) { return input.tokens[static_cast<std::size_t>(word)].span; };
  return {token(words.front())[0], token(words.back())[1]};
}

ConstituentPtr word_of(
    const Input& input, Category category, int begin, int end, Meaning meaning, double cost) {
  for (int word = begin; word < end; ++word)
    meaning.words.push_back(word);
  meaning.span = span_of(meaning.words, input);
  return std::make_shared<Constituent>(
      Constituent{category, begin, end, cost, std::make_shared<Meaning>(std::move(meaning)), -1});
}

// By position: where what came before may end for something to begin there, with the cost of what
// is passed over.
std::vector<std::vector<std::pair<int, double>>> gaps_of(const Input& input, double max_cost) {
  const auto count = static_cast<int>(input.tokens.size());
  std::vector<std::vector<std::pair<int, double>>> gaps(input.tokens.size() + 1);
  for (int at = 0; at <= count; ++at) {
    double cost = 0;
    gaps[static_cast<std::size_t>(at)].emplace_back(at, 0);
    for (int before = at; before > 0; --before) {
      const double skip = input.tokens[static_cast<std::size_t>(before) - 1].skip_cost;
      cost += skip;
      if (skip < 0 || cost > max_cost) break;
      gaps[static_cast<std::size_t>(at)].emplace_back(before - 1, cost);
    }
  }
  return gaps;
}

}  // namespace

Chart::Chart(const Grammar& grammar, const Input& input, ChartLimits limits)
    : grammar_(grammar),
      input_(input),
      limits_(limits),
      ending_(input.tokens.size() + 1),
      begun_(input.tokens.size() + 1),
      gaps_(gaps_of(input, limits.max_gap_cost)) {
  std::vector<std::vector<ConstituentPtr>> words(input.tokens.size() + 1);
  for (const LexicalEntry& entry : input.entries) {
    if (const auto category = grammar.category(entry.category))
      words[static_cast<std::size_t>(entry.end)].push_back(
          word_of(input, *category, entry.begin, entry.end, entry.meaning, entry.cost));
  }
  for (std::size_t end = 1; end <= input.tokens.size(); ++end) {
    const int begin = static_cast<int>(end) - 1;
    if (const auto category = grammar.category("'" + input.tokens[end - 1].stem + "'"))
      words[end].push_back(
          word_of(input, *category, begin, static_cast<int>(end), {}, literal_cost));
    agenda_ = std::move(words[end]);
    read();
  }
}

// The cheapest first: whatever is made of it costs no less.
void Chart::read() {
  while (!agenda_.empty() && !full()) {
    const auto cheapest =
        std::ranges::min_element(agenda_, {}, [](const ConstituentPtr& one) { return one->cost; });
    const ConstituentPtr next = std::move(*cheapest);
    agenda_.erase(cheapest);
    add(next);
  }
  agenda_.clear();
}

// Begins rules with it, and goes on with those that wait for it.
void Chart::add(const ConstituentPtr& made) {
  std::vector<ConstituentPtr>& here = ending_[static_cast<std::size_t>(made->end)];
  int readings = 0;
  for (const ConstituentPtr& other : here) {
    if (other->category != made->category || other->begin != made->begin) continue;
    if (++readings >= limits_.max_readings || same_meaning(*other->meaning, *made->meaning)) return;
  }
  ++edges_;
  here.push_back(made);
  for (const int rule : grammar_.beginning_with(made->category))
    extend({rule, 0, made->begin, made->begin, 0, {}}, made, 0);
  for (const auto& [end, cost] : gaps_[static_cast<std::size_t>(made->begin)]) {
    const auto waiting = begun_[static_cast<std::size_t>(end)].find(made->category);
    if (waiting == begun_[static_cast<std::size_t>(end)].end()) continue;
    for (const Begun& begun : waiting->second)
      extend(begun, made, cost);
  }
}

void Chart::extend(const Begun& begun, const ConstituentPtr& next, double gap_cost) {
  const Rule& rule = grammar_.rules()[static_cast<std::size_t>(begun.rule)];
  const Item& item = rule.items[static_cast<std::size_t>(begun.found)];
  if (!item.takes(*next->meaning)) return;
  Begun longer = begun;
  ++longer.found;
  ++edges_;
  longer.end = next->end;
  longer.cost += next->cost + gap_cost;
  longer.items.resize(static_cast<std::size_t>(item.number));
  longer.items.back() = next->meaning;
  if (longer.found == static_cast<int>(rule.items.size())) return finish(longer);
  const Category awaited = rule.items[static_cast<std::size_t>(longer.found)].category;
  begun_[static_cast<std::size_t>(longer.end)][awaited].push_back(std::move(longer));
}

void Chart::finish(const Begun& begun) {
  const Rule& rule = grammar_.rules()[static_cast<std::size_t>(begun.rule)];
  std::vector<MeaningPtr> items = begun.items;
  items.resize(static_cast<std::size_t>(rule.written_items));
  Meaning whole = composed(rule, items);
  for (const MeaningPtr& item : items) {
    if (item) whole.words.insert(whole.words.end(), item->words.begin(), item->words.end());
  }
  whole.span = span_of(whole.words, input_);
  agenda_.push_back(
      std::make_shared<Constituent>(Constituent{rule.made,
                                                begun.begin,
                                                begun.end,
                                                begun.cost + rule.cost,
                                                std::make_shared<Meaning>(std::move(whole)),
                                                begun.rule}));
}

std::vector<ConstituentPtr> Chart::of(Category category) const {
  std::vector<ConstituentPtr> found;
  for (const std::vector<ConstituentPtr>& here : ending_) {
    for (const ConstituentPtr& one : here)
      if (one->category == category) found.push_back(one);
  }
  return found;
}

bool Chart::used(int rule) const {
  return std::ranges::any_of(ending_, [&](const std::vector<ConstituentPtr>& here) {
    return std::ranges::any_of(here, [&](const ConstituentPtr& one) { return one->rule == rule; });
  });
}

std::vector<ConstituentPtr> best_cover(const Chart& chart,
                                       Category category,
                                       const Input& input,
                                       CoverRules rules) {
  struct Best {
    double gain = 0;
    ConstituentPtr last;  // null: the token before is not covered
  };
  std::vector<Best> best(input.tokens.size() + 1);
  std::vector<std::vector<ConstituentPtr>> by_end(input.tokens.size() + 1);
  for (const ConstituentPtr& one : chart.of(category))
    by_end[static_cast<std::size_t>(one->end)].push_back(one);
  for (std::size_t end = 1; end <= input.tokens.size(); ++end) {
    best[end] = {best[end - 1].gain, nullptr};
    for (const ConstituentPtr& one : by_end[end]) {
      double gain =
          best[static_cast<std::size_t>(one->begin)].gain - rules.of_constituent - one->cost;
      for (const int word : one->meaning->words)
        gain +=
            input.tokens[static_cast<std::size_t>(word)].counts ? rules.of_word : rules.of_filler;
      if (gain > best[end].gain) best[end] = {gain, one};
    }
  }
  std::vector<ConstituentPtr> cover;
  for (std::size_t end = input.tokens.size(); end > 0;) {
    const ConstituentPtr& last = best[end].last;
    if (last) cover.push_back(last);
    end = last ? static_cast<std::size_t>(last->begin) : end - 1;
  }
  std::ranges::reverse(cover);
  return cover;
}

}  // namespace marketgen::language
