// What many generated stores are worth, beside what others have published of their generators:
// market-generator/1.
//
// Every figure is of the stores' own reports (report.json; audit/audit.h says how each is
// measured). Published ones are of other scenes, mostly rooms of homes, and measured by their
// authors in their own way: they stand beside ours as an order of magnitude.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "evaluation/published.h"
#include "evaluation/text_table.h"

namespace marketgen::evaluation {

struct GeneratorRow {
  std::string metric, what;
  int stores = 0;  // that have it
  double median = 0, worst = 0;
  std::vector<PublishedGenerator> published = {};
  static constexpr auto fields =
      field_list(field("metric", &GeneratorRow::metric, "its name"),
                 field("what", &GeneratorRow::what, "what it says, and its unit"),
                 field("stores", &GeneratorRow::stores, "that were measured"),
                 field("median", &GeneratorRow::median, "of the stores"),
                 field("worst", &GeneratorRow::worst, "of the stores"),
                 field("published", &GeneratorRow::published, "of others"));
};

struct GeneratorTable {
  std::string schema = "market-generator/1";
  int stores = 0;
  std::vector<std::string> versions;  // of the program that made them
  std::vector<GeneratorRow> rows;
  std::vector<robots::SourceRow> sources;
  static constexpr auto fields = field_list(
      field("schema", &GeneratorTable::schema, "schema tag", constant("market-generator/1")),
      field("stores", &GeneratorTable::stores, "that were looked at"),
      field("versions", &GeneratorTable::versions, "of the program that made them"),
      field("rows", &GeneratorTable::rows, "a metric each; those that no store has are left out"),
      field("sources", &GeneratorTable::sources, "of published figures"));
};

// Of store folders. Errors: usage.bad_flag for none, or the same folder twice; those of
// read_manifest and read_report.
Result<GeneratorTable> generator_table(const std::vector<std::string>& folders,
                                       const Published& published);

TextTable text_of(const GeneratorTable& table);

}  // namespace marketgen::evaluation
