// Merged runs and leaderboards for marketgen/rankings.py.
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "binding.h"
#include "evaluation/leaderboard_page.h"
#include "evaluation/merge_runs.h"
#include "io/json.h"
#include "io/output.h"

namespace marketgen::python {
namespace {

void merge(const std::vector<std::string>& folders, const std::string& into) {
  value_or_raise(without_interpreter([&] { return evaluation::merge_folders(folders, into); }));
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

}  // namespace

void add_rankings(nb::module_& module) {
  module.def("merge", &merge);
  module.def("leaderboard", &leaderboard);
}

}  // namespace marketgen::python
