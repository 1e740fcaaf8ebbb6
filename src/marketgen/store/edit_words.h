// The words of an edit as patches for one store: of the ways to do each wish the first that breaks
// no hard rule.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/edit_words.h"
#include "plan/patch.h"
#include "store/store.h"

namespace marketgen::store {

struct SaidPatches {
  plan::PatchSet patches;
  std::vector<intake::UnparsedWord> unparsed;  // with what an edit cannot change
  std::vector<intake::Conflict> conflicts;
  std::vector<std::string> so_already;  // wishes that the store meets as it is
};

// Errors: of intake::understand_edit and ways_to; brief.not_understood when not one word asks for a
// change; layout.violation when every way breaks a hard rule.
Result<SaidPatches> patches_of_words(const Store& store,
                                     std::string_view words,
                                     const catalog::Catalog& catalog);

}  // namespace marketgen::store
