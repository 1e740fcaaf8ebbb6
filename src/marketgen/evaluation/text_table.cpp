#include "evaluation/text_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "io/csv.h"

namespace marketgen::evaluation {
namespace {

using Row = std::vector<std::string>;

std::size_t codepoints(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// One for each character of `special`, in its order.
std::string escaped(const std::string& text,
                    std::string_view special,
                    const std::vector<std::string_view>& written) {
  std::string out;
  for (const char c : text) {
    const std::size_t at = special.find(c);
    if (at == std::string_view::npos)
      out += c;
    else
      out += written[at];
  }
  return out;
}

std::string latex_text(const std::string& text) {
  return escaped(text,
                 "\\{}$&#%_^~",
                 {"\\textbackslash{}",
                  "\\{",
                  "\\}",
                  "\\$",
                  "\\&",
                  "\\#",
                  "\\%",
                  "\\_",
                  "\\textasciicircum{}",
                  "\\textasciitilde{}"});
}

std::string markdown_text(const std::string& text) {
  return escaped(text, "\\|*_`<", {"\\\\", "\\|", "\\*", "\\_", "\\`", "&lt;"});
}

Row each(const Row& row, std::string (*as)(const std::string&)) {
  Row out;
  for (const std::string& cell : row)
    out.push_back(as(cell));
  return out;
}

std::string joined(const Row& row, std::string_view between) {
  return fmt::format("{}", fmt::join(row, between));
}

std::string as_text(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::size_t width = codepoints(table.columns[column]);
    for (const Row& row : table.rows)
      width = std::max(width, codepoints(row[column]));
    widths.push_back(width);
  }
  const auto line = [&](const Row& row) {
    std::string out;
    for (std::size_t column = 0; column < row.size(); ++column) {
      out += row[column];
      if (column + 1 < row.size()) out.append(widths[column] - codepoints(row[column]) + 2, ' ');
    }
    return std::string(out, 0, out.find_last_not_of(' ') + 1) + "\n";
  };
  std::string out = line(table.columns);
  for (const Row& row : table.rows)
    out += line(row);
  for (const std::string& note : table.notes)
    out += note + "\n";
  return out;
}

std::string as_markdown(const TextTable& table) {
  const auto line = [](const Row& row) { return "| " + joined(row, " | ") + " |\n"; };
  std::string out = line(each(table.columns, markdown_text));
  out += line(Row(table.columns.size(), "---"));
  for (const Row& row : table.rows)
    out += line(each(row, markdown_text));
  for (const std::string& note : table.notes)
    out += "\n" + markdown_text(note) + "\n";
  return out;
}

std::string as_latex(const TextTable& table) {
  const auto line = [](const Row& row) { return joined(each(row, latex_text), " & ") + " \\\\\n"; };
  std::string out = fmt::format("\\begin{{tabular}}{{l{}}}\n\\toprule\n",
                                std::string(table.columns.size() - 1, 'c'));
  out += line(table.columns) + "\\midrule\n";
  for (const Row& row : table.rows)
    out += line(row);
  out += "\\bottomrule\n\\end{tabular}\n";
  for (const std::string& note : table.notes)
    out += "% " + note + "\n";
  return out;
}

std::string as_csv(const TextTable& table) {
  std::string out = joined(each(table.columns, io::csv_field), ",") + "\r\n";
  for (const Row& row : table.rows)
    out += joined(each(row, io::csv_field), ",") + "\r\n";
  return out;
}

}  // namespace

std::string written(const TextTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return as_text(table);
    case TableFormat::markdown:
      return as_markdown(table);
    case TableFormat::latex:
      return as_latex(table);
    case TableFormat::csv:
      return as_csv(table);
  }
  return {};
}

}  // namespace marketgen::evaluation
