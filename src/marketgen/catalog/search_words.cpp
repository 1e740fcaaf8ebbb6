#include "catalog/search_words.h"

#include "base/text.h"

namespace marketgen::catalog {
namespace {

enum class Glyph { letter, chinese, separator };

struct Character {
  std::string_view bytes;
  Glyph glyph = Glyph::separator;
};

Glyph glyph_of(char32_t code) {
  const auto within = [code](char32_t low, char32_t high) { return code >= low && code <= high; };
  if (within('0', '9') || within('a', 'z') || within('A', 'Z')) return Glyph::letter;
  if (code < 0xC0) return Glyph::separator;  // ASCII and Latin-1 punctuation
  if (within(0x3400, 0x9FFF) || within(0xF900, 0xFAFF) || within(0x20000, 0x3FFFF))
    return Glyph::chinese;  // unified ideographs and their extensions
  const bool punctuation =
      within(0x2000, 0x2BFF) || within(0x3000, 0x303F) || within(0xFF00, 0xFF65);
  return punctuation ? Glyph::separator : Glyph::letter;
}

// The character at `at` of a text in UTF-8; a byte that begins none is a separator.
Character character_at(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t length = lead < 0x80 ? 1 : (lead < 0xE0 ? 2 : (lead < 0xF0 ? 3 : 4));
  if ((lead >= 0x80 && lead < 0xC0) || at + length > text.size()) return {text.substr(at, 1)};
  char32_t code = length == 1 ? lead : lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
    code = (code << 6) | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
  return {text.substr(at, length), glyph_of(code)};
}

void add_pairs(std::vector<SearchWord>& words) {
  const std::vector<std::string> run = words.back().tokens;
  if (!words.back().chinese || run.size() <= 2) return;
  for (std::size_t i = 0; i + 1 < run.size(); ++i)
    words.push_back({{run[i], run[i + 1]}, true});
}

std::string joined(const std::vector<std::string>& tokens, std::string_view between) {
  std::string text;
  for (const std::string& token : tokens)
    text += (text.empty() ? "" : std::string(between)) + token;
  return text;
}

}  // namespace

std::string SearchWord::text() const {
  return joined(tokens, "");
}

std::vector<SearchWord> search_words_of(std::string_view text) {
  const std::string lower = lower_ascii(text);
  std::vector<SearchWord> words;
  Glyph last = Glyph::separator;
  for (std::size_t at = 0; at < lower.size();) {
    const Character next = character_at(lower, at);
    if (next.glyph != last && last != Glyph::separator) add_pairs(words);
    if (next.glyph != last && next.glyph != Glyph::separator)
      words.push_back({{}, next.glyph == Glyph::chinese});
    const bool goes_on = next.glyph == Glyph::letter && last == Glyph::letter;
    if (goes_on)
      words.back().tokens.back() += next.bytes;
    else if (next.glyph != Glyph::separator)
      words.back().tokens.emplace_back(next.bytes);
    last = next.glyph;
    at += next.bytes.size();
  }
  if (last != Glyph::separator) add_pairs(words);
  return words;
}

std::string with_spaced_characters(std::string_view text) {
  std::string spaced;
  for (std::size_t at = 0; at < text.size();) {
    const Character next = character_at(text, at);
    const bool chinese = next.glyph == Glyph::chinese;
    spaced += (chinese ? " " : "") + std::string(next.bytes) + (chinese ? " " : "");
    at += next.bytes.size();
  }
  return spaced;
}

std::string phrase_expression(const std::vector<std::string>& tokens) {
  return "\"" + joined(tokens, " ") + "\"";
}

std::string all_expression(const std::vector<std::string>& tokens) {
  return "\"" + joined(tokens, "\" AND \"") + "\"";
}

}  // namespace marketgen::catalog
