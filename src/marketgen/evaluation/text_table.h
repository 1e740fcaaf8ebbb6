// A table of texts, and how it is written for people and for papers.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace marketgen::evaluation {

enum class TableFormat { text, markdown, latex, csv };
constexpr std::array<std::string_view, 4> names_of(TableFormat) {
  return {"text", "markdown", "latex", "csv"};
}

struct TextTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as `columns`
  std::vector<std::string> notes;              // a line each, under the table; not in CSV
};

// UTF-8, with what the format would take for its own marks escaped. LaTeX: a `tabular` with the
// rules of booktabs; CSV: RFC 4180.
std::string written(const TextTable& table, TableFormat format);

}  // namespace marketgen::evaluation
