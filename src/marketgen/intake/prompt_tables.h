// Tables in a prompt.
//
// | Department | m2 | Fixture  | Where      |
// |------------|----|----------|------------|
// | Dairy      | 55 | coolers  | back wall  |
//
// says "dairy: 55 m2; dairy with coolers; dairy back wall".
#pragma once
#include <string_view>
#include <vector>

#include "intake/lexicon.h"
#include "intake/tokens.h"

namespace marketgen::intake {

// The tokens of a prompt with every cell of its Markdown tables (a row of names, a row of dashes,
// then rows) as a sentence of its own, which names its row first. A number in a column headed by a
// unit of area has that unit; the names of columns, dashes and bars are left out. What is added
// has the span of the cell that it belongs to. `tokens` are those of `prompt`.
std::vector<Token> with_tables_spelled_out(std::string_view prompt,
                                           std::vector<Token> tokens,
                                           const Lexicon& lexicon);

}  // namespace marketgen::intake
