#include "io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"

namespace marketgen::io {
namespace {

constexpr std::size_t max_rows = 100'000, max_columns = 200;

// Of comma, semicolon and tab the one that the header has most of outside quotes.
char separator_of(std::string_view text) {
  std::array<int, 3> found{};
  constexpr std::string_view separators = ",;\t";
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '\n' || c == '\r')) break;
    const std::size_t which = separators.find(c);
    if (!quoted && which != std::string_view::npos) ++found[which];
  }
  return separators[static_cast<std::size_t>(std::ranges::max_element(found) - found.begin())];
}

std::string_view name_of(char separator) {
  return separator == ';' ? "semicolon" : separator == '\t' ? "tab" : "comma";
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& source)
      : rest_(text), source_(source), separator_(separator_of(text)) {}

  Result<std::vector<CsvRow>> read() {
    std::vector<CsvRow> rows;
    while (!rest_.empty()) {
      MARKETGEN_TRY(CsvRow row, read_row());
      if (row.fields.size() == 1 && row.fields[0].empty()) continue;
      if (!rows.empty() && row.fields.size() != rows[0].fields.size())
        return fault(
            row.line,
            fmt::format(
                "has {} fields, the header has {}", row.fields.size(), rows[0].fields.size()));
      rows.push_back(std::move(row));
      if (rows.size() > max_rows)
        return Error{"input.too_large", source_, "has more than 100,000 rows"};
    }
    return rows;
  }

 private:
  Error fault(int line, const std::string& what) const {
    return {"csv.syntax", fmt::format("{}:{}", source_, line), what};
  }

  bool takes(std::string_view text) {
    if (!rest_.starts_with(text)) return false;
    rest_.remove_prefix(text.size());
    return true;
  }

  bool ends_row() { return takes("\r\n") || takes("\n"); }

  Result<CsvRow> read_row() {
    CsvRow row{line_, {}};
    do {
      MARKETGEN_TRY(std::string field, takes("\"") ? read_quoted() : Result(read_plain()));
      row.fields.push_back(std::move(field));
      if (row.fields.size() > max_columns)
        return Error{"input.too_large", source_, "has more than 200 columns"};
    } while (takes({&separator_, 1}));
    if (!rest_.empty() && !ends_row())
      return fault(line_,
                   fmt::format("expected a {} or the end of the line; double the quotes within a "
                               "quoted field",
                               name_of(separator_)));
    ++line_;
    return row;
  }

  std::string read_plain() {
    const char ends[] = {separator_, '\r', '\n'};
    const std::size_t end = std::min(rest_.find_first_of({ends, sizeof ends}), rest_.size());
    std::string field(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return field;
  }

  Result<std::string> read_quoted() {
    const int first_line = line_;
    std::string field;
    while (true) {
      const std::size_t end = rest_.find('"');
      if (end == std::string_view::npos) return fault(first_line, "a quoted field never ends");
      field += rest_.substr(0, end);
      for (const char c : rest_.substr(0, end))
        line_ += c == '\n' ? 1 : 0;
      rest_.remove_prefix(end + 1);
      if (!takes("\"")) return field;
      field += '"';
    }
  }

  std::string_view rest_;
  const std::string& source_;
  char separator_;
  int line_ = 1;
};

}  // namespace

Result<std::vector<CsvRow>> parse_csv(std::string_view text, const std::string& source) {
  if (!is_utf8(text))
    return Error{"input.not_utf8", source, "the file is not UTF-8; save it as UTF-8"};
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return CsvReader(text, source).read();
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace marketgen::io
