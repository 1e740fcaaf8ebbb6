#include "evaluation/generator_table.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "evaluation/table_remarks.h"
#include "store/store.h"

namespace marketgen::evaluation {
namespace {

struct MadeStore {
  store::Manifest manifest;
  store::StoreReport report;
};

// How the stores' values become one: the median, and the greatest or least as the worst; or, of yes
// and no, the share of stores.
enum class Summed { lower_is_better, higher_is_better, share_of_stores };

struct Metric {
  std::string_view name, what;
  Summed summed;
  std::function<std::optional<double>(const MadeStore&)> of;
};

double seconds_of(const MadeStore& made) {
  double sum = 0;
  for (const store::StageTiming& timing : made.report.timing_s)
    sum += timing.seconds;
  return sum;
}

double hard_rules(const MadeStore& made) {
  return static_cast<double>(
      std::ranges::count(made.report.rules, layout::Severity::hard, &layout::Violation::severity));
}

const std::vector<Metric>& metrics() {
  using enum Summed;
  static const std::vector<Metric> all{
      {"COL",
       "share of near item pairs that interpenetrate by more than 1 mm",
       lower_is_better,
       [](const MadeStore& made) { return made.report.metrics.COL; }},
      {"OOB",
       "products outside their shelf or the room",
       lower_is_better,
       [](const MadeStore& made) { return static_cast<double>(made.report.metrics.OOB); }},
      {"STB",
       "share of products that drift less than 5 cm in physics (stores that `report` measured)",
       higher_is_better,
       [](const MadeStore& made) { return made.report.metrics.STB; }},
      {"NAV",
       "largest part of the free floor over all of it, robot of 0.42 m radius",
       higher_is_better,
       [](const MadeStore& made) { return made.report.metrics.NAV; }},
      {"one_floor",
       "share of stores whose free floor is in one part (NAV above 0.999)",
       share_of_stores,
       [](const MadeStore& made) { return made.report.metrics.NAV > 0.999 ? 1.0 : 0.0; }},
      {"REACH",
       "share of bays before which the robot can stand, come from the entrance",
       higher_is_better,
       [](const MadeStore& made) { return made.report.metrics.REACH; }},
      {"hard_rules", "broken hard rules of layout and scene", lower_is_better, hard_rules},
      {"prompt",
       "share of the prompt's wishes that the finished scene meets",
       higher_is_better,
       [](const MadeStore& made) { return made.report.metrics.prompt; }},
      {"products",
       "products in the store",
       higher_is_better,
       [](const MadeStore& made) { return static_cast<double>(made.manifest.counts.products); }},
      {"seconds",
       "wall time from words to files, pictures included if asked for",
       lower_is_better,
       seconds_of},
      {"peak_mb", "most memory in use, MB", lower_is_better, [](const MadeStore& made) {
         return made.report.peak_rss_mb;
       }}};
  return all;
}

// The mean of the two in the middle for an even number. Precondition: not empty.
double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

GeneratorRow row_of(const Metric& metric, const std::vector<MadeStore>& stores) {
  GeneratorRow row{std::string(metric.name), std::string(metric.what)};
  std::vector<double> values;
  for (const MadeStore& made : stores)
    if (const auto value = metric.of(made)) values.push_back(*value);
  row.stores = static_cast<int>(values.size());
  if (values.empty()) return row;
  if (metric.summed == Summed::share_of_stores) {
    row.median = row.worst =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    return row;
  }
  row.median = median_of(values);
  row.worst = metric.summed == Summed::lower_is_better ? std::ranges::max(values)
                                                       : std::ranges::min(values);
  return row;
}

Result<std::vector<MadeStore>> read_stores(const std::vector<std::string>& folders) {
  std::vector<MadeStore> stores;
  std::set<std::string> seen;
  for (const std::string& folder : folders) {
    if (!seen.insert(folder).second)
      return Error{"usage.bad_flag", folder, "is named twice: name each store once"};
    MadeStore made;
    MARKETGEN_TRY(made.manifest, store::read_manifest(folder));
    MARKETGEN_TRY(made.report, store::read_report(folder));
    stores.push_back(std::move(made));
  }
  return stores;
}

std::string published_cell(const std::vector<PublishedGenerator>& rows) {
  std::string cell;
  for (const PublishedGenerator& row : rows)
    cell += fmt::format(
        "{}{} {:.4g} [{}]", cell.empty() ? "" : ", ", row.generator, row.value, row.source);
  return cell;
}

}  // namespace

Result<GeneratorTable> generator_table(const std::vector<std::string>& folders,
                                       const Published& published) {
  if (folders.empty()) return Error{"usage.bad_flag", "folders", "name the folders of stores"};
  MARKETGEN_TRY(const std::vector<MadeStore> stores, read_stores(folders));
  GeneratorTable table;
  table.stores = static_cast<int>(stores.size());
  std::set<std::string> versions;
  for (const MadeStore& made : stores)
    versions.insert(made.manifest.versions.marketgen);
  table.versions.assign(versions.begin(), versions.end());
  for (const Metric& metric : metrics()) {
    GeneratorRow row = row_of(metric, stores);
    for (const PublishedGenerator& other : published.generators)
      if (other.metric == metric.name) row.published.push_back(other);
    if (row.stores > 0) table.rows.push_back(std::move(row));
  }
  std::vector<std::string> keys;
  for (const GeneratorRow& row : table.rows)
    for (const PublishedGenerator& other : row.published)
      keys.push_back(other.source);
  table.sources = cited_sources(published.sources, keys);
  return table;
}

TextTable text_of(const GeneratorTable& table) {
  TextTable text{{"metric", "median", "worst", "stores", "published of others"}, {}, {}};
  for (const GeneratorRow& row : table.rows) {
    text.rows.push_back({row.metric,
                         fmt::format("{:.4g}", row.median),
                         fmt::format("{:.4g}", row.worst),
                         std::to_string(row.stores),
                         published_cell(row.published)});
    text.notes.push_back(row.metric + ": " + row.what + ".");
  }
  for (const robots::SourceRow& source : table.sources)
    text.notes.push_back("[" + source.key + "] " + source.text);
  return text;
}

}  // namespace marketgen::evaluation
