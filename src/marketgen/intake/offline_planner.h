// The planner that needs no network: words to wishes by a lexicon and rules, wishes to a plan by
// seeded search.
#pragma once
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
  Language language_;
};

}  // namespace marketgen::intake
