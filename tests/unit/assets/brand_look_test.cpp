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
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  std::set<std::string> names;
  for (const catalog::Product& product : catalog.products) {
    if (!product.brand.empty()) names.insert(product.brand);
  }
  return names;
}

auto type_of(const assets::Typeface& face) {
  return std::tuple(std::string(face.family),
                    face.weight,
                    face.italic,
                    face.condensed,
                    face.tracking_em,
                    face.letter_case);
}

auto color_of(const assets::Color& color) {
  return std::tuple(color.r, color.g, color.b);
}

TEST(BrandLooks, ThereAreAHundredAndMore) {
  EXPECT_GE(brands().size(), 100U);
}

TEST(BrandLooks, NoTwoShareShapeTypeAndColours) {
  using Key = std::tuple<assets::MarkShape,
                         decltype(type_of({})),
                         decltype(color_of({})),
                         decltype(color_of({}))>;
  std::map<Key, std::string> owner;
  for (const std::string& brand : brands()) {
    const assets::BrandLook look = assets::brand_look(brand);
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
    assets::Canvas canvas(width, height, assets::rgb("#f4f1ea"));
    assets::draw_brand_mark(canvas,
                            assets::brand_look(brand),
                            brand,
                            {1, 1, width - 2, height - 2},
                            assets::rgb("#f4f1ea"));
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
  std::set<assets::MarkShape> shapes;
  for (const std::string& brand : brands()) {
    designs.insert(assets::brand_look(brand).design % assets::pack_designs().size());
    shapes.insert(assets::brand_look(brand).shape);
  }
  EXPECT_EQ(designs.size(), assets::pack_designs().size());
  EXPECT_EQ(shapes.size(), assets::names_of(assets::MarkShape{}).size());
}

}  // namespace
}  // namespace marketgen
