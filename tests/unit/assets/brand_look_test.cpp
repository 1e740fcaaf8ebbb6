// Brands: no two of those in data/products look alike.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "assets/print/brand_mark.h"
#include "assets/print/pack_design.h"
#include "catalog/catalog.h"
#include "io/file.h"

namespace marketgen {
namespace {

std::set<std::string> brands() {
  const Catalog catalog = load_catalog(data_folder().value()).value();
  std::set<std::string> names;
  for (const Product& product : catalog.products) {
    if (!product.brand.empty()) names.insert(product.brand);
  }
  return names;
}

auto type_of(const Typeface& face) {
  return std::tuple(std::string(face.family),
                    face.weight,
                    face.italic,
                    face.condensed,
                    face.tracking_em,
                    face.letter_case);
}

auto color_of(const Color& color) {
  return std::tuple(color.r, color.g, color.b);
}

TEST(BrandLooks, ThereAreAHundredAndMore) {
  EXPECT_GE(brands().size(), 100U);
}

TEST(BrandLooks, NoTwoShareShapeTypeAndColours) {
  using Key =
      std::tuple<MarkShape, decltype(type_of({})), decltype(color_of({})), decltype(color_of({}))>;
  std::map<Key, std::string> owner;
  for (const std::string& brand : brands()) {
    const BrandLook look = brand_look(brand);
    const auto [entry, is_new] = owner.try_emplace(
        {look.shape, type_of(look.mark_face), color_of(look.plate), color_of(look.trim)}, brand);
    EXPECT_TRUE(is_new) << brand << " looks like " << entry->second
                        << "; choose another number in brand_look()";
  }
}

// Mean difference of two pictures' bytes.
double difference(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    sum += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
  return sum / static_cast<double>(a.pixels.size());
}

TEST(BrandLooks, MarksDifferAsDrawn) {
  constexpr int width = 48, height = 20;  // as on a pack across the aisle
  constexpr double min_difference = 3.0;
  std::vector<std::pair<std::string, Image>> marks;
  for (const std::string& brand : brands()) {
    Canvas canvas(width, height, rgb("#f4f1ea"));
    draw_brand_mark(
        canvas, brand_look(brand), brand, {1, 1, width - 2, height - 2}, rgb("#f4f1ea"));
    marks.emplace_back(brand, canvas.image());
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(difference(marks[i].second, marks[j].second), min_difference)
          << marks[i].first << " and " << marks[j].first;
    }
  }
}

TEST(BrandLooks, EveryDesignShapeAndTypefaceIsUsed) {
  std::set<std::size_t> designs;
  std::set<MarkShape> shapes;
  for (const std::string& brand : brands()) {
    designs.insert(brand_look(brand).design % pack_designs().size());
    shapes.insert(brand_look(brand).shape);
  }
  EXPECT_EQ(designs.size(), pack_designs().size());
  EXPECT_EQ(shapes.size(), names_of(MarkShape{}).size());
}

}  // namespace
}  // namespace marketgen
