// Words that were not understood, as commands print them.
#pragma once
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "intake/brief.h"
#include "say.h"

namespace marketgen::app {

inline void say_unparsed(const std::vector<intake::UnparsedWord>& unparsed) {
  if (unparsed.empty()) return;
  std::vector<std::string> words;
  for (const intake::UnparsedWord& word : unparsed)
    words.push_back("\"" + word.text + "\"");
  say("unparsed    {}\n", fmt::join(words, ", "));
}

}  // namespace marketgen::app
