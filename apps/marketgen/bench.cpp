// marketgen bench: the committed benchmarks, one JSON line a figure.
#include "bench/bench.h"

#include <fmt/format.h>

#include "base/parallel.h"
#include "command.h"
#include "io/json.h"

namespace marketgen::app {
namespace {

struct BenchFlags {
  CommonFlags common;
  std::vector<std::string> names;
};

Result<void> run_benchmarks(const BenchFlags& flags) {
  const ThreadLimit limit(flags.common.threads);
  std::vector<std::string_view> known;
  for (const bench::Benchmark& b : bench::benchmarks())
    known.push_back(b.name);
  for (const std::string& name : flags.names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return catalog::unknown_name("usage.bad_flag", "bench", "benchmark", name, known);
  }
  MARKETGEN_TRY(const catalog::Catalog catalog, load_rows());
  for (const bench::Benchmark& b : bench::benchmarks()) {
    const bool wanted =
        flags.names.empty() ||
        std::find(flags.names.begin(), flags.names.end(), b.name) != flags.names.end();
    if (!wanted) continue;
    MARKETGEN_TRY(const std::vector<bench::Figure> figures, b.run(catalog));
    for (const bench::Figure& figure : figures)
      fmt::print("{}\n", io::write_json_line(figure));
    std::fflush(stdout);
  }
  return {};
}

}  // namespace

Run add_bench(CLI::App& app) {
  auto flags = std::make_shared<BenchFlags>();
  CLI::App* command =
      app.add_subcommand("bench", "Run the committed benchmarks; one JSON line a figure");
  std::string list;
  for (const bench::Benchmark& b : bench::benchmarks())
    list += fmt::format("\n  {:<10} {}", b.name, b.description);
  command->add_option("names", flags->names, "which ones; none = all")->type_name("BENCHMARK");
  add_common_flags(*command, flags->common, Takes::nothing);
  command->footer("Benchmarks:" + list + "\nExample:  marketgen bench generate load");
  return [flags] {
    const auto done = run_benchmarks(*flags);
    return done.ok() ? 0 : fail(done.error());
  };
}

}  // namespace marketgen::app
