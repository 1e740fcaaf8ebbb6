// English words.
#pragma once
#include <string>
#include <string_view>

namespace marketgen {

// The singular of an English word in lower case, by its ending: "berries" -> "berry", "dishes" ->
// "dish", "loaves" -> "loaf". What ends in "ie" ends in "y", so that "cookie" and "cookies" are one
// word.
std::string singular(std::string_view word);

// The words of a text, lower case and singular, each between spaces, so that what one says stands
// in another where its words do: " tomato " in " cherry tomato ". Empty when there are none.
std::string spaced_words(std::string_view text);

}  // namespace marketgen
