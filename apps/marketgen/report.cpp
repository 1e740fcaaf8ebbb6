// marketgen report: the metrics of one or many stores, or the results of policies, as JSON and as
// one HTML page.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/parallel.h"
#include "command.h"
#include "evaluation/run_page.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "number_flags.h"
#include "say.h"
#include "store/report_page.h"

namespace marketgen::app {
namespace {

struct ReportFlags {
  CommonFlags common;
  std::vector<std::string> folders;
  std::string html = "report.html", episodes;
  int strips = 0;
};

bool is_of_results(const std::filesystem::path& named) {
  std::error_code failed;
  return named.filename() == "results.jsonl" ||
         std::filesystem::exists(named / "results.jsonl", failed) ||
         std::filesystem::exists(evaluation::record_path(named), failed);
}

// Errors: those of make_strips; usage.bad_flag when no episodes are named.
Result<void> make_strips(const ReportFlags& flags,
                         const std::vector<evaluation::FinishedRun>& runs,
                         const catalog::Catalog& catalog) {
  if (flags.strips == 0) return {};
  if (flags.episodes.empty())
    return Error{"usage.bad_flag", "--strips", "name the file of the episodes with --episodes"};
  MARKETGEN_TRY(const episodes::EpisodeFile file, episodes::read_episode_file(flags.episodes));
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  for (const evaluation::FinishedRun& run : runs)
    MARKETGEN_CHECK(evaluation::make_strips(data,
                                            run,
                                            file,
                                            catalog,
                                            static_cast<std::size_t>(flags.strips),
                                            progress_for(flags.common)));
  return {};
}

Result<void> report_results(const ReportFlags& flags, io::Outputs& outputs) {
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs,
                evaluation::read_runs(flags.folders));
  MARKETGEN_CHECK(make_strips(flags, runs, catalog));
  MARKETGEN_TRY(const std::string page, evaluation::runs_html(runs, catalog));
  MARKETGEN_CHECK(outputs.put(flags.html, page));
  MARKETGEN_CHECK(outputs.commit());
  for (const evaluation::FinishedRun& run : runs) {
    const evaluation::EvaluationSummary summary = evaluation::summarize(run.results);
    if (flags.common.json)
      fmt::print("{}\n", io::write_json_line(summary));
    else if (!flags.common.quiet)
      say("{:<28} {} of {} strict, {} of {} goals\n",
          run.record.policy,
          summary.strict.number,
          summary.strict.of,
          summary.goals.number,
          summary.goals.of);
  }
  if (!flags.common.json) say("page        {}\n", flags.html);
  return {};
}

Result<void> report(const ReportFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  io::Outputs outputs;
  MARKETGEN_CHECK(outputs.add({{"--output", flags.html}}));
  const auto results = std::ranges::count_if(flags.folders, is_of_results);
  if (results == std::ssize(flags.folders)) return report_results(flags, outputs);
  if (results > 0)
    return Error{"usage.bad_flag",
                 "folders",
                 "some are stores and some are results: a page is of the one or of the other"};
  if (flags.strips > 0)
    return Error{"usage.bad_flag", "--strips", "stores have none: name folders of eval"};
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  std::vector<store::StorePage> pages;
  for (const std::string& folder : flags.folders) {
    MARKETGEN_TRY(const store::Store store, store::open_store(folder, catalog));
    MARKETGEN_TRY(store::StoreReport full,
                  store::full_report(store, catalog, progress_for(flags.common)));
    if (flags.common.json) fmt::print("{}\n", io::write_json_line(full));
    MARKETGEN_TRY(store::StorePage page, store::page_of(store, std::move(full), catalog));
    pages.push_back(std::move(page));
  }
  MARKETGEN_CHECK(outputs.put(flags.html, store::report_html(pages)));
  MARKETGEN_CHECK(outputs.commit());
  if (flags.common.json) return {};
  for (const store::StorePage& page : pages) {
    const store::Manifest& manifest = page.manifest;
    const store::StoreReport& full = page.report;
    say("{:<28} {:>7} products  COL {:.2f} %  OOB {}  NAV {:.3f}  reach {:.1f} %  STB {:.1f} % of "
        "{}  wishes {:.0f} %\n",
        manifest.name,
        manifest.counts.products,
        100 * full.metrics.COL,
        full.metrics.OOB,
        full.metrics.NAV,
        100 * full.metrics.reachable_shelves,
        100 * full.metrics.STB.value_or(0),
        full.metrics.stb_products.value_or(0),
        100 * full.metrics.prompt);
  }
  say("page        {}\n", flags.html);
  return {};
}

}  // namespace

Run add_report(CLI::App& app) {
  auto flags = std::make_shared<ReportFlags>();
  CLI::App* command =
      app.add_subcommand("report",
                         "Measure stores, physics included, or show results of eval: JSON and one "
                         "HTML page");
  command->add_option("folders", flags->folders, "store folders, or folders of eval")
      ->type_name("FOLDER")
      ->required();
  add_output(*command, "-o,--output", flags->html, "HTML page to write")->capture_default_str();
  command
      ->add_option("--strips",
                   flags->strips,
                   "run so many episodes of each failure code again, and film them for the page")
      ->check(whole_number(0, 1000))
      ->capture_default_str();
  command->add_option("--episodes", flags->episodes, "file of the episodes, for --strips")
      ->type_name("EPISODES");
  add_common_flags(*command, flags->common, Takes::json);
  command->footer("Example:  marketgen report shop -o shop-report.html");
  return [flags] {
    const auto done = report(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
