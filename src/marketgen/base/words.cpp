#include "base/words.h"

#include <array>
#include <utility>

#include "base/text.h"

namespace marketgen {

std::string singular(std::string_view word) {
  // Plurals that the endings below would get wrong.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 7> irregular = {
      {{"loaves", "loaf"},
       {"leaves", "leaf"},
       {"knives", "knife"},
       {"halves", "half"},
       {"shoes", "shoe"},
       {"calves", "calf"},
       {"mice", "mouse"}}};
  const auto without = [&](std::size_t letters) {
    return std::string(word.substr(0, word.size() - letters));
  };
  for (const auto& [plural, one] : irregular) {
    if (word == plural) return std::string(one);
  }
  if (word.ends_with("ie") && word.size() > 4) return without(2) + "y";
  if (word.size() < 4 || !word.ends_with('s')) return std::string(word);
  if (word.ends_with("ss") || word.ends_with("us") || word.ends_with("is")) {
    return std::string(word);
  }
  if (word.ends_with("ies") && word.size() > 4) return without(3) + "y";
  for (const std::string_view ending : {"ches", "shes", "xes", "sses", "zes", "oes"}) {
    if (word.ends_with(ending)) return without(2);
  }
  return without(1);
}

std::string spaced_words(std::string_view text) {
  std::string words, word;
  const auto finish = [&] {
    if (word.ends_with("'s")) word.resize(word.size() - 2);
    if (!word.empty()) words += (words.empty() ? " " : "") + singular(word) + " ";
    word.clear();
  };
  for (const char c : lower_ascii(text)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '\'' ||
                        static_cast<unsigned char>(c) >= 0x80;
    if (letter)
      word += c;
    else
      finish();
  }
  finish();
  return words;
}

}  // namespace marketgen
