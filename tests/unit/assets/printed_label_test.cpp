// Labels as printed: bars true to size and beside the picture, cards for offers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "assets/print/barcode.h"
#include "assets/print/label.h"
#include "assets/print/label_sheet.h"
#include "sample_products.h"

namespace marketgen {
namespace {

TEST(PrintedLabel, BarsHaveTheirNominalSizeWhereThereIsRoom) {
  for (const catalog::Product& product : sample_products()) {
    const assets::PrintedPicture label = assets::print_label(product, 2).value();
    const assets::SheetSize size = assets::sheet_size_of(product).value();
    EXPECT_EQ(label.picture.height, std::lround(double(size.height_m) * 1e3 * 2)) << product.name;
    ASSERT_EQ(label.bars.has_value(), !product.ean.empty()) << product.name;
    if (!label.bars) continue;
    const assets::LabelBars& bars = *label.bars;
    EXPECT_EQ(bars.modules, assets::ean13_modules(product.ean, "x").value());
    const float along =
        bars.ladder ? (bars.v1 - bars.v0) * size.height_m : (bars.u1 - bars.u0) * size.width_m;
    const float module_mm = along * 1e3F / 95;
    EXPECT_LE(module_mm, 0.331F) << product.name;  // GS1: X = 0.33 mm is nominal,
    EXPECT_GE(module_mm, 0.150F) << product.name;  // small packs go below the 0.264 mm it asks for
    EXPECT_GE(bars.u0, 0) << product.name;
    EXPECT_LE(bars.u1, 1) << product.name;
    EXPECT_GE(bars.v0, 0) << product.name;
    EXPECT_LE(bars.v1, 1) << product.name;
  }
}

TEST(PrintedLabel, WhiteSurroundsTheBarsAndGreyIsUnderThem) {
  const catalog::Product product = sample_products().at(5);
  const assets::PrintedPicture label = assets::print_label(product, 6).value();
  const assets::LabelBars& bars = label.bars.value();
  const auto pixel = [&](float u, float v) {
    return label.picture.at(static_cast<int>(u * static_cast<float>(label.picture.width)),
                            static_cast<int>(v * static_cast<float>(label.picture.height)));
  };
  EXPECT_EQ(*pixel((bars.u0 + bars.u1) / 2, (bars.v0 + bars.v1) / 2), 0xBC);
  const float quiet = bars.ladder ? (bars.v1 - bars.v0) * 5 / 95 : (bars.u1 - bars.u0) * 5 / 95;
  const std::uint8_t* beside = bars.ladder ? pixel((bars.u0 + bars.u1) / 2, bars.v0 - quiet)
                                           : pixel(bars.u0 - quiet, (bars.v0 + bars.v1) / 2);
  EXPECT_GE(*beside, 250);
}

TEST(PrintedLabel, BadScalesAreRefused) {
  const catalog::Product product = sample_products().at(0);
  EXPECT_EQ(assets::print_label(product, 0).error().code, "assets.bad_row");
  EXPECT_EQ(assets::print_label(product, 100).error().code, "assets.bad_row");
}

TEST(PriceTag, PrintedOneLeavesItsBarsOut) {
  const catalog::Product product = sample_products().at(0);
  const assets::PrintedPicture tag = assets::print_price_tag(product, true, 96).value();
  EXPECT_EQ(tag.bars.value().modules, assets::ean13_modules(product.ean, "x").value());
  EXPECT_FALSE(tag.bars->ladder);
  EXPECT_EQ(tag.picture.height, assets::draw_price_tag(product, true, 96)->height);
}

TEST(PromotionCard, IsYellowAndRedAndDiffersByProduct) {
  const auto products = sample_products();
  const Image card = assets::draw_promotion_card(products.at(0), 148).value();
  EXPECT_EQ(card.width, 210);  // 105 x 74 mm
  EXPECT_EQ(card.at(4, 60)[0], 0xFF);
  EXPECT_EQ(card.at(4, 60)[2], 0x1F);
  EXPECT_EQ(card.at(3, 3)[0], 0xD5);
  EXPECT_NE(card.pixels, assets::draw_promotion_card(products.at(1), 148)->pixels);
  EXPECT_EQ(assets::draw_promotion_card(products.at(0), 5).error().code, "assets.bad_row");
}

}  // namespace
}  // namespace marketgen
