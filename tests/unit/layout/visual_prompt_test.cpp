// The floor as a model reads it.
#include "layout/visual_prompt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "sample_shop.h"

namespace marketgen {
namespace {

layout::Layout prompt_layout(const catalog::Catalog& catalog) {
  return layout::make_layout(sample::small_shop(), catalog, Seed(1)).value();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

TEST(VisualPrompt, IsSquareAndTheSameEveryTime) {
  const catalog::Catalog catalog = sample::catalog();
  const layout::Layout layout = prompt_layout(catalog);
  const Image image = layout::draw_visual_prompt(layout, catalog);
  EXPECT_EQ(image.width, layout::visual_prompt_px);
  EXPECT_EQ(image.height, layout::visual_prompt_px);
  EXPECT_EQ(image.pixels, layout::draw_visual_prompt(layout, catalog).pixels);
}

TEST(AsciiPlan, ShowsEveryZoneAndItsFixtures) {
  const catalog::Catalog catalog = sample::catalog();
  const layout::Layout layout = prompt_layout(catalog);
  const std::string text = layout::ascii_plan(layout);
  const std::string floor = text.substr(text.find('#'));  // after the line on the scale
  for (std::size_t i = 0; i < layout.zones.size(); ++i) {
    const bool furnished = std::ranges::any_of(layout.fixtures, [&](const layout::Fixture& one) {
      return one.zone == layout.zones[i].id;
    });
    EXPECT_EQ(floor.find(layout::mark_of_zone(i)) != std::string::npos, furnished) << text;
  }
}

TEST(AsciiPlan, HasARowForEveryCellBetweenItsWalls) {
  const catalog::Catalog catalog = sample::catalog();
  const layout::Layout layout = prompt_layout(catalog);
  const std::vector<std::string> lines = lines_of(layout::ascii_plan(layout));
  const auto cells = [](int mm) { return static_cast<std::size_t>((mm + 499) / 500); };
  ASSERT_EQ(lines.size(), cells(layout.shell.depth_mm) + 3);  // the scale, and two walls
  for (std::size_t i = 1; i < lines.size(); ++i)
    EXPECT_EQ(lines[i].size(), cells(layout.shell.width_mm) + 2);
  EXPECT_NE(lines.back().find('='), std::string::npos) << "the entrance is in the south wall";
  EXPECT_EQ(lines[1].find('='), std::string::npos);
}

}  // namespace
}  // namespace marketgen
