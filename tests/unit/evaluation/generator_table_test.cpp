// What stores are worth, of made-up reports with known answers.
#include "evaluation/generator_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/file.h"
#include "io/json.h"
#include "store/store.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using evaluation::GeneratorRow;

class Stores : public testing::Test {
 protected:
  std::string add(double nav, double seconds, std::optional<double> stability) {
    const std::filesystem::path folder =
        scratch_.path() / ("store-" + std::to_string(folders_.size()));
    store::Manifest manifest;
    manifest.name = "made up";
    manifest.versions.marketgen = "1.0";
    manifest.scene_hash = manifest.look_hash = "aa";
    store::StoreReport report;
    report.metrics.NAV = nav;
    report.metrics.STB = stability;
    report.timing_s = {{"plan", seconds / 2}, {"scene", seconds / 2}};
    report.rules.emplace_back().code = "AISLE_TOO_NARROW";  // soft by itself
    EXPECT_TRUE(io::write_file(folder / "store.json", io::write_json(manifest)).ok());
    EXPECT_TRUE(io::write_file(folder / "report.json", io::write_json(report)).ok());
    return folders_.emplace_back(folder.string());
  }
  evaluation::GeneratorTable table() const {
    const auto published = evaluation::load_published(io::data_folder().value());
    auto made = evaluation::generator_table(folders_, published.value());
    if (!made.ok()) fatal(to_string(made.error()).c_str());
    return std::move(made).value();
  }
  static GeneratorRow row(const evaluation::GeneratorTable& table, std::string_view metric) {
    const auto at = std::ranges::find(table.rows, metric, &GeneratorRow::metric);
    return at == table.rows.end() ? GeneratorRow{} : *at;
  }

  ScratchFolder scratch_;
  std::vector<std::string> folders_;
};

TEST_F(Stores, HaveTheirMedianAndWorst) {
  add(1, 0.5, 1.0);
  add(0.9, 0.1, std::nullopt);
  add(1, 0.2, 0.8);
  const evaluation::GeneratorTable made = table();
  EXPECT_EQ(made.stores, 3);
  EXPECT_EQ(made.versions, std::vector<std::string>{"1.0"});
  const GeneratorRow nav = row(made, "NAV"), seconds = row(made, "seconds");
  EXPECT_DOUBLE_EQ(nav.median, 1);
  EXPECT_DOUBLE_EQ(nav.worst, 0.9) << "more is better";
  EXPECT_DOUBLE_EQ(seconds.median, 0.2);
  EXPECT_DOUBLE_EQ(seconds.worst, 0.5) << "less is better";
  EXPECT_NEAR(row(made, "one_floor").median, 2.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(row(made, "hard_rules").worst, 0) << "soft rules are none";
  const GeneratorRow stability = row(made, "STB");
  EXPECT_EQ(stability.stores, 2) << "of those that were measured";
  EXPECT_DOUBLE_EQ(stability.median, 0.9);
  EXPECT_FALSE(stability.published.empty());
}

TEST_F(Stores, LeaveOutWhatNoneOfThemHas) {
  add(1, 0.5, std::nullopt);
  EXPECT_EQ(row(table(), "STB").stores, 0);
}

TEST_F(Stores, PublishedFiguresAreOfMetricsThatThereAre) {
  add(1, 0.5, 1.0);
  std::size_t shown = 0;
  for (const GeneratorRow& of : table().rows)
    shown += of.published.size();
  EXPECT_EQ(shown, evaluation::load_published(io::data_folder().value()).value().generators.size());
}

TEST_F(Stores, AreNamedOnceAndThere) {
  folders_ = {add(1, 0.5, 1.0), folders_.front()};
  EXPECT_EQ(evaluation::generator_table(folders_, {}).error().code, "usage.bad_flag");
  EXPECT_EQ(evaluation::generator_table({}, {}).error().code, "usage.bad_flag");
  EXPECT_FALSE(evaluation::generator_table({"/no/store"}, {}).ok());
}

}  // namespace
}  // namespace marketgen
