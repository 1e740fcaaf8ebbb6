// Wishes that cannot both hold, and which of them does.
#pragma once
#include <string_view>

#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Takes out wishes said twice and, of two that exclude each other (intake/exclusions.h), the weaker
// one: a must wins over a prefer, what was said later over what was said before. Each loss becomes
// a Conflict, which quotes the clauses of `prompt` that the two stand in. Names of the shop, words
// for its size, rows and amounts of goods are settled like wishes. No conflict, but taken out: what
// a correction takes back, parts that add up to a total, a word that a number makes more exact.
void settle_conflicts(Understanding& understanding, std::string_view prompt, plan::Wall entrance);

// Flags beat text: wishes about size, profile and style that differ from the brief's flags are
// dropped.
void apply_flags(const Brief& brief, Understanding& understanding);

// Whether the conflict is one between two pieces of the prompt that both must hold, which nobody
// but the writer can decide.
bool is_contradiction(const Conflict& conflict);

}  // namespace marketgen::intake
