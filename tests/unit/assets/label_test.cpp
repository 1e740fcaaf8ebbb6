// Labels, price tags and signs: the same row gives the same pixels, everything draws, outside
// readers read the codes.
#include "assets/print/label.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <thread>

#include "assets/print/label_sheet.h"
#include "base/seed.h"
#include "image_steps.h"
#include "io/png.h"
#include "sample_products.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

// What a shell command prints.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> buffer{};
  while (pipe != nullptr) {
    const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe.get());
    if (count == 0) break;
    output.append(buffer.data(), count);
  }
  return output;
}

std::set<std::string> eans_read_by_zbar(const std::filesystem::path& folder) {
  const std::string read = output_of("zbarimg -q --raw -Sdisable -Sean13.enable '" +
                                     folder.string() + "'/*.png 2>/dev/null");
  std::set<std::string> eans;
  for (std::size_t start = 0; start + 13 <= read.size(); start = read.find('\n', start) + 1) {
    eans.insert(read.substr(start, 13));
    if (read.find('\n', start) == std::string::npos) break;
  }
  return eans;
}

bool has_zbar() {
  return !output_of("command -v zbarimg").empty();
}

std::set<std::array<int, 3>> colors_of(const Image& image) {
  std::set<std::array<int, 3>> colors;
  for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
    colors.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
  }
  return colors;
}

// Mean absolute difference of two columns.
TEST(Label, SameRowGivesSamePixelsFromFourThreads) {
  const std::vector<catalog::Product> products = sample_products();
  std::array<std::vector<Image>, 4> drawn;
  std::vector<std::thread> threads;
  for (std::vector<Image>& images : drawn) {
    threads.emplace_back([&images, &products] {
      for (const catalog::Product& product : products)
        images.push_back(assets::draw_label(product, 128).value());
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < products.size(); ++i) {
    for (const std::vector<Image>& images : drawn) {
      EXPECT_EQ(images.at(i).pixels, drawn[0].at(i).pixels) << products[i].sku;
    }
  }
}

TEST(Label, PixelsAreSquareOnThePack) {  // print is not stretched
  for (const catalog::Product& product : sample_products()) {
    const Image image = assets::draw_label(product, 400).value();
    const assets::SheetSize size = assets::sheet_size_of(product).value();
    const double px_per_m_x = image.width / static_cast<double>(size.width_m);
    const double px_per_m_y = image.height / static_cast<double>(size.height_m);
    EXPECT_NEAR(px_per_m_x / px_per_m_y, 1.0, 0.01) << product.sku;
    EXPECT_LE(image.height, 400);
  }
}

TEST(Label, EveryPanelIsPrinted) {  // more than a flat colour on each
  for (const catalog::Product& product : sample_products()) {
    const Image image = assets::draw_label(product, 256).value();
    const std::vector<assets::Panel> panels = assets::panels_of(product).value();
    for (const assets::Panel& panel : panels) {
      std::set<std::array<int, 3>> colors;
      for (int y = static_cast<int>(panel.v0 * static_cast<float>(image.height));
           y < static_cast<int>(panel.v1 * static_cast<float>(image.height));
           ++y) {
        for (int x = static_cast<int>(panel.u0 * static_cast<float>(image.width));
             x < static_cast<int>(panel.u1 * static_cast<float>(image.width));
             ++x) {
          const std::uint8_t* pixel = image.at(x, y);
          colors.insert({pixel[0], pixel[1], pixel[2]});
        }
      }
      EXPECT_GT(colors.size(), 8U)
          << product.sku << " panel "
          << assets::names_of(panel.kind)[static_cast<std::size_t>(panel.kind)];
    }
  }
}

TEST(Label, DrawsPacksOfAnySizeAtAnyResolution) {  // flat, thin, tiny, huge: never an error
  Stream draw = Seed(11).stream();
  const std::vector<catalog::Product> samples = sample_products();
  for (int round = 0; round < 240; ++round) {
    catalog::Product product = samples.at(static_cast<std::size_t>(round) % samples.size());
    for (int& side : product.size_mm)
      side = draw.integer(12, draw.chance(0.3) ? 900 : 120);
    if (!assets::panels_of(product).ok()) continue;  // a shape that the archetype cannot have
    const Result<Image> image = assets::draw_label(product, draw.integer(16, 160));
    ASSERT_TRUE(image.ok()) << to_string(image.error()) << " " << product.archetype << " "
                            << product.size_mm[0] << "x" << product.size_mm[1] << "x"
                            << product.size_mm[2];
  }
}

TEST(Label, AnOutsideReaderReadsTheEanOnTheSheet) {
  if (!has_zbar()) GTEST_SKIP() << "zbarimg (package zbar-tools) is not installed";
  const ScratchFolder scratch;
  std::set<std::string> printed;
  for (const catalog::Product& product : sample_products()) {
    if (*assets::sheet_kind_of(product.archetype) == assets::SheetKind::skin)
      continue;  // loose: no code
    ASSERT_TRUE(
        io::write_png(scratch.path() / (product.sku + ".png"), assets::draw_label(product).value())
            .ok());
    printed.insert(product.ean);
  }
  ASSERT_GE(printed.size(), 20U);
  const std::set<std::string> read = eans_read_by_zbar(scratch.path());
  for (const std::string& ean : read)
    EXPECT_TRUE(printed.contains(ean)) << ean;
  std::string missed;
  for (const std::string& ean : printed)
    missed += read.contains(ean) ? "" : " " + ean;
  EXPECT_GE(read.size(), printed.size() * 98 / 100) << "not read:" << missed;
}

TEST(Label, BrandAndCodeShowInThePicture) {
  const catalog::Product first = sample_products().at(0);
  catalog::Product second = first;
  second.sku = "beverages-other";
  second.ean = with_check_digit("200099999999");
  catalog::Product other_brand = first;
  other_brand.brand = "Kurano";
  const Image a = assets::draw_label(first, 256).value();
  EXPECT_NE(a.pixels, assets::draw_label(second, 256).value().pixels);       // another code
  EXPECT_NE(a.pixels, assets::draw_label(other_brand, 256).value().pixels);  // another mark
}

TEST(Label, SkinJoinsWhereItMeetsItself) {
  for (const auto& [name, archetype] : {std::pair{"Apple", "round_produce"},
                                        std::pair{"Carrot", "elongated_produce"},
                                        std::pair{"Watermelon", "round_produce"},
                                        std::pair{"Lettuce", "leafy_produce"}}) {
    const Image skin = assets::draw_label(loose_produce(name, archetype), 256).value();
    double typical = 0;
    for (int x = 1; x < skin.width; ++x)
      typical = std::max(typical, column_difference(skin, x - 1, x));
    EXPECT_LE(column_difference(skin, skin.width - 1, 0), typical) << name;
    EXPECT_GT(colors_of(skin).size(), 200U) << name;
  }
}

TEST(Label, RefusesBadRowsWithPlaceAndRemedy) {
  catalog::Product product = sample_products().at(0);
  product.label.motif = "aple";
  EXPECT_EQ(assets::draw_label(product).error().code, "assets.bad_row");
  EXPECT_NE(assets::draw_label(product).error().message.find("\"apple\""), std::string::npos);
  product = sample_products().at(0);
  product.label.accent = "red";
  EXPECT_EQ(assets::draw_label(product).error().where, product.sku + "/label/accent");
  product = sample_products().at(0);
  product.ean = "2000000000000";  // its check digit would be 8
  EXPECT_EQ(assets::draw_label(product).error().where, product.sku + "/ean");
  EXPECT_FALSE(assets::draw_label(sample_products().at(0), 4).ok());
}

TEST(PriceTag, AnOutsideReaderReadsItsCode) {
  if (!has_zbar()) GTEST_SKIP() << "zbarimg (package zbar-tools) is not installed";
  const ScratchFolder scratch;
  const catalog::Product product = sample_products().at(0);
  ASSERT_TRUE(
      io::write_png(scratch.path() / "tag.png", assets::draw_price_tag(product, true, 192).value())
          .ok());
  EXPECT_EQ(eans_read_by_zbar(scratch.path()), std::set<std::string>{product.ean});
}

TEST(PriceTag, PromotionIsYellowAndBothArePrinted) {
  const catalog::Product product = sample_products().at(0);
  const Image plain = assets::draw_price_tag(product, false).value();
  const Image promotion = assets::draw_price_tag(product, true).value();
  EXPECT_EQ(plain.height, 96);
  EXPECT_EQ(colors_of(plain).count({0xff, 0xd9, 0x1f}), 0U);
  EXPECT_EQ(colors_of(promotion).count({0xff, 0xd9, 0x1f}), 1U);
  EXPECT_GT(colors_of(plain).size(), 20U);
  EXPECT_TRUE(assets::draw_price_tag(loose_produce("Banana", "elongated_produce"), false).ok());
}

TEST(Sign, FillsItsSizeAndRefusesBadInput) {
  const Image sign = assets::draw_sign("Fruit & Vegetables", "#2e7d32", "#ffffff", 400, 80).value();
  EXPECT_EQ(sign.width, 400);
  EXPECT_EQ(sign.height, 80);
  EXPECT_EQ(colors_of(sign).count({255, 255, 255}), 1U);
  EXPECT_EQ(assets::draw_sign("x", "green", "#ffffff", 400, 80).error().where, "sign/ground_color");
  EXPECT_EQ(assets::draw_sign("\xff", "#2e7d32", "#ffffff", 400, 80).error().code,
            "input.not_utf8");
  EXPECT_FALSE(assets::draw_sign("x", "#2e7d32", "#ffffff", 0, 80).ok());
}

}  // namespace
}  // namespace marketgen
