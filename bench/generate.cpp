#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/progress.h"
#include "bench/bench.h"
#include "bench/sample_store.h"
#include "store/design.h"

namespace marketgen::bench {
namespace {

struct Run {
  double seconds = 0, before_previews_s = 0, previews_s = 0;
  std::uint64_t products = 0;
};

Result<Run> create(const store::CreateOptions& options, const catalog::Catalog& catalog) {
  const double start = monotonic_seconds();
  MARKETGEN_TRY(const store::Created created, store::create_store(options, catalog));
  Run run;
  run.seconds = monotonic_seconds() - start;
  for (const store::StageTiming& t : created.report.timing_s)
    (t.stage == "previews" ? run.previews_s : run.before_previews_s) += t.seconds;
  run.products = created.manifest.counts.products;
  return run;
}

// A hall, and 12,000 characters of clauses about it that no floor can fulfil together.
std::string salad() {
  constexpr std::array<std::string_view, 7> zones = {
      "bakery", "dairy", "frozen", "wine", "snacks", "produce", "household"};
  constexpr std::array<std::string_view, 5> relations = {
      " next to the ", " left of the ", " far from the ", " behind the ", " opposite the "};
  std::string prompt = "a 100 x 80 m hypermarket with 12 emergency exits and 12 windows";
  for (std::size_t i = 0; prompt.size() < 12'000; ++i) {
    prompt += fmt::format(", {}{}{}",
                          zones[i % zones.size()],
                          relations[i % relations.size()],
                          zones[(3 * i + 1) % zones.size()]);
  }
  return prompt;
}

// From the words to a layout that keeps its rules; no goods.
Result<double> planning_seconds(const catalog::Catalog& catalog) {
  intake::Brief brief;
  brief.prompt = salad();
  const double start = monotonic_seconds();
  MARKETGEN_CHECK(store::design_store(brief, catalog, Seed(1)));
  return monotonic_seconds() - start;
}

}  // namespace

Figures run_generate(const catalog::Catalog& catalog) {
  const ScratchFolder scratch;
  std::vector<Figure> figures;
  const auto add = [&](std::string name, double value, std::string unit, int n) {
    figures.push_back(
        {std::move(name), value, std::move(unit), n, std::nullopt, std::nullopt, machine_name()});
  };
  constexpr int runs = 5;
  std::vector<double> small, large;
  std::uint64_t products = 0, large_products = 0;
  for (int i = 0; i < runs; ++i) {
    MARKETGEN_TRY(
        const Run run,
        create(neighbourhood_store(scratch / ("small-" + std::to_string(i)), false), catalog));
    small.push_back(run.seconds);
    products = run.products;
    MARKETGEN_TRY(const Run big,
                  create(large_store(scratch / ("large-" + std::to_string(i))), catalog));
    large.push_back(big.seconds);
    large_products = big.products;
  }
  std::vector<double> planning;
  for (int i = 0; i < runs; ++i) {
    MARKETGEN_TRY(const double seconds, planning_seconds(catalog));
    planning.push_back(seconds);
  }
  add("plan_12000_characters_s", median(planning), "s", runs);
  add("generate_24x15m_s", median(small), "s", runs);
  add("generate_24x15m_products", static_cast<double>(products), "items", 1);
  add("generate_40x25m_s", median(large), "s", runs);
  add("generate_40x25m_products", static_cast<double>(large_products), "items", 1);
  add("generate_peak_rss_mb", peak_rss_mb(), "MB", 1);
  MARKETGEN_TRY(const Run drawn, create(neighbourhood_store(scratch / "drawn", true), catalog));
  add("previews_24x15m_s", drawn.previews_s, "s", 1);
  std::vector<double> million;
  std::uint64_t million_products = 0;
  for (int i = 0; i < runs; ++i) {
    MARKETGEN_TRY(const Run run,
                  create(hypermarket(scratch / ("million-" + std::to_string(i))), catalog));
    million.push_back(run.seconds);
    million_products = run.products;
  }
  add("generate_114x86m_s", median(million), "s", runs);
  add("generate_114x86m_products", static_cast<double>(million_products), "items", 1);
  return figures;
}

}  // namespace marketgen::bench
