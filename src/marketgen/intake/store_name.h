// The store's name in a prompt: quoted, or after "called" and the like.
#pragma once
#include <optional>
#include <vector>

#include "intake/lexicon.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Finds the name and takes its tokens out of the list, so that "called Green Bakery" asks for no
// bakery.
std::optional<StoreName> take_store_name(std::string_view prompt,
                                         std::vector<Token>& tokens,
                                         const Lexicon& lexicon);

}  // namespace marketgen::intake
