#include "shopping/request.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "base/words.h"
#include "perception/said_amounts.h"
#include "shopping/request_words.h"

namespace marketgen::shopping {
namespace {

constexpr std::size_t max_request_bytes = 2000;
using WordRow = std::vector<RequestWord>;

bool any_word(const std::vector<std::string>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

// " bake cake ": what is said, fillers left out.
std::string said_of(const WordRow& words,
                    std::size_t from,
                    std::size_t to,
                    const ShoppingKnowledge& knowledge) {
  std::string said;
  for (std::size_t i = from; i < to; ++i)
    if (!words[i].used && !knowledge.is_filler(words[i].plain)) said += words[i].plain + " ";
  return spaced_words(said);
}

std::string said_of(const std::string& name, const ShoppingKnowledge& knowledge) {
  const WordRow words = words_of(name);
  return said_of(words, 0, words.size(), knowledge);
}

// Reads one request; the chunks of its words one after the other.
class Reading {
 public:
  Reading(std::string_view words, const ShoppingKnowledge& knowledge)
      : knowledge_(knowledge), words_(words_of(words)) {
    request_.words = words;
  }

  Result<ShoppingRequest> read() {
    MARKETGEN_TRY(request_.budget, take_budget(words_));
    for (std::size_t from = 0; from < words_.size();) {
      std::size_t to = from + 1;
      while (to < words_.size() && (words_[to].before == Break::none || is_joined_meal(from, to)))
        ++to;
      if (from == 0 || words_[from].before == Break::sentence) {
        home_ = is_about_home(from);
        excluding_ = false;
      }
      MARKETGEN_CHECK(read_chunk(from, to));
      from = to;
    }
    return finished();
  }

 private:
  // "coffee and cake": whether the words up to the next break are a meal together.
  bool is_joined_meal(std::size_t from, std::size_t at) const {
    if (words_[at].before != Break::joined) return false;
    std::size_t to = at + 1;
    while (to < words_.size() && words_[to].before == Break::none)
      ++to;
    WordRow words = words_;
    if (!take_persons(words, from, to).ok()) return false;
    return meal_of(said_of(words, from, to, knowledge_), false) != nullptr;
  }

  Result<void> read_chunk(std::size_t from, std::size_t to) {
    MARKETGEN_TRY(const auto persons, take_persons(words_, from, to));
    note_home(from, to);
    if (said_of(words_, from, to, knowledge_).empty()) return add_persons(persons, from, to);
    // "breakfast with eggs", "dinner without mushrooms": a meal, and what goes with it.
    for (std::size_t at = from + 1; at < to; ++at) {
      if (words_[at].plain != "with" && words_[at].plain != "including") continue;
      if (!is_meal(from, at, persons.has_value())) continue;
      MARKETGEN_CHECK(read_part(from, at, persons));
      return read_chunk(at + 1, to);
    }
    return read_part(from, to, persons);
  }

  // "There are bread and butter at home."
  bool is_about_home(std::size_t from) {
    for (std::size_t i = from + 1; i < words_.size(); ++i) {
      if (words_[i].before == Break::sentence) return false;
      if (words_[i].plain == "home" && words_[i - 1].plain == "at") return true;
    }
    return false;
  }

  // "I have b": at home from there to the end of the sentence, or to what is needed.
  void note_home(std::size_t from, std::size_t to) {
    constexpr std::array<std::string_view, 3> having{"have", "got", "i've"};
    constexpr std::array<std::string_view, 5> needing{"need", "want", "buy", "missing", "get"};
    for (std::size_t i = from; i < to; ++i) {
      if (std::ranges::find(needing, words_[i].plain) != needing.end()) home_ = false;
      if (std::ranges::find(having, words_[i].plain) != having.end()) {
        home_ = true;
        words_[i].used = true;
      }
    }
  }

  // Persons that a chunk adds to those of the meal before: "and three kids".
  Result<void> add_persons(std::optional<int> persons, std::size_t from, std::size_t to) {
    if (!persons) return {};
    if (request_.meals.empty()) {
      waiting_persons_ = waiting_persons_.value_or(0) + *persons;
      return {};
    }
    MealWish& meal = request_.meals.back();
    if (meal.persons_said && meal.persons + *persons > 200)
      return not_understood(words_, from, to, "say at most 200 persons");
    meal.persons = *persons + (meal.persons_said ? meal.persons : 0);
    meal.persons_said = true;
    return {};
  }

  const Meal* meal_of(std::string_view said, bool with_persons) const {
    const auto is_it = [&](const std::string& name) { return said_of(name, knowledge_) == said; };
    for (const Meal& meal : knowledge_.table().meals) {
      if (std::ranges::any_of(meal.say, is_it)) return &meal;
      if (with_persons && std::ranges::any_of(meal.say_for, is_it)) return &meal;
    }
    return nullptr;
  }

  // Takes the diets out of what was said, and names them.
  std::vector<std::string> diets_in(std::string& said) const {
    std::vector<std::string> diets;
    for (const Diet& diet : knowledge_.table().diets) {
      std::vector<std::string> names = diet.say;
      std::ranges::stable_sort(names, std::greater<>{}, &std::string::size);
      for (const std::string& name : names) {
        const std::string sought = said_of(name, knowledge_);
        const std::size_t at = said.find(sought);
        if (at == std::string::npos) continue;
        said.replace(at, sought.size(), " ");
        diets.push_back(diet.id);
        break;
      }
    }
    if (said == " ") said.clear();
    return diets;
  }

  bool is_meal(std::size_t from, std::size_t to, bool with_persons) const {
    std::string said = said_of(words_, from, to, knowledge_);
    if (meal_of(said, with_persons) != nullptr) return true;
    diets_in(said);
    return meal_of(said, with_persons) != nullptr;
  }

  Result<void> read_part(std::size_t from, std::size_t to, std::optional<int> persons) {
    std::string said = said_of(words_, from, to, knowledge_);
    if (const Meal* meal = meal_of(said, persons.has_value())) return add_meal(*meal, persons);
    const std::vector<std::string> diets = diets_in(said);
    const Meal* meal = said.empty() ? nullptr : meal_of(said, persons.has_value());
    if (!diets.empty() && (said.empty() || meal != nullptr)) {
      for (const std::string& diet : diets)
        if (!any_word(request_.diets, diet)) request_.diets.push_back(diet);
      return meal != nullptr ? add_meal(*meal, persons) : add_persons(persons, from, to);
    }
    constexpr std::array<std::string_view, 5> excluding{
        "without", "no", "except", "excluding", "avoid"};
    for (std::size_t at = from; at < to; ++at) {
      if (std::ranges::find(excluding, words_[at].plain) == excluding.end()) continue;
      if (at > from && !said_of(words_, from, at, knowledge_).empty() &&
          !is_meal(from, at, persons.has_value()))
        break;  // "cola without sugar"
      if (at > from) MARKETGEN_CHECK(read_chunk_before(from, at, persons));
      excluding_ = true;
      return exclude(at + 1, to);
    }
    const bool goes_on = words_[from].before == Break::joined && words_[from].plain != "a" &&
                         !perception::said_number(words_[from].plain);
    excluding_ = excluding_ && goes_on;
    if (excluding_) return exclude(from, to);
    if (persons && !request_.meals.empty() && !request_.meals.back().persons_said) {
      MARKETGEN_CHECK(add_persons(persons, from, to));  // "breakfast with eggs for two"
    } else if (persons) {
      return not_understood(words_,
                            from,
                            to,
                            "persons belong to a meal, as in \"breakfast for two\"; of an item say "
                            "how many packs, as in \"two cartons of milk\"");
    }
    return add_item(from, to);
  }

  Result<void> read_chunk_before(std::size_t from, std::size_t to, std::optional<int> persons) {
    if (said_of(words_, from, to, knowledge_).empty()) return add_persons(persons, from, to);
    return read_part(from, to, persons);
  }

  Result<void> add_meal(const Meal& meal, std::optional<int> persons) {
    home_ = false;  // "to have breakfast"
    if (!persons) persons = std::exchange(waiting_persons_, std::nullopt);
    if (std::ranges::find(request_.meals, meal.id, &MealWish::meal) == request_.meals.end())
      request_.meals.push_back(
          {meal.id, persons.value_or(meal.usual_persons), persons.has_value()});
    return {};
  }

  // "no mushrooms": a diet of the table, or words that rows may not say.
  Result<void> exclude(std::size_t from, std::size_t to) {
    std::string said = said_of(words_, from, to, knowledge_);
    if (said.empty()) return {};
    for (const Diet& diet : knowledge_.table().diets) {
      const bool named = std::ranges::any_of(diet.say, [&](const std::string& name) {
        const std::string words = said_of(name, knowledge_);
        return words == " no" + said || words == said;
      });
      if (!named) continue;
      if (!any_word(request_.diets, diet.id)) request_.diets.push_back(diet.id);
      return {};
    }
    MARKETGEN_CHECK(check_words(from, to));
    said = said.substr(1, said.size() - 2);
    if (!any_word(request_.without, said)) request_.without.push_back(said);
    return {};
  }

  // Every word that says something must be one that the catalogue has.
  Result<void> check_words(std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i) {
      if (words_[i].used) continue;
      const std::vector<std::string> plain = perception::plain_words(words_[i].text);
      for (const std::string& word : plain) {
        if (knowledge_.is_filler(word) || knowledge_.is_container(word) ||
            knowledge_.reader().knows(word) || perception::said_number(word) ||
            catalog::net_measure(word) || word == "half" || word == "x" || word == "time")
          continue;
        return not_understood(
            words_,
            i,
            i + 1,
            fmt::format("no product has this word{}, and it names no meal, diet or sum; say it "
                        "otherwise or leave it out (meals: {})",
                        suggestion(word),
                        meals_known()));
      }
    }
    return {};
  }

  std::string suggestion(const std::string& word) const {
    std::vector<std::string_view> known;
    for (const Meal& meal : knowledge_.table().meals)
      for (const std::string& name : meal.say)
        known.push_back(name);
    for (const Diet& diet : knowledge_.table().diets)
      for (const std::string& name : diet.say)
        known.push_back(name);
    for (const catalog::Product& product : knowledge_.catalog().products)
      known.push_back(product.name);
    return did_you_mean(word, known);
  }

  std::string meals_known() const {
    std::string names;
    for (const Meal& meal : knowledge_.table().meals)
      names += (names.empty() ? "" : ", ") + meal.say.front();
    return names;
  }

  bool says_nothing(const RequestWord& word) const {
    return knowledge_.is_filler(word.plain) && !knowledge_.is_container(word.plain);
  }

  Result<void> add_item(std::size_t from, std::size_t to) {
    while (from < to && !perception::said_number(words_[from].plain) &&
           (words_[from].used || says_nothing(words_[from])) &&
           !(words_[from].plain == "a" && from + 1 < to &&
             catalog::net_measure(words_[from + 1].plain)))
      ++from;
    while (from < to && (words_[to - 1].used || says_nothing(words_[to - 1])))
      --to;
    MARKETGEN_CHECK(check_words(from, to));
    const std::string text = text_of(words_, from, to);
    if (const auto read = knowledge_.reader().read(text); !read.ok())
      return not_understood(words_, from, to, "it names no product; say what it is called");
    std::vector<std::string>& list = home_ ? request_.at_home : request_.items;
    if (!any_word(list, text)) list.push_back(text);
    return {};
  }

  Result<ShoppingRequest> finished() {
    if (waiting_persons_ && request_.meals.empty())
      return Error{
          "shopping.not_understood",
          "request",
          fmt::format("it says for how many, but not what; say a meal: {}", meals_known())};
    if (waiting_persons_)
      for (MealWish& meal : request_.meals)
        if (!meal.persons_said) meal = {meal.meal, *waiting_persons_, true};
    share_persons();
    if (request_.meals.empty() && request_.items.empty())
      return Error{"shopping.not_understood",
                   "request",
                   fmt::format("nothing in it is to be bought; say a meal ({}) or items, as in "
                               "\"two cartons of milk, bread\"",
                               meals_known())};
    return std::move(request_);
  }

  // "breakfast and dinner for two": where one meal's persons are told, they are those of the
  // others.
  void share_persons() {
    const auto told = std::ranges::find(request_.meals, true, &MealWish::persons_said);
    if (told == request_.meals.end()) return;
    const int persons = told->persons;
    for (MealWish& meal : request_.meals)
      if (!meal.persons_said) meal = {meal.meal, persons, true};
  }

  const ShoppingKnowledge& knowledge_;
  WordRow words_;
  ShoppingRequest request_;
  bool home_ = false, excluding_ = false;
  std::optional<int> waiting_persons_;  // told before any meal
};

}  // namespace

ShoppingKnowledge::ShoppingKnowledge(const catalog::Catalog& catalog, MealTable table)
    : catalog_(&catalog),
      table_(std::move(table)),
      reader_(catalog.products, catalog.search_lexicon) {}

Result<ShoppingKnowledge> ShoppingKnowledge::load(const catalog::Catalog& catalog,
                                                  const std::filesystem::path& data) {
  MARKETGEN_TRY(MealTable table, load_meals(data));
  return ShoppingKnowledge(catalog, std::move(table));
}

bool ShoppingKnowledge::is_filler(std::string_view word) const {
  return any_word(table_.filler, word) || any_word(catalog_->search_lexicon.skip, word);
}

bool ShoppingKnowledge::is_container(std::string_view word) const {
  return any_word(table_.containers, word);
}

Result<ShoppingRequest> read_request(std::string_view words, const ShoppingKnowledge& knowledge) {
  if (!is_utf8(words))
    return Error{"input.not_utf8", "request", "the request is not valid UTF-8; save it as UTF-8"};
  if (words.size() > max_request_bytes)
    return Error{"shopping.not_understood",
                 "request",
                 fmt::format("it has {} bytes; at most {} are read: say it in fewer words",
                             words.size(),
                             max_request_bytes)};
  return Reading(words, knowledge).read();
}

}  // namespace marketgen::shopping
