#include "evaluation/run_tables.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/text.h"
#include "evaluation/goods_rows.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/store_bootstrap.h"

namespace marketgen::evaluation {
namespace {

struct LedgerLine {
  std::string_view name;
  int episodes::SideEffects::*count;
};
constexpr std::array<LedgerLine, 10> ledger_lines{
    {{"contacts below 10 N", &episodes::SideEffects::light_contacts},
     {"contacts of 10 to 50 N", &episodes::SideEffects::firm_contacts},
     {"contacts above 50 N", &episodes::SideEffects::hard_contacts},
     {"items toppled", &episodes::SideEffects::toppled},
     {"items dropped", &episodes::SideEffects::dropped},
     {"items displaced by more than 2 cm", &episodes::SideEffects::displaced},
     {"items strayed", &episodes::SideEffects::strayed},
     {"wrong items in the area", &episodes::SideEffects::wrong_items},
     {"base drove into something", &episodes::SideEffects::base_collisions},
     {"protective stops", &episodes::SideEffects::protective_stops}}};

std::string ledger_row(std::string_view name, const std::vector<int>& counts) {
  int sum = 0, in = 0, most = 0;
  for (const int count : counts) {
    sum += count;
    in += count > 0 ? 1 : 0;
    most = std::max(most, count);
  }
  return fmt::format(
      "<tr><td>{}</td><td class=\"value\">{}</td><td>{}</td><td>{}</td></tr>", name, sum, in, most);
}

// ---- Time lines; SVG user units are CSS pixels. ----
constexpr int name_px = 260, line_width_px = 700, unit_px = 18;
constexpr std::size_t lines_that_are_read = 100;

// Of one line: lower where there are so many that names are not read.
struct LineSize {
  int height_px, font_px;
};
LineSize line_size(std::size_t lines) {
  return lines <= lines_that_are_read ? LineSize{16, 10} : LineSize{7, 6};
}

std::string_view class_of(const episodes::EpisodeResult& result) {
  if (!result.error.empty()) return "back";
  if (result.success_strict) return "good";
  return result.hits > 0 ? "warn" : "bad";
}

std::string bar_of(const episodes::EpisodeResult& result, double px_a_s, int top, LineSize size) {
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text><rect x=\"{}\" y=\"{}\" "
      "width=\"{:.1f}\" height=\"{}\" class=\"{}\" fill=\"currentColor\"><title>{} {} {:.1f} s, "
      "{} of {}</title></rect>",
      name_px - 6,
      top + size.height_px - (size.height_px - size.font_px) / 2 - 2,
      escaped_markup(result.episode),
      name_px,
      top + 1,
      px_a_s * result.simulated_s,
      size.height_px - 2,
      class_of(result),
      escaped_markup(result.episode),
      name_of(result.failure),
      result.simulated_s,
      result.hits,
      result.asked);
}

// A mark for each goal that was in place at the end, where it came to lie there.
std::string marks_of(const episodes::EpisodeResult& result, double px_a_s, int top, LineSize size) {
  std::string marks;
  for (const episodes::GoalOutcome& goal : result.goals) {
    if (goal.reached == 0 || goal.rested_s == 0) continue;  // files of before do not say when
    const double since_s = result.simulated_s - goal.rested_s;
    marks += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"3\" height=\"{}\" class=\"mark\"><title>{} {:.1f} "
        "s, {} of {}</title></rect>",
        name_px + px_a_s * since_s,
        top,
        size.height_px,
        escaped_markup(goal.sku),
        since_s,
        goal.reached,
        goal.count);
  }
  return marks;
}

// ---- Goods. ----
std::string goods_table(std::string_view title, const std::map<std::string, GoodsRow>& rows) {
  std::string out = fmt::format(
      "<table><tr><th>{}</th><th>in place, percent</th><th>of "
      "goals</th><th>SKUs</th></tr>",
      title);
  for (const auto& [name, row] : rows) {
    const Estimate estimate = estimate_of(row.scores);
    out +=
        fmt::format("<tr><td>{}</td><td class=\"value\">{}</td><td>{} of {}</td><td>{}</td></tr>",
                    escaped_markup(name),
                    percent_with_interval(estimate.value, estimate.low, estimate.high),
                    row.reached,
                    row.asked,
                    row.skus.size());
  }
  return out + "</table>";
}

}  // namespace

std::string ledger_table(const std::vector<episodes::EpisodeResult>& results) {
  std::string out =
      "<h2>Side effects</h2><table><tr><th>what</th><th>in all</th><th>in how many episodes</th>"
      "<th>most in one</th></tr>";
  for (const LedgerLine& line : ledger_lines) {
    std::vector<int> counts;
    for (const episodes::EpisodeResult& result : results)
      counts.push_back(result.side_effects.*line.count);
    out += ledger_row(line.name, counts);
  }
  std::vector<int> doors;  // of episodes that have some
  for (const episodes::EpisodeResult& result : results)
    if (result.side_effects.doors_open) doors.push_back(*result.side_effects.doors_open);
  if (!doors.empty()) out += ledger_row("doors left open", doors);
  double hardest_n = 0;
  int void_ones = 0;
  for (const episodes::EpisodeResult& result : results) {
    hardest_n = std::max(hardest_n, result.side_effects.hardest_n);
    void_ones += result.is_void ? 1 : 0;
  }
  return out + fmt::format(
                   "</table><p class=\"sub\">Greatest force {:.0f} N; {} episodes void. Each "
                   "contact counts once, by the greatest force on it.</p>",
                   hardest_n,
                   void_ones);
}

std::string time_lines(const std::vector<episodes::EpisodeResult>& results) {
  double longest_s = 1;
  for (const episodes::EpisodeResult& result : results)
    longest_s = std::max(longest_s, result.simulated_s);
  const LineSize size = line_size(results.size());
  const auto height = static_cast<int>(results.size()) * size.height_px + unit_px;
  std::string svg = fmt::format(
      "<svg role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" style=\"font-size:{2}px\">",
      name_px + line_width_px,
      height,
      size.font_px);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto top = static_cast<int>(i) * size.height_px;
    svg += bar_of(results[i], line_width_px / longest_s, top, size) +
           marks_of(results[i], line_width_px / longest_s, top, size);
  }
  svg += fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\" style=\"font-size:11px\">{:.0f} "
      "s</text></svg>",
      name_px + line_width_px,
      height - 5,
      longest_s);
  return "<h2>Simulated time</h2><p class=\"sub\">One bar an episode, in the order of the file: "
         "<span class=\"good\">all goals</span>, <span class=\"warn\">some</span>, <span "
         "class=\"bad\">none</span>. A mark stands where a goal that was in place at the end had "
         "come to rest there.</p>" +
         svg;
}

std::string goods_tables(const std::vector<episodes::EpisodeResult>& results,
                         const catalog::Catalog& catalog) {
  return "<h2>Goals by category</h2><p class=\"sub\">What was in place at the end, before wrong "
         "items and void episodes are taken off.</p>" +
         goods_table("category",
                     goods_rows(results,
                                catalog,
                                [](const catalog::Product& product) { return product.category; })) +
         "<h2>Goals by shape</h2>" +
         goods_table("shape", goods_rows(results, catalog, [](const catalog::Product& product) {
                       return product.archetype;
                     }));
}

}  // namespace marketgen::evaluation
