#include "evaluation/run_page.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "base/text.h"
#include "evaluation/leaderboard.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/run_tables.h"
#include "io/file.h"
#include "net/http.h"
#include "store/html_page.h"

namespace marketgen::evaluation {
namespace {

constexpr std::size_t strips_of_a_code = 6;  // shown; the rest are rows
constexpr std::size_t rows_of_a_code = 200;

std::string tile_of(std::string_view name, const std::string& value) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>", value, name);
}

template <class Share>
std::string share_tile(std::string_view name, const Share& share) {
  return tile_of(fmt::format("{}, {} of {}", name, share.number, share.of),
                 percent_with_interval(share.share, share.low, share.high));
}

std::string figures(const FinishedRun& run) {
  const EvaluationSummary summary = summarize(run.results);
  std::string out = "<div class=\"tiles\">" + share_tile("strict", summary.strict) +
                    share_tile("goals", summary.goals) + share_tile("clean", summary.clean) +
                    share_tile("violations", summary.violations);
  out += tile_of(
      "partial score",
      percent_with_interval(summary.partial.value, summary.partial.low, summary.partial.high));
  if (summary.mean_path_m > 0) out += tile_of("SPL", fmt::format("{:.1f}", 100 * summary.spl));
  out += "</div>";
  const std::size_t missing = run.record.episodes.size() - run.results.size();
  if (missing > 0)
    out +=
        fmt::format("<p class=\"bad\">{} of {} episodes have no result: nothing here is final.</p>",
                    missing,
                    run.record.episodes.size());
  for (const ErrorCount& error : summary.errors)
    out += fmt::format("<p class=\"bad\">{} could not be run ({}): they are in no share.</p>",
                       error.episodes,
                       escaped_markup(error.error));
  return out;
}

std::string strip_figure(const StripPicture& strip) {
  const std::string title = escaped_markup(strip.episode);
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:{1};base64,{2}\">"
      "<figcaption>{0}</figcaption></figure>",
      title,
      strip.media_type,
      net::base64_of(strip.bytes));
}

// Of those of the results that have one.
std::string strip_figures(const std::vector<const episodes::EpisodeResult*>& results,
                          const std::vector<StripPicture>& strips) {
  std::string figures;
  for (const episodes::EpisodeResult* result : results) {
    const auto strip = std::ranges::find(strips, result->episode, &StripPicture::episode);
    if (strip != strips.end()) figures += strip_figure(*strip);
  }
  return figures.empty() ? "" : "<div class=\"strips\">" + figures + "</div>";
}

std::string failed_row(const episodes::EpisodeResult& result) {
  std::string missed;
  for (const episodes::GoalOutcome& goal : result.goals)
    if (goal.reached < goal.count)
      missed += fmt::format("{}{} ({} of {})",
                            missed.empty() ? "" : ", ",
                            escaped_markup(goal.sku),
                            goal.reached,
                            goal.count);
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{} of {}</td><td>{:.0f} s</td><td>{}</td>"
      "<td>{}</td></tr>",
      escaped_markup(result.episode),
      escaped_markup(result.store),
      result.hits,
      result.asked,
      result.simulated_s,
      missed,
      escaped_markup(result.detail));
}

// One code: its strips, then its episodes.
std::string failures_of_code(const std::string& code,
                             const std::vector<const episodes::EpisodeResult*>& failed,
                             const std::vector<StripPicture>& strips) {
  std::string out = fmt::format("<details{}><summary><b>{}</b>: {} episode{}</summary>",
                                failed.size() <= strips_of_a_code ? " open" : "",
                                escaped_markup(code),
                                failed.size(),
                                failed.size() == 1 ? "" : "s");
  out += strip_figures(failed, strips);
  std::string rows;
  for (std::size_t i = 0; i < std::min(failed.size(), rows_of_a_code); ++i)
    rows += failed_row(*failed[i]);
  out +=
      "<table><tr><th>episode</th><th>store</th><th>goals</th><th>time</th><th>not reached</th>"
      "<th>error</th></tr>" +
      rows + "</table>";
  if (failed.size() > rows_of_a_code)
    out += fmt::format("<p>and {} more in results.jsonl</p>", failed.size() - rows_of_a_code);
  return out + "</details>";
}

std::string failures(const FinishedRun& run, const std::vector<StripPicture>& strips) {
  std::string out;
  for (const auto& [code, results] : results_by_code(run))
    if (code != name_of(episodes::FailureCode::none))
      out += failures_of_code(code, results, strips);
  if (out.empty()) return "<h2>Failures</h2><p>Every episode reached all its goals.</p>";
  if (strips.empty())
    out +=
        "<p class=\"sub\">No film strips lie in strips/: marketgen report --strips 3 --episodes "
        "FILE makes some.</p>";
  return "<h2>Failures, by code</h2>" + out;
}

std::string successes(const FinishedRun& run, const std::vector<StripPicture>& strips) {
  const ResultsByCode codes = results_by_code(run);
  const auto reached = codes.find(std::string(name_of(episodes::FailureCode::none)));
  const std::string figures = reached == codes.end() ? "" : strip_figures(reached->second, strips);
  return figures.empty() ? "" : "<h2>All goals reached</h2>" + figures;
}

}  // namespace

std::string run_section(const FinishedRun& run,
                        const std::vector<StripPicture>& strips,
                        const catalog::Catalog& catalog) {
  const RunRecord& record = run.record;
  std::string out = fmt::format(
      "<section><h1>{}</h1><p class=\"sub\">{} episodes · version {} · commit {} · realism {} · "
      "split {} · instructions in {} · file of episodes {}</p>",
      escaped_markup(record.policy),
      record.episodes.size(),
      escaped_markup(record.version),
      escaped_markup(record.commit()),
      escaped_markup(record.realism),
      name_of(record.split),
      escaped_markup(record.instructions),
      escaped_markup(spoken_episodes(record.set, record.episodes_hash)));
  return out + figures(run) + failures(run, strips) + successes(run, strips) +
         ledger_table(run.results) + time_lines(run.results) + goods_tables(run.results, catalog) +
         "</section>";
}

Result<std::string> runs_html(const std::vector<FinishedRun>& runs,
                              const catalog::Catalog& catalog) {
  std::string body;
  if (runs.size() > 1) {
    MARKETGEN_TRY(const Leaderboard board, leaderboard_of(runs));
    body += leaderboard_sections(board);
  }
  for (const FinishedRun& run : runs) {
    MARKETGEN_TRY(const std::vector<StripPicture> strips, strips_of(run, strips_of_a_code));
    body += run_section(run, strips, catalog);
  }
  return store::html_page("MarketGen results", body);
}

}  // namespace marketgen::evaluation
