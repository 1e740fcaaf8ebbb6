// The words of an edit, and the patches that do what they ask.
//
// Words say what is wanted, not where its coordinates are: for each wish there are several ways
// (which zone gives up its place, which cut moves), the gentlest first. The store tries them, one
// wish after the other.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/understanding.h"
#include "plan/patch.h"

namespace marketgen::intake {

// One thing that the words ask for.
struct EditWish {
  std::string text;
  IntRange span{0, 0};
  std::variant<plan::Requirement, WordedChange> what;
};

struct EditWords {
  std::vector<EditWish> wishes;  // in their order in the text
  std::vector<UnparsedWord> unparsed;
  std::vector<Conflict> conflicts;
};

// Reads the words, with the language of Language::load_for_edits. `entrance`: the wall of the
// store's entrance. Errors: brief.empty, brief.too_long, input.not_utf8.
Result<EditWords> understand_edit(std::string_view words,
                                  const Language& language,
                                  const catalog::Catalog& catalog,
                                  plan::Wall entrance);

// What the ways are looked for in.
struct StandingStore {
  const plan::Plan& plan;
  const catalog::Catalog& catalog;
  std::map<std::string, int> modules;  // of each zone's main kind, by zone
};

using Way = std::vector<plan::Patch>;

// Patch sets that each do what is wished, at most 16, the gentlest first; one that is empty means
// that it is so already. Errors: plan.unknown_reference when the store has no such zone or door;
// plan.bad_value when no plan does it; usage.unavailable for what an edit cannot change.
Result<std::vector<Way>> ways_to(const EditWish& wish, const StandingStore& store);

}  // namespace marketgen::intake
