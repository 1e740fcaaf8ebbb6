// Merged runs and leaderboards for marketgen/rankings.py.
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "assets/usable_catalog.h"
#include "binding.h"
#include "evaluation/differences_table.h"
#include "evaluation/generator_table.h"
#include "evaluation/goals_table.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/merge_runs.h"
#include "evaluation/shapes_table.h"
#include "evaluation/tracks_table.h"
#include "io/file.h"
#include "io/json.h"
#include "io/output.h"
#include "store/open_stores.h"

namespace marketgen::python {
namespace {

// `set`: of the program's, of which the shards ran a copy; "" for others.
void merge(const std::vector<std::string>& folders,
           const std::string& into,
           const std::string& set) {
  value_or_raise(
      without_interpreter([&] { return evaluation::merge_folders(folders, into, set); }));
}

// market-leaderboard/1; also as a page, where `html` names one.
std::string leaderboard(const std::vector<std::string>& folders, const std::string& html) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    io::Outputs outputs;
    MARKETGEN_CHECK(outputs.add({{"html", html}}));
    MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs, evaluation::read_runs(folders));
    MARKETGEN_TRY(const evaluation::Leaderboard board, evaluation::leaderboard_of(runs));
    if (!html.empty()) {
      MARKETGEN_CHECK(outputs.put(html, evaluation::leaderboard_html(board)));
      MARKETGEN_CHECK(outputs.commit());
    }
    return io::write_json(board);
  }));
}

// market-tracks/1, or market-differences/1 of what varies: "truth" or "realism".
std::string tracks_table(const std::vector<std::string>& folders) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs, evaluation::read_runs(folders));
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
    MARKETGEN_TRY(const evaluation::TracksTable table, evaluation::tracks_table(runs, published));
    return io::write_json(table);
  }));
}

// market-shapes/1.
std::string shapes_table(const std::vector<std::string>& folders) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs, evaluation::read_runs(folders));
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
    MARKETGEN_TRY(const catalog::Catalog rows, assets::usable_catalog());
    MARKETGEN_TRY(const evaluation::ShapesTable table,
                  evaluation::shapes_table(runs, rows, published));
    return io::write_json(table);
  }));
}

std::string differences_table(const std::vector<std::string>& folders, const std::string& varied) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const std::vector<evaluation::FinishedRun> runs, evaluation::read_runs(folders));
    MARKETGEN_TRY(
        const evaluation::DifferencesTable table,
        evaluation::differences_table(runs, value_named<evaluation::Varied>(varied).value()));
    return io::write_json(table);
  }));
}

// market-goals/1 of stores.
std::string goals_table(const std::vector<std::string>& folders) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(catalog::Catalog rows, assets::usable_catalog());
    MARKETGEN_TRY(const store::OpenedStores opened, store::open_stores(folders, std::move(rows)));
    MARKETGEN_TRY(const evaluation::GoalsTable table, evaluation::goals_table(opened, data));
    return io::write_json(table);
  }));
}

// market-generator/1 of stores.
std::string generator_table(const std::vector<std::string>& folders) {
  return value_or_raise(without_interpreter([&]() -> Result<std::string> {
    MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
    MARKETGEN_TRY(const evaluation::Published published, evaluation::load_published(data));
    MARKETGEN_TRY(const evaluation::GeneratorTable table,
                  evaluation::generator_table(folders, published));
    return io::write_json(table);
  }));
}

}  // namespace

void add_rankings(nb::module_& module) {
  module.def("merge", &merge);
  module.def("leaderboard", &leaderboard);
  module.def("tracks_table", &tracks_table);
  module.def("shapes_table", &shapes_table);
  module.def("differences_table", &differences_table);
  module.def("goals_table", &goals_table);
  module.def("generator_table", &generator_table);
}

}  // namespace marketgen::python
