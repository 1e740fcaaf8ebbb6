// Clauses of a prompt, and the words in them that say how they stand to what was said before.
#pragma once
#include <span>
#include <string_view>

#include "base/fields.h"

namespace marketgen::intake {

// The words from one comma or full stop (no colon) to the next that hold `span`, without blanks
// around them. All ranges: bytes of the prompt.
IntRange clause_of(std::string_view prompt, IntRange span);

// True when no full stop, line break or their like stands between the two.
bool in_one_sentence(std::string_view prompt, IntRange a, IntRange b);

std::string_view text_at(std::string_view prompt, IntRange span);

// Whether the lower-case `word` stands in the text, as a whole word and in any case; Chinese has no
// gaps between words.
bool has_word(std::string_view text, std::string_view word);

// Whether any of the words does.
bool has_any_word(std::string_view text, std::span<const std::string_view> words);

// "My first sketch had ten aisles", "instead of six lanes": what stands at `span` is no longer
// wanted.
bool is_outdated(std::string_view prompt, IntRange span);

// "No carpet", "not like the hospital": a material, colour or style that is not wanted.
bool is_denied(std::string_view prompt, IntRange span);

// "Now eight instead", "搞错了，是右墙": what stands at `later` takes the place of what was said at
// `earlier`.
bool takes_its_place(std::string_view prompt, IntRange earlier, IntRange later);

// "The entrance moves from the east wall to the south wall": `later` is the whole of it.
bool is_moved(std::string_view prompt, IntRange earlier, IntRange later);

// "Another entrance", "东墙再开一个": one more of the same.
bool is_one_more(std::string_view prompt, IntRange span);

// "Only one", "exactly", "just": the number is no more than that.
bool is_no_more(std::string_view prompt, IntRange span);

// "Otherwise grey tile": for the case that what was said before cannot be.
bool is_fallback(std::string_view prompt, IntRange span);

}  // namespace marketgen::intake
