// The store's name in a prompt: quoted, or after "called" and the like.
#pragma once
#include <vector>

#include "intake/lexicon.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Finds the name and takes its tokens out of the list, so that "called Green Bakery" asks for no
// bakery. More than one where the prompt names the shop again: the words for that must stand before
// each, and no zone or goods before them ("a café called Rosa").
std::vector<StoreName> take_store_names(std::string_view prompt,
                                        std::vector<Token>& tokens,
                                        const Lexicon& lexicon);

}  // namespace marketgen::intake
