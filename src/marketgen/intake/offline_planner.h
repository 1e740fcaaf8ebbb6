// The planner that needs no network: words to wishes by a lexicon and rules, wishes to a plan by
// seeded search.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "intake/brief.h"
#include "intake/language.h"

namespace marketgen::intake {

class OfflinePlanner : public Planner {
 public:
  explicit OfflinePlanner(Language language) : language_(std::move(language)) {}

  // With the language of the program's data. Errors: of Language::load.
  static Result<OfflinePlanner> load();

  // Error: brief.bad_size when the words ask for a store that cannot be built.
  Result<Planned> plan(const Brief& brief,
                       const catalog::Catalog& catalog,
                       Seed seed,
                       const Concessions& concessions) const override;

 private:
  // With the catalogue's own words. Making it takes longer than reading a prompt, and a store is
  // planned several times: it is kept until another catalogue comes.
  std::shared_ptr<const Language> language_with(const catalog::Catalog& catalog) const;

  struct Kept {
    std::mutex mutex;
    std::string content_hash;  // of the catalogue
    std::shared_ptr<const Language> language;
  };

  Language language_;
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

}  // namespace marketgen::intake
