#include "base/safe_line.h"

#include <vector>

#include <fmt/format.h>

#include "base/text.h"

namespace marketgen {
namespace {

// Length of the well-formed sequence that starts at `at`; 0 where none does.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  constexpr std::size_t longest = 4;
  for (std::size_t length = 1; length <= longest && at + length <= text.size(); ++length)
    if (is_utf8(text.substr(at, length))) return length;
  return 0;
}

char32_t code_point(std::string_view sequence) {
  const auto byte = [&](std::size_t i) {
    return static_cast<char32_t>(static_cast<unsigned char>(sequence[i]));
  };
  if (sequence.size() == 1) return byte(0);
  char32_t code = byte(0) & (0x7FU >> sequence.size());
  for (std::size_t i = 1; i < sequence.size(); ++i)
    code = (code << 6U) | (byte(i) & 0x3FU);
  return code;
}

// Control characters, line and paragraph separators, marks and overrides of the direction of
// writing, invisible joiners, the byte order mark, tags.
bool moves_or_hides(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0xAD || code == 0x61C ||
         code == 0x200B || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF ||
         (code >= 0xE0000 && code <= 0xE007F);
}

std::string escaped(char32_t code) {
  switch (code) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return code < 0x100 ? fmt::format("\\x{:02x}", static_cast<unsigned>(code))
                          : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
  }
}

// The characters as they are shown, one entry each.
std::vector<std::string> shown_characters(std::string_view text) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length == 0) {
      shown.push_back(fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i++])));
      continue;
    }
    const std::string_view sequence = text.substr(i, length);
    const char32_t code = code_point(sequence);
    shown.push_back(moves_or_hides(code) ? escaped(code) : std::string(sequence));
    i += length;
  }
  return shown;
}

}  // namespace

std::string safe_line(std::string_view text, std::size_t max_characters) {
  const std::vector<std::string> shown = shown_characters(text);
  const std::size_t tail = max_characters / 4, head = max_characters - tail;
  const bool whole = shown.size() <= max_characters;
  std::string line;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!whole && i == head) {
      i = shown.size() - tail;
      line += fmt::format("[... {} characters ...]", i - head);
    }
    line += shown[i];
  }
  return line;
}

}  // namespace marketgen
