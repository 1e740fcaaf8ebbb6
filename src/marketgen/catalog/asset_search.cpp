#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/text.h"
#include "catalog/asset_database.h"
#include "catalog/search_words.h"

// The question side of the asset database: filters in SQL, free text as asset_database.h says.
namespace marketgen::catalog {
namespace {

// Weights of the contract in asset_database.h, in the order of the columns of `words`.
constexpr std::string_view score_query =
    "SELECT rowid, -bm25(words, 5, 5, 2, 2, 3, 3, 1, 0.5) FROM words WHERE words MATCH ?";
constexpr double meaning_share = 0.6, saying_share = 1, beginning_share = 0.3, apart_share = 0.5;
constexpr double named_bonus = 1.5;
constexpr std::size_t shortest_beginning = 3, longest_saying = 3;
constexpr std::size_t max_words = 24;  // of one question; the rest is ignored

using Scores = std::map<std::int64_t, double>;  // asset id -> score

void keep_best(Scores& scores, const Scores& others, double share) {
  for (const auto& [asset, score] : others) {
    double& best = scores[asset];
    best = std::max(best, score * share);
  }
}

bool listed(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::vector<std::string> tokens_of(const std::vector<SearchWord>& words) {
  std::vector<std::string> tokens;
  for (const SearchWord& word : words)
    tokens.insert(tokens.end(), word.tokens.begin(), word.tokens.end());
  return tokens;
}

// What a question asks for, word by word.
struct Question {
  std::vector<SearchWord> words;    // wanted
  std::vector<SearchWord> without;  // unwanted
};

Question question_of(std::string_view text, const SearchLexicon& lexicon) {
  std::vector<SearchWord> words = search_words_of(text);
  if (words.size() > max_words) words.resize(max_words);
  Question question;
  bool turned = false;
  for (SearchWord& word : words) {
    const std::string spelled = word.text();
    if (listed(lexicon.without, spelled)) {
      turned = true;
    } else if (!listed(lexicon.skip, spelled)) {
      (turned ? question.without : question.words).push_back(std::move(word));
      turned = false;
    }
  }
  return question;
}

// Scores a question against one database.
class Scorer {
 public:
  static Result<Scorer> begin(const io::SqlDatabase& sql) {
    MARKETGEN_TRY(io::SqlStatement score, sql.prepare(score_query));
    MARKETGEN_TRY(
        io::SqlStatement saying,
        sql.prepare("SELECT means FROM sayings WHERE sayings MATCH ? AND tokens = ? ORDER BY "
                    "rowid"));
    MARKETGEN_TRY(io::SqlStatement named,
                  sql.prepare("SELECT rowid FROM words WHERE words MATCH 'name : (' || ? || ')'"));
    MARKETGEN_TRY(io::SqlStatement length,
                  sql.prepare("SELECT name_words FROM assets WHERE id = ?"));
    return Scorer(std::move(score), std::move(saying), std::move(named), std::move(length));
  }

  Result<Scores> score(const Question& question) {
    for (std::size_t first = 0; first < question.words.size(); ++first) {
      MARKETGEN_CHECK(add_word(question.words[first]));
      for (std::size_t count = 2; count <= longest_saying && first + count <= question.words.size();
           ++count) {
        const auto start = question.words.begin() + static_cast<std::ptrdiff_t>(first);
        MARKETGEN_CHECK(add_saying({start, start + static_cast<std::ptrdiff_t>(count)}));
      }
    }
    for (const SearchWord& word : question.without)
      MARKETGEN_CHECK(add_absence(word));
    return total();
  }

 private:
  Scorer(io::SqlStatement score,
         io::SqlStatement saying,
         io::SqlStatement named,
         io::SqlStatement length)
      : score_(std::move(score)),
        saying_(std::move(saying)),
        named_(std::move(named)),
        length_(std::move(length)) {}

  Result<Scores> scores_of(const std::string& expression) {
    Scores scores;
    score_.start().bind(1, expression);
    while (true) {
      MARKETGEN_TRY(const bool more, score_.step());
      if (!more) return scores;
      scores.emplace(score_.integer(0), score_.number(1));
    }
  }

  Result<void> add(Scores& group, const std::string& expression, double share) {
    MARKETGEN_TRY(const Scores scores, scores_of(expression));
    keep_best(group, scores, share);
    return {};
  }

  // What the words may mean, best of all meanings; true when they are a saying at all.
  Result<bool> add_meanings(Scores& group, const std::vector<std::string>& tokens, double share) {
    std::vector<std::string> meanings;
    saying_.start()
        .bind(1, phrase_expression(tokens))
        .bind(2, static_cast<std::int64_t>(tokens.size()));
    while (true) {
      MARKETGEN_TRY(const bool more, saying_.step());
      if (!more) break;
      meanings.push_back(saying_.text(0));
    }
    for (const std::string& text : meanings) {
      const std::vector<std::string> means = tokens_of(search_words_of(text));
      MARKETGEN_CHECK(add(group, all_expression(means), share));
      if (share < saying_share) continue;
      MARKETGEN_TRY(const std::vector<std::int64_t> named, named_with(all_expression(means)));
      for (const std::int64_t asset : named) {
        std::size_t& meant = meant_in_name_[asset];
        meant = std::max(meant, means.size());
      }
    }
    return !meanings.empty();
  }

  // Rows whose name alone answers the expression.
  Result<std::vector<std::int64_t>> named_with(const std::string& expression) {
    std::vector<std::int64_t> assets;
    named_.start().bind(1, expression);
    while (true) {
      MARKETGEN_TRY(const bool more, named_.step());
      if (!more) return assets;
      assets.push_back(named_.integer(0));
    }
  }

  Result<void> add_word(const SearchWord& word) {
    Scores group;
    MARKETGEN_CHECK(add(group, phrase_expression(word.tokens), 1));
    if (word.tokens.size() > 1)
      MARKETGEN_CHECK(add(group, all_expression(word.tokens), apart_share));
    MARKETGEN_TRY([[maybe_unused]] const bool said,
                  add_meanings(group, word.tokens, word.chinese ? saying_share : meaning_share));
    if (!word.chinese && word.tokens[0].size() >= shortest_beginning)
      MARKETGEN_CHECK(add(group, phrase_expression(word.tokens) + "*", beginning_share));
    groups_.push_back(std::move(group));

    MARKETGEN_TRY(const std::vector<std::int64_t> named,
                  named_with(phrase_expression(word.tokens)));
    for (const std::int64_t asset : named)
      ++asked_in_name_[asset];
    return {};
  }

  Result<void> add_saying(const std::vector<SearchWord>& words) {
    const std::vector<std::string> tokens = tokens_of(words);
    Scores group;
    MARKETGEN_TRY(const bool said, add_meanings(group, tokens, saying_share));
    if (!said) return {};
    MARKETGEN_CHECK(add(group, all_expression(tokens), 1));
    groups_.push_back(std::move(group));
    return {};
  }

  Result<void> add_absence(const SearchWord& word) {
    const std::string unwanted = word.text();
    Scores group;
    for (const std::vector<std::string>& phrase : {std::vector<std::string>{unwanted, "free"},
                                                   {"free", "of", unwanted},
                                                   {"no", unwanted},
                                                   {"zero", unwanted},
                                                   {"without", unwanted}})
      MARKETGEN_CHECK(add(group, phrase_expression(phrase), 1));
    MARKETGEN_TRY([[maybe_unused]] const bool said,
                  add_meanings(group, {unwanted, "free"}, meaning_share));
    MARKETGEN_TRY(const Scores mentions, scores_of(phrase_expression(word.tokens)));
    for (const auto& [asset, score] : mentions)
      if (!group.contains(asset)) left_out_.push_back(asset);
    groups_.push_back(std::move(group));
    return {};
  }

  Result<Scores> total() {
    struct Sum {
      double score = 0;
      int groups = 0;
    };
    std::map<std::int64_t, Sum> sums;
    for (const Scores& group : groups_) {
      for (const auto& [asset, score] : group) {
        sums[asset].score += score;
        ++sums[asset].groups;
      }
    }
    for (const std::int64_t asset : left_out_)
      sums.erase(asset);
    Scores scores;
    for (const auto& [asset, sum] : sums) {
      MARKETGEN_TRY(const double bonus, bonus_of(asset));
      scores[asset] = sum.score * sum.groups / static_cast<double>(groups_.size()) * bonus;
    }
    return scores;
  }

  Result<double> bonus_of(std::int64_t asset) {
    const auto count = [asset](const std::map<std::int64_t, std::size_t>& in_name) {
      const auto found = in_name.find(asset);
      return found == in_name.end() ? std::size_t{0} : found->second;
    };
    const std::size_t words = std::max(count(asked_in_name_), count(meant_in_name_));
    if (words == 0) return 1.0;
    MARKETGEN_TRY([[maybe_unused]] const bool row, length_.start().bind(1, asset).step());
    return words >= static_cast<std::size_t>(length_.integer(0)) ? named_bonus : 1.0;
  }

  io::SqlStatement score_, saying_, named_, length_;
  std::vector<Scores> groups_;
  // How many words of the question, or of one meaning of a saying, stand in an asset's name.
  std::map<std::int64_t, std::size_t> asked_in_name_, meant_in_name_;
  std::vector<std::int64_t> left_out_;
};

// ---- Filters. ----

Result<void> check_name(const io::SqlDatabase& sql,
                        std::string_view list,
                        const std::string& name) {
  if (name.empty()) return {};
  MARKETGEN_TRY(io::SqlStatement names, sql.prepare("SELECT name FROM names WHERE list = ?"));
  names.start().bind(1, list);
  std::vector<std::string> known;
  while (true) {
    MARKETGEN_TRY(const bool more, names.step());
    if (!more) break;
    known.push_back(names.text(0));
  }
  if (listed(known, name)) return {};
  return unknown_name("catalog.unknown_kind", name, list, name, {known.begin(), known.end()});
}

Result<void> check_names(const io::SqlDatabase& sql, const AssetQuery& query) {
  MARKETGEN_CHECK(check_name(sql, "zone type", query.zone));
  MARKETGEN_CHECK(check_name(sql, "category", query.category));
  MARKETGEN_CHECK(check_name(sql, "style", query.style));
  return check_name(sql, "storage", query.storage);
}

// An empty text or a zero limit asks for nothing.
constexpr std::string_view filter_query = R"sql(
  SELECT id, kind, row FROM assets WHERE
    (?1 = 0 OR (?1 >> kind) & 1) AND
    (?2 = '' OR id IN (SELECT asset FROM asset_zones WHERE zone = ?2)) AND
    (?3 = '' OR category = ?3) AND (?4 = '' OR subcategory = ?4) AND
    (?5 = '' OR archetype = ?5) AND (?6 = '' OR material = ?6) AND
    (?7 = '' OR id IN (SELECT asset FROM asset_styles WHERE style = ?7)) AND
    (?8 = '' OR storage = ?8) AND (?9 = 0 OR width_mm <= ?9) AND (?10 = 0 OR depth_mm <= ?10) AND
    (?11 = 0 OR height_mm <= ?11) AND (?12 = 0 OR mass_kg <= ?12)
  ORDER BY id
)sql";

struct Candidate {
  std::int64_t id = 0;
  AssetHit hit;
};

Result<std::vector<Candidate>> candidates_of(const io::SqlDatabase& sql, const AssetQuery& query) {
  std::int64_t kinds = 0;  // bit k: kind k is wanted
  for (const AssetKind kind : query.kinds)
    kinds |= std::int64_t{1} << static_cast<int>(kind);
  MARKETGEN_TRY(io::SqlStatement filter, sql.prepare(filter_query));
  filter.start()
      .bind(1, kinds)
      .bind(2, query.zone)
      .bind(3, query.category)
      .bind(4, query.subcategory)
      .bind(5, query.archetype)
      .bind(6, query.material)
      .bind(7, query.style)
      .bind(8, query.storage)
      .bind(9, std::int64_t{query.max_width_mm})
      .bind(10, std::int64_t{query.max_depth_mm})
      .bind(11, std::int64_t{query.max_height_mm})
      .bind(12, query.max_mass_kg);
  std::vector<Candidate> candidates;
  while (true) {
    MARKETGEN_TRY(const bool more, filter.step());
    if (!more) return candidates;
    candidates.push_back({filter.integer(0),
                          {static_cast<AssetKind>(filter.integer(1)),
                           static_cast<std::uint32_t>(filter.integer(2)),
                           0}});
  }
}

}  // namespace

Result<std::vector<AssetHit>> AssetDatabase::find(const AssetQuery& query) const {
  if (!is_utf8(query.text))
    return Error{"input.not_utf8", "text", "the text to look for is not UTF-8"};
  MARKETGEN_CHECK(check_names(sql_, query));
  MARKETGEN_TRY(const std::vector<Candidate> candidates, candidates_of(sql_, query));
  std::vector<AssetHit> hits;
  if (query.text.empty()) {
    for (const Candidate& candidate : candidates)
      hits.push_back(candidate.hit);
    return hits;
  }
  MARKETGEN_TRY(Scorer scorer, Scorer::begin(sql_));
  MARKETGEN_TRY(const Scores scores, scorer.score(question_of(query.text, lexicon_)));
  for (const Candidate& candidate : candidates) {
    const auto score = scores.find(candidate.id);
    if (score == scores.end()) continue;
    hits.push_back(candidate.hit);
    hits.back().score = score->second;
  }
  std::stable_sort(hits.begin(), hits.end(), [](const AssetHit& a, const AssetHit& b) {
    return a.score > b.score;
  });
  return hits;
}

}  // namespace marketgen::catalog
