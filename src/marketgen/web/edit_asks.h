// What a page that edits a store sends: bodies of POST edit/VERB. docs/viewer.md, "Editing".
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "plan/patch.h"

namespace marketgen::web {

constexpr FieldRules token_rules = at_most_bytes(64);

// begin, beat, end, undo, redo. begin: the token that the page had before, if any.
struct EditorAsk {
  std::string token;
  static constexpr auto fields =
      field_list(field("token", &EditorAsk::token, "of who edits", token_rules));
};

// patches, preview
struct PatchesAsk {
  std::string token;
  std::vector<plan::Patch> patches;
  static constexpr auto fields =
      field_list(field("token", &PatchesAsk::token, "of who edits", token_rules),
                 field("patches",
                       &PatchesAsk::patches,
                       "one operation each, carried out in this order",
                       required(),
                       at_most_items(plan::max_patches)));
};

// say
struct WordsAsk {
  std::string token, words;
  static constexpr auto fields = field_list(
      field("token", &WordsAsk::token, "of who edits", token_rules),
      field("words", &WordsAsk::words, "what shall change", required(), at_most_bytes(20000)));
};

// save
struct SaveAsk {
  std::string token, name;
  static constexpr auto fields =
      field_list(field("token", &SaveAsk::token, "of who edits", token_rules),
                 field("name",
                       &SaveAsk::name,
                       "of the new folder, beside the store's",
                       required(),
                       at_most_bytes(100)));
};

}  // namespace marketgen::web
