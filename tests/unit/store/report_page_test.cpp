// The report's HTML page: what it shows, that it loads nothing, and that no text becomes markup.
#include "store/report_page.h"

#include <gtest/gtest.h>

#include <numeric>
#include <regex>

namespace marketgen {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(ReportHtml, TextOfAPersonIsNeverMarkup) {
  const std::string evil = "<script>alert(\"x\")</script>&";
  store::StorePage page;
  page.manifest.name = page.manifest.brief.prompt = page.manifest.scene_hash = evil;
  store::StoreReport& report = page.report;
  report.requirements.push_back({evil, {0, 1}, false, evil});
  report.rules.push_back({evil, layout::Severity::hard, evil, 1, 0, evil, std::nullopt});
  report.unparsed.push_back({evil, {0, 1}});
  report.conflicts.push_back({evil, evil, evil, evil});
  report.repairs.push_back(evil);
  report.unstocked.push_back({evil, evil});
  report.timing_s.push_back({evil, 1});
  page.fill.push_back({evil, 0.5, evil});
  page.pictures.push_back({evil, "image/png", "bytes"});
  const std::string html = store::report_html({page});
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("alert(\"x\")"), std::string::npos);
  // Name, prompt, hash; 2 of the wish, 3 of the rule, the word, 4 of the conflict, repair, 2 of the
  // product, stage, 2 of the bar, 2 of the picture.
  EXPECT_EQ(count_of(html, "&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt;&amp;"), 21U);
}

TEST(ReportHtml, OnePageHoldsEveryStoreAndLoadsNothing) {
  store::StorePage first, second;
  first.manifest.name = "North", second.manifest.name = "South";
  first.pictures = {{"Layout", "image/png", "one"}, {"aisle", "image/jpeg", "two"}};
  first.prices_eur = {1, 2, 3};
  const std::string page = store::report_html({first, second});
  EXPECT_NE(page.find("<h1>North</h1>"), std::string::npos);
  EXPECT_NE(page.find("<h1>South</h1>"), std::string::npos);
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  for (const char* outside : {"http:", "https:", "href=", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_EQ(count_of(page, "src="), 2U);
  EXPECT_NE(page.find("src=\"data:image/png;base64,b25l\""), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/jpeg;base64,dHdv\""), std::string::npos);
}

TEST(ReportHtml, EveryMetricHasItsSentence) {
  store::StorePage page;
  page.report.metrics.STB = 0.99;
  page.report.metrics.stb_products = 200;
  const std::string html = store::report_html({page});
  const std::regex row("<tr><td>[^<]+</td><td class=\"value\">[^<]+</td><td>([^<]+)</td></tr>");
  int sentences = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), row), end; it != end; ++it) {
    ++sentences;
    EXPECT_GT((*it)[1].length(), 30);
    EXPECT_TRUE((*it)[1].str().ends_with(".")) << (*it)[1];
  }
  EXPECT_EQ(sentences, 10);
  EXPECT_NE(html.find("99.0 %"), std::string::npos);
}

TEST(ReportPlots, AHistogramCountsEveryValueOnce) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i)
    values.push_back(0.1 * i);
  values.push_back(500);  // one dear thing does not flatten the others
  const std::string svg = store::histogram(values, "price, euro");
  const std::regex number("text-anchor=\"middle\">([0-9]+)<");
  std::vector<int> counts;
  for (std::sregex_iterator it(svg.begin(), svg.end(), number), end; it != end; ++it)
    counts.push_back(std::stoi((*it)[1]));
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 101);
  EXPECT_GE(counts.size(), 9U);
  EXPECT_EQ(counts.front(), 10);  // steps of one euro
  EXPECT_NE(svg.find("price, euro"), std::string::npos);
  EXPECT_EQ(store::histogram({}, "price"), "");
  EXPECT_NE(store::histogram({0, 0}, "price").find(">2<"), std::string::npos);
}

TEST(ReportPlots, BarsAreAsLongAsTheirShares) {
  const std::string svg =
      store::bar_plot({{"dairy", 1, "100 %"}, {"snacks", 0.25, "25 %"}, {"a", 7, ""}});
  const std::regex bar("class=\"bar\"[^>]* width=\"([0-9.]+)\"");
  std::vector<double> widths;
  for (std::sregex_iterator it(svg.begin(), svg.end(), bar), end; it != end; ++it)
    widths.push_back(std::stod((*it)[1]));
  ASSERT_EQ(widths.size(), 3U);
  EXPECT_DOUBLE_EQ(widths[1], widths[0] / 4);
  EXPECT_DOUBLE_EQ(widths[2], widths[0]);  // never out of the plot
  EXPECT_EQ(store::bar_plot({}), "");
}

}  // namespace
}  // namespace marketgen
