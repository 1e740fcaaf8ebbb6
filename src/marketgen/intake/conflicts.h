// Wishes that cannot both hold, and which of them does.
#pragma once
#include <string_view>

#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Takes out wishes said twice and, of two that contradict each other, the weaker one: a must wins
// over a prefer, what was said later over what was said before. Each loss becomes a Conflict, which
// quotes the clauses of `prompt` that the two stand in.
void settle_conflicts(Understanding& understanding, std::string_view prompt);

// Flags beat text: wishes about size, profile and style that differ from the brief's flags are
// dropped.
void apply_flags(const Brief& brief, Understanding& understanding);

}  // namespace marketgen::intake
