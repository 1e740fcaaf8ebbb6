#include "assets/import/asset_annotator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "assets/product_model.h"
#include "base/text.h"
#include "catalog/usual_pack.h"

namespace marketgen::assets {
namespace {

constexpr std::size_t max_votes = 10;
constexpr double metal_share = 0.5, clear_share = 0.3;  // of the surface, to decide the material

// Words that modelling programs and habits put into names, between spaces.
constexpr std::string_view noise =
    " the mesh object obj node root scene material mat default model geometry geo group lod low "
    "high poly lowpoly cube cylinder plane sphere texture textured base color colour main part "
    "body new final test export asset world null empty initialshadinggroup lambert phong "
    "aistandardsurface ";

// What words say of the contact material; the first that is found counts.
struct MaterialWord {
  const char *word, *material;
};
constexpr std::array material_words = {MaterialWord{"glass", "glass"},
                                       MaterialWord{"aluminium", "aluminium"},
                                       MaterialWord{"aluminum", "aluminium"},
                                       MaterialWord{"tin", "tin"},
                                       MaterialWord{"steel", "tin"},
                                       MaterialWord{"metal", "tin"},
                                       MaterialWord{"cardboard", "cardboard"},
                                       MaterialWord{"carton", "cardboard"},
                                       MaterialWord{"paper", "paper"},
                                       MaterialWord{"foil", "foil"},
                                       MaterialWord{"film", "film"},
                                       MaterialWord{"wrapper", "film"},
                                       MaterialWord{"pet", "pet"},
                                       MaterialWord{"plastic", "pet"},
                                       MaterialWord{"hdpe", "hdpe"}};

bool is_noise(const std::string& word) {
  return word.size() < 2 || noise.find(" " + word + " ") != std::string_view::npos ||
         word.find_first_not_of("0123456789") == std::string::npos;
}

// Cuts at everything that is no letter, at digits and before capitals within a word.
std::vector<std::string> cut(const std::string& name) {
  std::vector<std::string> words(1);
  bool was_small = false;
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    const bool capital = std::isupper(u) != 0;
    if (std::isalpha(u) == 0 && u < 0x80) {
      words.emplace_back();
    } else {
      if (capital && was_small) words.emplace_back();
      words.back() += static_cast<char>(u < 0x80 ? std::tolower(u) : u);
    }
    was_small = std::islower(u) != 0 || u >= 0x80;
  }
  return words;
}

bool has(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Votes for names, in the order of their sum.
class Ballot {
 public:
  void vote(const std::string& name, double weight) {
    votes_[name] += weight;
    sum_ += weight;
  }
  std::string winner() const {
    const auto best = std::max_element(
        votes_.begin(), votes_.end(), [](auto& a, auto& b) { return a.second < b.second; });
    return best == votes_.end() ? std::string() : best->first;
  }
  double share(const std::string& name) const {
    const auto found = votes_.find(name);
    return found == votes_.end() || sum_ <= 0 ? 0 : found->second / sum_;
  }

 private:
  std::map<std::string, double> votes_;
  double sum_ = 0;
};

std::string title(const std::vector<std::string>& words) {
  std::string text = fmt::format("{}", fmt::join(words, " "));
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.substr(0, 80);
}

// The longest archetype all of whose words stand among `words`.
std::string archetype_named(const std::vector<std::string>& words) {
  std::string best;
  for (const ArchetypeInfo& info : archetypes()) {
    const std::vector<std::string> parts = marketgen::split(info.name, '_');
    const bool named = std::all_of(
        parts.begin(), parts.end(), [&](const std::string& part) { return has(words, part); });
    if (named && info.name.size() > best.size()) best = info.name;
  }
  return best;
}

std::string material_seen(const std::vector<std::string>& words,
                          const catalog::AssetLook& look,
                          std::vector<std::string>& reasons) {
  for (const MaterialWord& entry : material_words) {
    if (!has(words, entry.word)) continue;
    reasons.push_back(fmt::format("\"{}\" in its names says {}", entry.word, entry.material));
    return entry.material;
  }
  if (look.clear > clear_share) {
    reasons.push_back(fmt::format("{:.0f} % of it is clear: glass", 100 * look.clear));
    return "glass";
  }
  if (look.metallic > metal_share) {
    reasons.push_back(fmt::format("{:.0f} % of it is metal: tin", 100 * look.metallic));
    return "tin";
  }
  return {};
}

class OfflineAnnotator {
 public:
  OfflineAnnotator(const catalog::Catalog& catalog, const catalog::AssetDatabase& database)
      : catalog_(catalog), database_(database) {}

  Result<catalog::AssetAnnotation> annotate(const AssetEvidence& evidence) const {
    const std::string stem = std::filesystem::path(evidence.file_name).stem().string();
    const std::vector<std::string> own = words_of_names({stem});
    std::vector<std::string> names = evidence.parts;
    names.insert(names.begin(), stem);
    const std::vector<std::string> words = words_of_names(names);

    catalog::AssetAnnotation annotation;
    annotation.annotator = "offline";
    annotation.name = title(own.empty() ? words : own);
    annotation.keywords = words;
    annotation.material = material_seen(words, evidence.look, annotation.reasons);
    annotation.archetype = archetype_named(words);
    if (annotation.material.empty() && !annotation.archetype.empty()) {
      catalog::Product named;
      named.archetype = annotation.archetype;
      annotation.material = catalog::usual_material(catalog_.products, named);
      annotation.reasons.push_back(fmt::format(
          "most rows of archetype {} are of {}", annotation.archetype, annotation.material));
    }
    MARKETGEN_CHECK(vote(words, annotation));
    return annotation;
  }

 private:
  Result<void> vote(const std::vector<std::string>& words,
                    catalog::AssetAnnotation& annotation) const {
    catalog::AssetQuery query;
    query.text = fmt::format("{}", fmt::join(words, " "));
    query.kinds = {catalog::AssetKind::goods};
    if (query.text.empty()) return {};
    MARKETGEN_TRY(std::vector<catalog::AssetHit> hits, database_.find(query));
    if (hits.size() > max_votes) hits.resize(max_votes);
    Ballot category, subcategory, material, archetype, storage, rigidity;
    for (const catalog::AssetHit& hit : hits) {
      const catalog::Product& p = catalog_.products[hit.row];
      category.vote(p.category, hit.score);
      subcategory.vote(p.category + "/" + p.subcategory, hit.score);
      material.vote(p.material, hit.score);
      archetype.vote(p.archetype, hit.score);
      storage.vote(std::string(name_of(p.storage)), hit.score);
      rigidity.vote(std::string(name_of(p.rigidity)), hit.score);
    }
    if (hits.empty()) return {};
    const std::string place = subcategory.winner();
    annotation.category = place.substr(0, place.find('/'));
    annotation.subcategory = place.substr(place.find('/') + 1);
    annotation.confidence = category.share(annotation.category);
    if (annotation.material.empty()) annotation.material = material.winner();
    if (annotation.archetype.empty()) annotation.archetype = archetype.winner();
    annotation.storage =
        value_named<catalog::Storage>(storage.winner()).value_or(catalog::Storage::ambient);
    annotation.rigidity =
        value_named<catalog::Rigidity>(rigidity.winner()).value_or(catalog::Rigidity::rigid);
    annotation.reasons.push_back(fmt::format("its names find \"{}\" ({}), score {:.1f}",
                                             catalog_.products[hits[0].row].name,
                                             catalog_.products[hits[0].row].sku,
                                             hits[0].score));
    return {};
  }

  const catalog::Catalog& catalog_;
  const catalog::AssetDatabase& database_;
};

}  // namespace

std::vector<std::string> words_of_names(const std::vector<std::string>& names) {
  std::vector<std::string> words;
  for (const std::string& name : names) {
    for (const std::string& word : cut(name)) {
      if (!is_noise(word) && !has(words, word)) words.push_back(word);
    }
  }
  constexpr std::size_t max_words = 24;
  if (words.size() > max_words) words.resize(max_words);
  return words;
}

AssetAnnotator offline_annotator(const catalog::Catalog& catalog,
                                 const catalog::AssetDatabase& database) {
  return [annotator = OfflineAnnotator(catalog, database)](const AssetEvidence& evidence) {
    return annotator.annotate(evidence);
  };
}

}  // namespace marketgen::assets
