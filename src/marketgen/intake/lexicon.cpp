#include "intake/lexicon.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <unordered_set>

#include "base/text.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::intake {
namespace {

constexpr std::size_t shortest_corrected = 5;  // letters; shorter words are too alike

std::vector<std::string> stems_of(std::string_view words) {
  std::vector<std::string> stems;
  for (const Token& token : tokenize(words)) {
    if (token.kind != TokenKind::sentence_end) stems.push_back(token.stem);
  }
  return stems;
}

bool stands_at(const std::vector<std::string>& stems,
               const std::vector<Token>& tokens,
               std::size_t at) {
  return at + stems.size() <= tokens.size() &&
         std::equal(stems.begin(),
                    stems.end(),
                    tokens.begin() + static_cast<std::ptrdiff_t>(at),
                    [](const std::string& stem, const Token& token) { return stem == token.stem; });
}

// One bit per letter: words that are one slip apart differ in at most two bits.
std::uint32_t letters_of(std::string_view word) {
  std::uint32_t letters = 0;
  for (const char c : word)
    letters |= 1U << (static_cast<unsigned char>(c) % 32U);
  return letters;
}

// A slip rarely hits the first letter, unless it swaps the first two.
bool starts_alike(std::string_view a, std::string_view b) {
  return a[0] == b[0] || (a[0] == b[1] && a[1] == b[0]);
}

// The zone type whose shelves these goods stand on: one that names their subcategory before one
// that takes the category.
std::string zone_selling(const catalog::Catalog& catalog, const catalog::Product& product) {
  const auto lists = [](const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
  };
  std::string general;
  for (const catalog::ZoneTypeRow& zone : catalog.zone_types) {
    if (!lists(zone.categories, product.category)) continue;
    if (lists(zone.subcategories, product.subcategory)) return zone.type;
    if (zone.subcategories.empty() && general.empty()) general = zone.type;
  }
  return general;
}

// The zone type whose usual fixtures they are; of other cabinets the one that is called after what
// they keep: "frozen" for upright freezers. Nothing for the rest.
std::string zone_using(const catalog::Catalog& catalog, const catalog::FixtureKind& fixture) {
  const auto row =
      std::ranges::find(catalog.zone_types, fixture.kind, &catalog::ZoneTypeRow::fixture);
  if (row != catalog.zone_types.end()) return row->type;
  const std::string kept(name_of(fixture.temperature));
  return fixture.temperature != catalog::Storage::ambient && catalog.zone_type(kept) != nullptr
             ? kept
             : "";
}

// Where goods of one name stand in several zones, that of fresh ones is meant before that of tins,
// and that before the freezer.
std::vector<const catalog::Product*> fresh_first(const catalog::Catalog& catalog) {
  const auto rank = [](const catalog::Product* product) {
    constexpr std::array<std::string_view, 2> kept = {"canned", "frozen"};
    const auto at = std::ranges::find(kept, product->category);
    if (at != kept.end()) return 2 + static_cast<int>(at - kept.begin());
    return product->category == "produce" ? 0 : 1;
  };
  std::vector<const catalog::Product*> products;
  for (const catalog::Product& product : catalog.products)
    products.push_back(&product);
  std::ranges::stable_sort(products, {}, rank);
  return products;
}

// What people put before the name of goods that are kept so.
std::vector<std::string> words_of_keeping(const std::string& category) {
  if (category == "frozen") return {"frozen"};
  if (category == "canned") return {"canned", "tinned"};
  return {};
}

// Words with their stems, which are made once and put together: a variant stands before many names.
struct Words {
  std::string text;
  std::vector<std::string> stems;
};

Words words_of(std::string text) {
  std::vector<std::string> stems = stems_of(text);
  return {std::move(text), std::move(stems)};
}

Words put_together(const Words& first, const Words& then) {
  Words both{first.text + " " + then.text, first.stems};
  both.stems.insert(both.stems.end(), then.stems.begin(), then.stems.end());
  return both;
}

Words last_word(const std::string& name) {
  return words_of(name.substr(name.rfind(' ') + 1));  // all of it when it has one word
}

// What a variant says of its product when people put it before the name, or its last word: "basmati
// rice", "whole milk" of fresh milk, "extra virgin olive oil". Each of its words, and
// the first two and more of them.
std::vector<Words> kinds_in(const std::string& variant) {
  constexpr std::size_t shortest = 3;  // letters
  std::vector<Words> kinds;
  const std::vector<Token> tokens = tokenize(variant);
  const bool plain = std::ranges::all_of(
      tokens, [](const Token& token) { return token.kind == TokenKind::word && !token.han; });
  for (std::size_t last = 2; plain && last <= tokens.size(); ++last) {
    Words& kind = kinds.emplace_back();
    kind.text = variant.substr(0, static_cast<std::size_t>(tokens[last - 1].span[1]));
    for (std::size_t i = 0; i < last; ++i)
      kind.stems.push_back(tokens[i].stem);
  }
  for (const Token& token : tokens) {
    const bool word = token.kind == TokenKind::word && !token.han;
    if (word && token.text.size() >= shortest) kinds.push_back(words_of(token.text));
  }
  return kinds;
}

}  // namespace

Result<Lexicon> Lexicon::load(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code fault;
  for (const auto& entry : std::filesystem::directory_iterator(folder, fault)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (files.empty()) {
    return Error{"catalog.missing_data",
                 folder.string(),
                 "there are no lexicon files here; install the data folder again or set "
                 "MARKETGEN_DATA to it"};
  }
  std::ranges::sort(files);
  Lexicon lexicon;
  for (const std::filesystem::path& file : files) {
    MARKETGEN_TRY(const std::string text, io::read_file(file));
    MARKETGEN_TRY(LexiconFile rows, io::read_json<LexiconFile>(text, file.string()));
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
      MARKETGEN_CHECK(
          lexicon.add_row(std::move(rows.rows[i]), file.string() + ":/rows/" + std::to_string(i)));
    }
  }
  return lexicon;
}

Result<void> Lexicon::add_row(LexiconRow row, const std::string& where) {
  const std::size_t index = rows_.size();
  rows_.push_back(std::move(row));
  for (const std::string& words : rows_[index].words) {
    std::vector<std::string> stems = stems_of(words);
    if (stems.empty()) return Error{"catalog.bad_row", where, "a phrase has no words"};
    const std::vector<Phrase>& list = phrases_[stems[0]];
    const auto known = std::ranges::find(list, stems, &Phrase::stems);
    if (known != list.end() && known->row == index) continue;  // folds to the same words
    if (known != list.end()) {
      return Error{"catalog.bad_row",
                   where,
                   "the phrase \"" + words + "\" already means \"" + rows_[known->row].value +
                       "\"; a phrase has one meaning"};
    }
    add_phrase(std::move(stems), index);
  }
  return {};
}

void Lexicon::add_phrase(std::vector<std::string> stems, std::size_t row) {
  for (const std::string& stem : stems)
    vocabulary_.try_emplace(stem, letters_of(stem));
  std::vector<Phrase>& list = phrases_[stems[0]];
  const auto shorter = std::ranges::find_if(
      list, [&](const Phrase& known) { return known.stems.size() < stems.size(); });
  list.insert(shorter, {std::move(stems), row});
}

void Lexicon::add_if_new(Sense sense,
                         const std::string& value,
                         const std::string& zone,
                         const std::string& words) {
  add_if_new(sense, value, zone, words, stems_of(words));
}

void Lexicon::add_if_new(Sense sense,
                         const std::string& value,
                         const std::string& zone,
                         const std::string& words,
                         std::vector<std::string> stems) {
  if (stems.empty()) return;
  // "orange" and "plaster" are said of goods, too.
  const auto may_be_goods = [&](const LexiconRow& row) {
    return sense == Sense::product && (row.sense == Sense::color || row.sense == Sense::material);
  };
  const auto list = phrases_.find(stems[0]);
  if (list != phrases_.end() && std::ranges::any_of(list->second, [&](const Phrase& p) {
        return p.stems == stems && !may_be_goods(rows_[p.row]);
      })) {
    return;
  }
  rows_.push_back({sense, value, 0, zone, {words}});
  add_phrase(std::move(stems), rows_.size() - 1);
}

std::vector<Lexicon::Match> Lexicon::matches(const std::vector<Token>& tokens,
                                             std::size_t at) const {
  std::vector<Match> found;
  const auto list = phrases_.find(tokens[at].stem);
  if (list == phrases_.end()) return found;
  for (const Phrase& phrase : list->second)
    if (stands_at(phrase.stems, tokens, at))
      found.push_back({&rows_[phrase.row], phrase.stems.size()});
  return found;
}

std::optional<Lexicon::Match> Lexicon::longest_match(const std::vector<Token>& tokens,
                                                     std::size_t at) const {
  const auto list = phrases_.find(tokens[at].stem);
  if (list == phrases_.end()) return std::nullopt;
  const auto longest = std::ranges::find_if(
      list->second, [&](const Phrase& phrase) { return stands_at(phrase.stems, tokens, at); });
  if (longest == list->second.end()) return std::nullopt;
  return Match{&rows_[longest->row], longest->stems.size()};
}

std::optional<std::string> Lexicon::corrected(std::string_view word) const {
  if (word.size() < shortest_corrected || knows_word(word)) return std::nullopt;
  const std::uint32_t letters = letters_of(word);
  for (const auto& [known, known_letters] : vocabulary_) {
    if (known.size() + 1 < word.size() || known.size() > word.size() + 1) continue;
    if (known.size() < shortest_corrected || std::popcount(letters ^ known_letters) > 2) continue;
    if (starts_alike(word, known) && edit_distance(word, known) == 1) return known;
  }
  return std::nullopt;
}

void Lexicon::add_goods(const catalog::Catalog& catalog) {
  const std::vector<const catalog::Product*> products = fresh_first(catalog);
  std::unordered_set<std::string> known;  // many products share a name, and many a variant
  const auto add = [&](const catalog::Product& product, const std::string& value, Words words) {
    if (known.insert(words.text).second)
      add_if_new(Sense::product,
                 value,
                 zone_selling(catalog, product),
                 words.text,
                 std::move(words.stems));
  };
  for (const catalog::Product* product : products) {
    add(*product, product->subcategory, words_of(product->subcategory));
    add(*product, product->name, words_of(product->name));
    add(*product, product->name, words_of(product->name_zh));
  }
  for (const catalog::Product* product : products) {
    const Words name = words_of(product->name), last = last_word(product->name);
    for (const std::string& kept : words_of_keeping(product->category))
      add(*product, product->name, put_together(words_of(kept), name));
    for (const Words& kind : kinds_in(product->variant)) {
      for (const Words* noun : {&name, &last}) {
        const Words phrase = put_together(kind, *noun);
        add(*product, phrase.text, phrase);
      }
    }
  }
}

Lexicon Lexicon::with_words_of(const catalog::Catalog& catalog) const {
  Lexicon all = *this;
  for (const catalog::ZoneTypeRow& zone : catalog.zone_types) {
    all.add_if_new(Sense::zone, zone.type, "", zone.label);
    for (const std::string& word : zone.keywords)
      all.add_if_new(Sense::zone, zone.type, "", word);
  }
  for (const catalog::FixtureKind& fixture : catalog.fixture_kinds) {
    if (fixture.keywords.empty()) continue;  // a variant: plans name it by its id only
    const std::string zone = zone_using(catalog, fixture);
    all.add_if_new(Sense::fixture, fixture.kind, zone, fixture.name);
    for (const std::string& word : fixture.keywords) {
      all.add_if_new(Sense::fixture, fixture.kind, zone, word);
    }
  }
  for (const catalog::StyleRow& style : catalog.styles) {
    all.add_if_new(Sense::style, style.id, "", style.name);
    for (const std::string& word : style.keywords) {
      all.add_if_new(Sense::style, style.id, "", word);
    }
  }
  all.add_goods(catalog);
  return all;
}

}  // namespace marketgen::intake
