// Comma-separated values as in RFC 4180: quoted fields, doubled quotes, LF or CRLF. Spreadsheets of
// countries that write 1,99 put semicolons or tabs between fields: the header says which.
//
// Not Debian's libcsv: it is quicker (60 instead of 78 ms for 100,000 rows) but does not say on
// which line a row begins, does not see rows of the wrong length, drops blanks around fields and
// names a fault by its byte alone. See docs/architecture.md, "Why our own".
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::io {

struct CsvRow {
  int line = 1;  // of the file, where the row begins
  std::vector<std::string> fields;
};

// Every row, the header first; lines with nothing on them are passed over. A byte-order mark is
// dropped. Each row must have as many fields as the first. Errors: csv.syntax, input.not_utf8,
// input.too_large (more than 100,000 rows or 200 columns).
Result<std::vector<CsvRow>> parse_csv(std::string_view text, const std::string& source);

// A field as it stands in a row: quoted when a comma, quote or line break is in it.
std::string csv_field(const std::string& text);

}  // namespace marketgen::io
