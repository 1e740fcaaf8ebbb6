#include "evaluation/shapes_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "catalog/container_nouns.h"
#include "environments/policy_name.h"
#include "episodes/told_attribute.h"
#include "evaluation/goods_rows.h"
#include "evaluation/same_runs.h"
#include "evaluation/table_remarks.h"

namespace marketgen::evaluation {
namespace {

constexpr std::array all_shapes{
    PackShape::bottles, PackShape::cans, PackShape::boxes, PackShape::bags};

double published_share(const PublishedShapes& row, PackShape shape) {
  switch (shape) {
    case PackShape::bottles:
      return row.bottles;
    case PackShape::cans:
      return row.cans;
    case PackShape::boxes:
      return row.boxes;
    case PackShape::bags:
      return row.bags;
  }
  return 0;
}

ShapesRow published_row(const PublishedShapes& published) {
  ShapesRow row{published.place, "", published.source};
  for (const PackShape shape : all_shapes)
    row.shapes.push_back({shape, published.tries, {published_share(published, shape)}});
  return row;
}

// Goods that are none of the four have an empty name.
std::string shape_name(const catalog::Product& product) {
  const auto shape = pack_shape(product.archetype);
  return shape ? std::string(name_of(*shape)) : std::string();
}

ShapesRow measured_row(const std::string& policy,
                       const std::vector<const FinishedRun*>& runs,
                       const catalog::Catalog& catalog) {
  ShapesRow row{policy};
  std::vector<episodes::EpisodeResult> results;
  for (const FinishedRun* run : runs) {
    results.insert(results.end(), run->results.begin(), run->results.end());
    const std::string commit = run->record.commit();
    if (row.commit.find(commit) == std::string::npos)
      row.commit += (row.commit.empty() ? "" : ", ") + commit;
  }
  const auto by_shape = goods_rows(results, catalog, shape_name);
  for (const PackShape shape : all_shapes) {
    const auto goods = by_shape.find(std::string(name_of(shape)));
    if (goods == by_shape.end()) continue;
    row.shapes.push_back(
        {shape, goods->second.asked, figure_of(estimate_of(goods->second.scores))});
  }
  return row;
}

void add_agreement(ShapesRow& row, const std::vector<PublishedShapes>& published) {
  for (const PublishedShapes& other : published) {
    if (row.who == other.place) continue;
    std::vector<double> truth, measure;
    for (const ShapeFigures& figures : row.shapes) {
      truth.push_back(published_share(other, figures.shape));
      measure.push_back(figures.share.value);
    }
    row.agreement.push_back({other.place,
                             static_cast<int>(truth.size()),
                             pearson(truth, measure),
                             mean_max_rank_violation(truth, measure)});
  }
}

// ---- As text ----

std::string cell(const ShapesRow& row, PackShape shape) {
  const auto at = std::ranges::find(row.shapes, shape, &ShapeFigures::shape);
  if (at == row.shapes.end()) return "";
  return fmt::format("{} of {}", percent(at->share), at->tries);
}

bool is_of_a_floor(const ShapesRow& row) {
  return row.source.empty() && environments::is_floor(row.who);
}

std::string agreement_note(const ShapesRow& row, const ShapesAgreement& agreement) {
  return fmt::format(
      "{} and {}, over {} shapes: Pearson {}, MMRV {:.3f}",
      row.who,
      agreement.with,
      agreement.shapes,
      agreement.pearson ? fmt::format("{:.2f}", *agreement.pearson) : std::string("undefined"),
      agreement.mmrv);
}

}  // namespace

std::optional<PackShape> pack_shape(std::string_view archetype) {
  static const std::map<std::string_view, PackShape> nouns{{"bottle", PackShape::bottles},
                                                           {"can", PackShape::cans},
                                                           {"tin", PackShape::cans},
                                                           {"box", PackShape::boxes},
                                                           {"carton", PackShape::boxes},
                                                           {"bag", PackShape::bags},
                                                           {"pouch", PackShape::bags}};
  for (const catalog::ContainerNoun& container : catalog::container_nouns(archetype))
    if (const auto shape = nouns.find(container.noun); shape != nouns.end()) return shape->second;
  return std::nullopt;
}

std::optional<double> pearson(std::span<const double> a, std::span<const double> b) {
  const auto n = static_cast<double>(a.size());
  if (a.size() < 2) return std::nullopt;
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  if (aa == 0 || bb == 0) return std::nullopt;
  return ab / std::sqrt(aa * bb);
}

double mean_max_rank_violation(std::span<const double> truth, std::span<const double> measure) {
  if (truth.empty()) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    double worst = 0;
    for (std::size_t k = 0; k < truth.size(); ++k)
      if ((measure[i] < measure[k]) != (truth[i] < truth[k]))
        worst = std::max(worst, std::abs(truth[i] - truth[k]));
    sum += worst;
  }
  return sum / static_cast<double>(truth.size());
}

Result<ShapesTable> shapes_table(const std::vector<FinishedRun>& runs,
                                 const catalog::Catalog& catalog,
                                 const Published& published) {
  if (runs.empty()) return Error{"usage.bad_flag", "results", "name a folder of results"};
  MARKETGEN_CHECK(check_same_world(runs));
  std::map<std::string, std::vector<const FinishedRun*>> policies;
  for (const FinishedRun& run : runs) {
    MARKETGEN_CHECK(check_complete(run));
    policies[run.record.policy].push_back(&run);
  }
  ShapesTable table;
  table.version = runs.front().record.version;
  table.realism = runs.front().record.realism;
  for (const auto& [policy, of_policy] : policies)
    table.rows.push_back(measured_row(policy, of_policy, catalog));
  for (const PublishedShapes& row : published.shapes)
    table.rows.push_back(published_row(row));
  for (ShapesRow& row : table.rows)
    add_agreement(row, published.shapes);
  std::vector<std::string> keys;
  for (const ShapesRow& row : table.rows)
    keys.push_back(row.source);
  table.sources = cited_sources(published.sources, keys);
  return table;
}

TextTable text_of(const ShapesTable& table) {
  TextTable text{{"who"}, {}, {}};
  for (const PackShape shape : all_shapes)
    text.columns.push_back(fmt::format("{} %", name_of(shape)));
  for (const ShapesRow& row : table.rows) {
    std::vector<std::string> cells{row.who + (row.source.empty() ? "" : " [" + row.source + "]")};
    for (const PackShape shape : all_shapes)
      cells.push_back(cell(row, shape));
    text.rows.push_back(std::move(cells));
  }
  text.notes.push_back(
      fmt::format("In place at the end, of those asked for; 95 % intervals over stores; version "
                  "{}, realism {}. "
                  "Published: grasps that held, of those tried.",
                  table.version,
                  table.realism));
  for (std::string& remark :
       table_remarks(std::ranges::any_of(table.rows, is_of_a_floor), table.realism))
    text.notes.push_back(std::move(remark));
  for (const ShapesRow& row : table.rows) {
    if (!row.commit.empty()) text.notes.push_back(row.who + ": " + row.commit);
    for (const ShapesAgreement& agreement : row.agreement)
      text.notes.push_back(agreement_note(row, agreement));
  }
  for (const robots::SourceRow& source : table.sources)
    text.notes.push_back("[" + source.key + "] " + source.text);
  return text;
}

}  // namespace marketgen::evaluation
