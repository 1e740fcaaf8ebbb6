// The committed benchmarks: one function each, one JSON line a figure.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::bench {

// One figure: the median of `n` runs. `ratio` is our value over the rival's, both measured in this
// process, in turn.
struct Figure {
  std::string name;
  double value = 0;
  std::string unit;
  int n = 1;
  std::optional<std::string> rival;
  std::optional<double> ratio;
  std::string machine;

  static constexpr auto fields =
      field_list(field("name", &Figure::name, "what was measured"),
                 field("value", &Figure::value, "median"),
                 field("unit", &Figure::unit, "unit"),
                 field("n", &Figure::n, "runs"),
                 field("rival", &Figure::rival, "what it is compared with"),
                 field("ratio", &Figure::ratio, "value over the rival's"),
                 field("machine", &Figure::machine, "processor and cores"));
};

using Figures = Result<std::vector<Figure>>;

struct Benchmark {
  std::string_view name, description;
  Figures (*run)(const catalog::Catalog& catalog);
};
const std::vector<Benchmark>& benchmarks();  // benchmarks.inc

std::string machine_name();
double resident_mb();  // memory of this process that is in use now
// Median seconds of `runs` calls after one that is not counted.
double median_seconds(int runs, const std::function<void()>& work);

#define BENCHMARK(name, description) Figures run_##name(const catalog::Catalog& catalog);
#include "bench/benchmarks.inc"
#undef BENCHMARK

// The middle one of the values, the upper of two. Not of an empty list.
double median(std::vector<double> values);

}  // namespace marketgen::bench
