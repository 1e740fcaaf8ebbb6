#include "perception/goal_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "catalog/container_nouns.h"
#include "catalog/label_color.h"
#include "perception/said_amounts.h"

namespace marketgen::perception {
namespace {

constexpr double name_weight = 5, variant_weight = 4, brand_weight = 4, keyword_weight = 3,
                 group_weight = 2, category_weight = 1, description_weight = 0.5;
constexpr double meaning_share = 0.6, unsaid_share = 0.15, absence_weight = 4;
constexpr double amount_worth = 12;
constexpr double tie_share = 0.02;
constexpr std::size_t longest_saying = 3;

std::string spaced(const std::vector<std::string>& words) {
  return fmt::format(" {} ", fmt::join(words, " "));
}

std::vector<std::string> phrase_at(const std::vector<std::string>& words,
                                   std::size_t at,
                                   std::size_t count) {
  const auto from = words.begin() + static_cast<std::ptrdiff_t>(at);
  return {from, from + static_cast<std::ptrdiff_t>(count)};
}

std::vector<std::string> counted_in(const std::vector<std::optional<catalog::NetContent>>& nets) {
  std::set<std::string> counted;
  for (const auto& net : nets)
    if (net && net->unit == catalog::NetUnit::piece) counted.insert(net->counted);
  return {counted.begin(), counted.end()};
}

}  // namespace

CatalogueReader::CatalogueReader(const std::vector<catalog::Product>& rows,
                                 const catalog::SearchLexicon& lexicon)
    : skip_(lexicon.skip.begin(), lexicon.skip.end()),
      without_(lexicon.without.begin(), lexicon.without.end()) {
  for (const catalog::Product& product : rows)
    add_row(product);
  std::ranges::sort(rows_, {}, &Row::sku);
  std::vector<std::optional<catalog::NetContent>> nets;
  for (const Row& row : rows_)
    nets.push_back(row.net);
  counted_ = counted_in(nets);
  for (const catalog::SearchIntent& intent : lexicon.intents)
    add_intent(intent);
}

void CatalogueReader::add_row(const catalog::Product& product) {
  Row row;
  row.sku = product.sku;
  row.net = catalog::net_content(product.net);
  row.name = plain_words(product.name);
  const auto add = [&](std::string_view text, double weight) {
    for (const std::string& word : plain_words(text)) {
      double& best = row.weights[word];
      best = std::max(best, weight);
    }
  };
  add(product.name, name_weight);
  add(product.variant, variant_weight);
  add(product.brand, brand_weight);
  std::string named = product.name + " " + product.variant;
  for (const std::string& keyword : product.keywords) {
    add(keyword, keyword_weight);
    named += " " + keyword;
  }
  std::string shape = product.archetype;
  std::ranges::replace(shape, '_', ' ');
  const auto add_shape = [&](std::string_view called) {
    add(called, group_weight);
    for (const std::string& word : plain_words(called))
      skip_.erase(word);
  };
  add_shape(shape);
  for (const catalog::ContainerNoun& called : catalog::container_nouns(product.archetype))
    add_shape(called.noun);
  add(product.subcategory, group_weight);
  std::string category = product.category;
  std::ranges::replace(category, '_', ' ');
  add(category, category_weight);
  if (const auto color = catalog::label_color_term(product.label.primary))
    add(*color, category_weight);
  add(product.description, description_weight);
  row.named = spaced(plain_words(named));
  for (const auto& [word, weight] : row.weights)
    ++rows_with_[word];
  rows_.push_back(std::move(row));
}

void CatalogueReader::add_intent(const catalog::SearchIntent& intent) {
  std::vector<std::vector<std::string>> means;
  for (const std::string& text : intent.means)
    if (auto words = plain_words(text); !words.empty()) means.push_back(std::move(words));
  for (const std::string& text : intent.say)
    if (auto say = plain_words(text); !say.empty() && say.size() <= longest_saying)
      meanings_[say.front()].push_back({say, means});
}

bool CatalogueReader::knows(std::string_view word) const {
  if (rows_with_.contains(word)) return true;
  return std::ranges::any_of(meanings_, [&](const auto& first) {
    return std::ranges::any_of(first.second, [&](const Meaning& meaning) {
      return std::ranges::find(meaning.say, word) != meaning.say.end();
    });
  });
}

double CatalogueReader::rarity(std::string_view word) const {
  const auto found = rows_with_.find(word);
  if (found == rows_with_.end()) return 0;
  return std::log((static_cast<double>(rows_.size()) + 1) / found->second);
}

double CatalogueReader::word_worth(const Row& row, const std::string& word) const {
  const auto found = row.weights.find(word);
  return found == row.weights.end() ? 0 : found->second * rarity(word);
}

// Of the best of its meanings, all of whose words the row has: its rarest word's worth.
double CatalogueReader::meaning_worth(const Row& row, const Meaning& meaning) const {
  double best = 0;
  for (const std::vector<std::string>& words : meaning.means) {
    double most = 0;
    bool all = true;
    for (const std::string& word : words) {
      const double worth = word_worth(row, word);
      all = all && worth > 0;
      most = std::max(most, worth);
    }
    if (all) best = std::max(best, most * meaning_share);
  }
  return best;
}

// Of the word there, alone or with those after it.
double CatalogueReader::group_worth(const Row& row,
                                    const std::vector<std::string>& words,
                                    std::size_t at) const {
  double best = skip_.contains(words[at]) ? 0 : word_worth(row, words[at]);
  const auto meanings = meanings_.find(words[at]);
  if (meanings == meanings_.end()) return best;
  for (const Meaning& meaning : meanings->second) {
    if (at + meaning.say.size() > words.size() ||
        phrase_at(words, at, meaning.say.size()) != meaning.say)
      continue;
    best = std::max(best, meaning_worth(row, meaning));
  }
  return best;
}

// "Without X": more for what says so, less for what mentions X otherwise.
double CatalogueReader::absence_worth(const Row& row, const std::string& word) const {
  for (const char* const said : {" {} free ", " no {} ", " zero {} ", " without {} ", " un{} "})
    if (row.named.find(fmt::format(fmt::runtime(said), word)) != std::string::npos)
      return absence_weight * std::max(1.0, rarity(word));
  return -word_worth(row, word);
}

double CatalogueReader::unsaid_worth(const Row& row, const std::set<std::string>& said) const {
  double unsaid = 0;
  for (const std::string& word : row.name)
    if (!said.contains(word)) unsaid += name_weight * rarity(word);
  return unsaid * unsaid_share;
}

double CatalogueReader::words_worth(const Row& row, const std::vector<std::string>& words) const {
  double worth = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (without_.contains(words[i]) && i + 1 < words.size())
      worth += absence_worth(row, words[++i]);
    else
      worth += group_worth(row, words, i);
  }
  return worth;
}

bool CatalogueReader::any_of_amount(const catalog::NetContent& amount) const {
  return std::ranges::any_of(
      rows_, [&](const Row& row) { return row.net && row.net->is_as_much_as(amount); });
}

Result<std::vector<std::string>> CatalogueReader::read(const std::string& text) const {
  SaidWords said = said_words(text, counted_);
  std::erase_if(said.amounts, [&](const auto& amount) { return !any_of_amount(amount); });
  const std::set<std::string> said_set(said.words.begin(), said.words.end());
  std::vector<std::pair<double, const Row*>> worth;
  for (const Row& row : rows_) {
    const double by_words = words_worth(row, said.words);
    if (by_words <= 0) continue;
    double of_row = by_words - unsaid_worth(row, said_set);
    for (const catalog::NetContent& amount : said.amounts)
      of_row += row.net && row.net->is_as_much_as(amount) ? amount_worth : -amount_worth;
    worth.emplace_back(of_row, &row);
  }
  if (worth.empty())
    return Error{"perception.not_understood",
                 text,
                 fmt::format("no word of it is in any of the catalogue's {} rows", rows_.size())};
  std::ranges::stable_sort(worth, std::greater<>{}, [](const auto& each) { return each.first; });
  const double best = worth.front().first;
  std::vector<std::string> skus;
  for (const auto& [of_row, row] : worth)
    if (of_row >= best - tie_share * std::abs(best)) skus.push_back(row->sku);
  return skus;
}

}  // namespace marketgen::perception
