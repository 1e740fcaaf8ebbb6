// What labels are made of: colours, type, motifs, marks, bar codes.
#include <gtest/gtest.h>

#include <set>

#include "assets/print/barcode.h"
#include "assets/print/brand_mark.h"
#include "assets/print/label_motif.h"
#include "assets/print/lettering.h"
#include "assets/print/pack_art.h"
#include "assets/print/pack_design.h"
#include "assets/print/pack_facts.h"
#include "sample_products.h"

namespace marketgen {
namespace {

constexpr assets::Color magenta = assets::rgb("#ff00ff");

bool is_magenta(const std::uint8_t* pixel) {
  return pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 255;
}

// Pixels that differ from magenta, inside and outside of an area.
struct Touched {
  int inside = 0, outside = 0;
};
Touched touched(const assets::Canvas& canvas, const assets::Area& area) {
  const Image image = canvas.image();
  Touched count;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (is_magenta(image.at(x, y))) continue;
      const bool inside = x >= area.x && x < area.right() && y >= area.y && y < area.bottom();
      ++(inside ? count.inside : count.outside);
    }
  }
  return count;
}

TEST(PaintColor, ReadsHexAndMeasuresContrast) {
  EXPECT_EQ(assets::parse_color("#ff8000", "x")->r, 1.0);
  EXPECT_NEAR(assets::parse_color("#ff8000", "x")->g, 128 / 255.0, 1e-12);
  EXPECT_EQ(assets::parse_color("#ff80", "row/color").error().where, "row/color");
  EXPECT_NEAR(assets::contrast(assets::rgb("#000000"), assets::rgb("#ffffff")),
              21.0,
              1e-9);  // WCAG 2.1: the largest there is
  EXPECT_EQ(assets::readable_on(assets::rgb("#ffffff"), assets::rgb("#000000")),
            assets::rgb("#000000"));
  EXPECT_GE(assets::contrast(assets::rgb("#f7e13a"),
                             assets::readable_on(assets::rgb("#f7e13a"), assets::rgb("#ffffff"))),
            3.0);
}

TEST(Lettering, HeadlineStaysInItsAreaAndFillsIt) {
  const assets::Area area{30, 40, 200, 60};
  for (const std::string text :
       {"Cola", "Wholegrain Sunflower Seed Bread", "\u00c4\u00d6\u00dc \u017b\u00f3\u0142w"}) {
    assets::Canvas canvas(260, 140, magenta);
    assets::draw_headline(canvas,
                          {text,
                           {"Lato", 800},
                           assets::print_ink,
                           area,
                           assets::Align::center,
                           assets::VerticalAlign::middle,
                           2});
    const Touched count = touched(canvas, {area.x - 3, area.y - 3, area.w + 6, area.h + 6});
    EXPECT_GT(count.inside, 400) << text;
    EXPECT_EQ(count.outside, 0) << text;
  }
}

TEST(Lettering, BreaksBetweenWordsWhenThatMakesTypeLarger) {
  const assets::Headline headline{"Wholegrain Bread",
                                  {"Lato", 800},
                                  assets::print_ink,
                                  {0, 0, 100, 100},
                                  assets::Align::center,
                                  assets::VerticalAlign::middle,
                                  2};
  EXPECT_EQ(assets::fit_headline(headline).lines, 2);
  assets::Headline narrow = headline;
  narrow.area = {0, 0, 400, 20};
  EXPECT_EQ(assets::fit_headline(narrow).lines, 1);
  EXPECT_LE(assets::fit_headline(headline).width, 100.0 + 1e-9);
  EXPECT_EQ(assets::fit_headline({"", {}, assets::print_ink, {0, 0, 9, 9}}).lines, 0);
}

TEST(Lettering, SizeDoesNotDependOnResolution) {  // hinting would change it
  const assets::Headline headline{
      "Orange Juice", {"Open Sans", 700}, assets::print_ink, {0, 0, 30, 10}};
  const double size = assets::fit_headline(headline).size;
  assets::Headline large = headline;
  large.area = {0, 0, 3000, 1000};
  EXPECT_NEAR(assets::fit_headline(large).size, 100 * size, 1e-6 * size * 100);
}

TEST(LabelMotif, EveryOneDrawsAndKeepsToItsSquare) {
  ASSERT_EQ(assets::label_motifs().size(), 121U);
  const assets::Area square{20, 20, 160, 160};
  for (const assets::LabelMotif& motif : assets::label_motifs()) {
    assets::Canvas canvas(200, 200, magenta);
    assets::draw_motif(canvas,
                       motif,
                       {assets::rgb("#1f5fa8"), assets::rgb("#ffffff"), assets::rgb("#e63946")},
                       square);
    const Touched count = touched(canvas, square);
    EXPECT_GT(count.inside, 160 * 160 / 10) << motif.name;
    EXPECT_LT(count.outside, 160 * 160 / 50) << motif.name;  // a leaf's tip may stand out
  }
}

TEST(LabelMotif, NamesAreUniqueAndTheNearestIsOffered) {
  std::set<std::string_view> names;
  for (const assets::LabelMotif& motif : assets::label_motifs())
    EXPECT_TRUE(names.insert(motif.name).second) << motif.name;
  EXPECT_TRUE(assets::find_motif("coffee_bean", "x").ok());
  EXPECT_NE(assets::find_motif("coffee_been", "x").error().message.find("\"coffee_bean\""),
            std::string::npos);
}

TEST(BrandMark, EveryShapeDrawsInsideItsArea) {
  const assets::Area area{20, 20, 220, 80};
  for (std::size_t shape = 0; shape < assets::names_of(assets::MarkShape{}).size(); ++shape) {
    assets::BrandLook look = assets::brand_look("Meadowlark");
    look.shape = static_cast<assets::MarkShape>(shape);
    assets::Canvas canvas(260, 120, magenta);
    assets::draw_brand_mark(canvas, look, "Meadowlark", area, magenta);
    const Touched count = touched(canvas, area);
    EXPECT_GT(count.inside, 800) << assets::names_of(assets::MarkShape{})[shape];
    EXPECT_LT(count.outside, 150) << assets::names_of(assets::MarkShape{})[shape];
  }
}

TEST(BrandMark, DependsOnTheNameAloneAndNamesDiffer) {
  std::set<std::size_t> designs;
  std::set<int> shapes;
  for (int i = 0; i < 60; ++i) {
    const std::string brand = "Brand " + std::to_string(i);
    EXPECT_EQ(assets::brand_look(brand).design, assets::brand_look(brand).design);
    designs.insert(assets::brand_look(brand).design % assets::pack_designs().size());
    shapes.insert(static_cast<int>(assets::brand_look(brand).shape));
  }
  EXPECT_GE(designs.size(), 8U);
  EXPECT_GE(shapes.size(), 8U);
}

TEST(PackDesign, EveryOneGivesPlacesInsideTheFace) {
  const catalog::Product product = sample_products().at(5);
  const assets::PackArt art = assets::pack_art(product).value();
  for (const assets::Area& face :
       {assets::Area{0, 0, 60, 110}, assets::Area{0, 0, 90, 100}, assets::Area{0, 0, 200, 120}}) {
    for (const assets::PackDesign& design : assets::pack_designs()) {
      assets::Canvas canvas(200, 120, magenta);
      design.ground(canvas, art, face);
      const assets::FrontPlan plan = design.face(canvas, art, face);
      for (const assets::Area& place : {plan.brand, plan.name, plan.net}) {
        EXPECT_GT(place.w * place.h, 0) << design.name;
        EXPECT_GE(place.x, face.x) << design.name;
        EXPECT_LE(place.right(), face.right() + 1e-9) << design.name;
        EXPECT_LE(place.bottom(), face.bottom() + 1e-9) << design.name;
      }
      EXPECT_GE(plan.brand.w, 0.25 * face.w) << design.name;  // large enough to read 60 pixels wide
    }
  }
}

TEST(Barcode, EncodesThePublishedExample) {
  // 5 901234 123457: parity LGGLLG for the leading 5 (ISO/IEC 15420, also in every textbook).
  EXPECT_EQ(*assets::ean13_modules("5901234123457", "x"),
            "101"
            "0001011"
            "0100111"
            "0110011"
            "0010011"
            "0111101"
            "0011101"
            "01010"
            "1100110"
            "1101100"
            "1000010"
            "1011100"
            "1001110"
            "1000100"
            "101");
  EXPECT_EQ(assets::ean13_modules("5901234123458", "milk/ean").error().where,
            "milk/ean");  // wrong check digit
  EXPECT_FALSE(assets::ean13_modules("590123412345", "x").ok());
  EXPECT_FALSE(assets::ean13_modules("59012341234x7", "x").ok());
}

TEST(Barcode, BarsLieOnWholePixels) {  // every module of a row is black or white, exactly
  const std::string ean = "5901234123457";
  const std::string modules = *assets::ean13_modules(ean, "x");
  assets::Canvas canvas(300, 100, magenta);
  canvas.translate(0.37, 0.21);  // an odd transform must not blur the code
  const assets::BarcodePlace place = assets::place_barcode({0, 0, 300, 100}, 2, 70);
  assets::draw_barcode(canvas, modules, ean, place);
  const Image image = canvas.image();
  for (int i = 0; i < 95; ++i) {
    for (int k = 0; k < place.module_px; ++k) {
      const std::uint8_t* pixel = image.at(place.x + (11 + i) * place.module_px + k, place.y + 5);
      EXPECT_EQ(int{pixel[0]}, modules[static_cast<std::size_t>(i)] == '1' ? 0 : 255) << i;
    }
  }
}

TEST(Barcode, LiesDownWhereTheAreaIsHigh) {
  EXPECT_FALSE(assets::place_barcode({0, 0, 300, 200}, 2, 80).ladder);
  EXPECT_TRUE(assets::place_barcode({0, 0, 120, 400}, 2, 80).ladder);
  EXPECT_EQ(assets::place_barcode({0, 0, 120, 400}, 2, 80).module_px, 2);
  EXPECT_EQ(assets::place_barcode({0, 0, 60, 60}, 2, 80).module_px,
            0);  // no room for even one pixel a module
}

TEST(PackFacts, SmallPrintSuitsTheGoods) {
  std::vector<catalog::Product> products = sample_products();
  products.at(6).subcategory = "milk";
  products.at(22).subcategory = "oral care";
  const auto facts_of = [&](std::size_t i) {
    return assets::pack_facts(assets::pack_art(products.at(i)).value());
  };
  EXPECT_NE(facts_of(6).contents.find("MILK"), std::string::npos);
  EXPECT_EQ(facts_of(6).nutrition.size(), 7U);
  EXPECT_EQ(facts_of(0).nutrition.at(4).second, "0 g");  // cola without sugar
  EXPECT_TRUE(facts_of(22).nutrition.empty());           // toothpaste
  EXPECT_NE(facts_of(22).directions.find("Brush"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
