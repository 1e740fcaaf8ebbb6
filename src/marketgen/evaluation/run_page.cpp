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
      "<figure><img style=\"width:100%\" alt=\"{0}\" src=\"data:{1};base64,{2}\">"
      "<figcaption>{0}</figcaption></figure>",
      title,
      strip.media_type,
      net::base64_of(strip.bytes));
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
  std::string out = fmt::format("<details{}><summary><b>{}</b>: {} episodes</summary>",
                                failed.size() <= strips_of_a_code ? " open" : "",
                                escaped_markup(code),
                                failed.size());
  std::string rows;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    const auto strip = std::ranges::find(strips, failed[i]->episode, &StripPicture::episode);
    if (strip != strips.end()) out += strip_figure(*strip);
    if (i < rows_of_a_code) rows += failed_row(*failed[i]);
  }
  out +=
      "<table><tr><th>episode</th><th>store</th><th>goals</th><th>time</th><th>not reached</th>"
      "<th>error</th></tr>" +
      rows + "</table>";
  if (failed.size() > rows_of_a_code)
    out += fmt::format("<p>and {} more in results.jsonl</p>", failed.size() - rows_of_a_code);
  return out + "</details>";
}

using FailedByCode = std::map<std::string, std::vector<const episodes::EpisodeResult*>>;

FailedByCode failed_by_code(const FinishedRun& run) {
  FailedByCode codes;
  for (const episodes::EpisodeResult& result : run.results)
    if (!result.success_strict) codes[std::string(name_of(result.failure))].push_back(&result);
  return codes;
}

std::string failures(const FinishedRun& run, const std::vector<StripPicture>& strips) {
  std::string out;
  for (const auto& [code, failed] : failed_by_code(run))
    out += failures_of_code(code, failed, strips);
  if (out.empty()) return "<h2>Failures</h2><p>Every episode reached all its goals.</p>";
  if (strips.empty())
    out +=
        "<p class=\"sub\">No film strips lie in strips/: marketgen replay --strip "
        "strips/EPISODE.png makes one.</p>";
  return "<h2>Failures, by code</h2>" + out;
}

}  // namespace

Result<std::vector<StripPicture>> strips_of(const FinishedRun& run, std::size_t at_most) {
  std::vector<StripPicture> strips;
  for (const auto& [code, failed] : failed_by_code(run)) {
    std::size_t taken = 0;
    for (const episodes::EpisodeResult* result : failed) {
      for (const auto& [ending, type] : {std::pair{".png", "image/png"}, {".jpg", "image/jpeg"}}) {
        const auto file = run.folder / "strips" / (result->episode + ending);
        std::error_code none;
        if (taken == at_most || !std::filesystem::is_regular_file(file, none)) continue;
        MARKETGEN_TRY(std::string bytes, io::read_file(file));
        strips.push_back({result->episode, type, std::move(bytes)});
        ++taken;
      }
    }
  }
  return strips;
}

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
      escaped_markup(record.episodes_hash));
  return out + figures(run) + failures(run, strips) + ledger_table(run.results) +
         time_lines(run.results) + goods_tables(run.results, catalog) + "</section>";
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
