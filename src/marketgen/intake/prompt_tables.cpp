#include "intake/prompt_tables.h"

#include <algorithm>
#include <utility>

#include "base/text.h"

namespace marketgen::intake {
namespace {

using Tokens = std::vector<Token>;
using Row = std::vector<Tokens>;  // cells

struct Line {
  int first = 0, last = 0;  // bytes
};

std::vector<Line> lines_of(std::string_view prompt) {
  std::vector<Line> lines;
  std::size_t first = 0;
  while (first <= prompt.size()) {
    const std::size_t end = std::min(prompt.find('\n', first), prompt.size());
    lines.push_back({static_cast<int>(first), static_cast<int>(end)});
    first = end + 1;
  }
  return lines;
}

std::string_view text_of(std::string_view prompt, const Line& line) {
  return trimmed(prompt.substr(static_cast<std::size_t>(line.first),
                               static_cast<std::size_t>(line.last - line.first)));
}

bool is_row(std::string_view text) {
  return text.size() > 2 && text.front() == '|' && text.back() == '|';
}

bool is_rule(std::string_view text) {
  return is_row(text) && text.find('-') != std::string_view::npos &&
         text.find_first_not_of("|-: ") == std::string_view::npos;
}

bool says_something(const Tokens& cell) {
  return std::ranges::any_of(cell, [](const Token& token) {
    return token.kind == TokenKind::word || token.kind == TokenKind::number;
  });
}

Row row_of(const Tokens& tokens, const Line& line) {
  Row cells;
  for (const Token& token : tokens) {
    if (token.span[0] < line.first || token.span[0] >= line.last) continue;
    if (token.text == "|")
      cells.emplace_back();
    else if (!cells.empty() && token.kind != TokenKind::sentence_end)
      cells.back().push_back(token);
  }
  if (!cells.empty()) cells.pop_back();  // past the last bar
  return cells;
}

bool has_sense(const Tokens& cell, Sense sense, const Lexicon& lexicon) {
  for (std::size_t at = 0; at < cell.size(); ++at) {
    const auto match = lexicon.longest_match(cell, at);
    if (match && match->row->sense == sense) return true;
  }
  return false;
}

// The unit that heads a column, as words.
Tokens unit_in(const Tokens& head, const Lexicon& lexicon) {
  for (std::size_t at = 0; at < head.size(); ++at) {
    const auto match = lexicon.longest_match(head, at);
    const bool area = match && match->row->sense == Sense::unit && match->row->value == "area";
    if (area)
      return {head.begin() + static_cast<std::ptrdiff_t>(at),
              head.begin() + static_cast<std::ptrdiff_t>(at + match->tokens)};
  }
  return {};
}

Token added(TokenKind kind, const char* text, IntRange span) {
  Token token;
  token.kind = kind;
  token.text = token.stem = text;
  token.span = span;
  return token;
}

// "dairy : 55 m2 .", "dairy with coolers ."
void add_cell(Tokens& out,
              const Tokens& name,
              const Tokens& cell,
              const Tokens& head,
              const Lexicon& lexicon) {
  const IntRange span = cell.front().span;
  out.insert(out.end(), name.begin(), name.end());
  const bool numbers =
      std::ranges::all_of(cell, [](const Token& token) { return token.kind == TokenKind::number; });
  const bool placed =
      has_sense(cell, Sense::relation, lexicon) || has_sense(cell, Sense::place, lexicon);
  const bool furnished = !placed && has_sense(cell, Sense::fixture, lexicon) && !name.front().han;
  if (numbers) out.push_back(added(TokenKind::symbol, ":", span));
  if (furnished) out.push_back(added(TokenKind::word, "with", span));
  out.insert(out.end(), cell.begin(), cell.end());
  for (Token unit : numbers ? unit_in(head, lexicon) : Tokens{}) {
    unit.span = cell.back().span;
    out.push_back(std::move(unit));
  }
  out.push_back(added(TokenKind::sentence_end, ".", span));
}

Tokens spelled_out(const std::vector<Row>& rows, const Lexicon& lexicon) {
  Tokens out;
  const Row& heads = rows.front();
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Row& row = rows[r];
    if (row.empty() || !says_something(row.front())) continue;
    bool more = false;
    for (std::size_t c = 1; c < row.size(); ++c) {
      if (!says_something(row[c])) continue;
      add_cell(out, row.front(), row[c], c < heads.size() ? heads[c] : Tokens{}, lexicon);
      more = true;
    }
    if (more) continue;
    out.insert(out.end(), row.front().begin(), row.front().end());
    out.push_back(added(TokenKind::sentence_end, ".", row.front().back().span));
  }
  return out;
}

}  // namespace

std::vector<Token> with_tables_spelled_out(std::string_view prompt,
                                           std::vector<Token> tokens,
                                           const Lexicon& lexicon) {
  const std::vector<Line> lines = lines_of(prompt);
  for (std::size_t at = lines.size(); at-- > 1;) {
    if (!is_rule(text_of(prompt, lines[at])) || !is_row(text_of(prompt, lines[at - 1]))) continue;
    std::vector<Row> rows = {row_of(tokens, lines[at - 1])};
    std::size_t last = at + 1;
    for (; last < lines.size() && is_row(text_of(prompt, lines[last])); ++last)
      rows.push_back(row_of(tokens, lines[last]));
    const int start = lines[at - 1].first, end = lines[last - 1].last;
    const auto first =
        std::ranges::find_if(tokens, [&](const Token& token) { return token.span[0] >= start; });
    const auto past =
        std::find_if(first, tokens.end(), [&](const Token& token) { return token.span[0] >= end; });
    Tokens table = {added(TokenKind::sentence_end, ".", {start, start})};
    const Tokens cells = spelled_out(rows, lexicon);
    table.insert(table.end(), cells.begin(), cells.end());
    tokens.insert(tokens.erase(first, past), table.begin(), table.end());
  }
  return tokens;
}

}  // namespace marketgen::intake
