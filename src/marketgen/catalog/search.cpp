#include "catalog/search.h"

#include <algorithm>
#include <numeric>

#include "base/text.h"

namespace marketgen {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : lower_ascii(text)) {
    const bool letter =
        (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (letter)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

double match(const std::string& word, std::string_view field, double weight) {
  constexpr std::size_t shortest_beginning = 3;
  double best = 0;
  for (const std::string& other : words_of(field)) {
    if (other == word || other + "s" == word || word + "s" == other) return weight;
    if (word.size() >= shortest_beginning && other.starts_with(word)) best = weight / 2;
  }
  return best;
}

// "milk" means milk before it means milk rolls: the name says it of both, the subcategory only of
// one.
constexpr double share_of_other_fields = 0.1;

double score_of(const Product& p, const std::string& word) {
  std::vector<double> scores = {match(word, p.name, 4),
                                match(word, p.variant, 3),
                                match(word, p.brand, 3),
                                match(word, p.subcategory, 2),
                                match(word, p.category, 1),
                                match(word, p.description, 1)};
  double keyword_score = 0;
  for (const std::string& keyword : p.keywords)
    keyword_score = std::max(keyword_score, match(word, keyword, 3));
  scores.push_back(keyword_score);
  const double best = *std::max_element(scores.begin(), scores.end());
  const double all = std::accumulate(scores.begin(), scores.end(), 0.0);
  return best + share_of_other_fields * (all - best);
}

}  // namespace

std::vector<SearchHit> search_products(const Catalog& catalog, std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  std::vector<SearchHit> hits;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
    double sum = 0;
    int matched = 0;
    for (const std::string& word : words) {
      const double score = score_of(catalog.products[i], word);
      sum += score;
      matched += score > 0 ? 1 : 0;
    }
    if (matched > 0) hits.push_back({i, sum * matched / static_cast<double>(words.size())});
  }
  std::stable_sort(hits.begin(), hits.end(), [](const SearchHit& a, const SearchHit& b) {
    return a.score > b.score;
  });
  return hits;
}

}  // namespace marketgen
