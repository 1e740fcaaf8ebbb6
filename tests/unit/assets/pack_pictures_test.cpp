// Packs that show photographs: what lies where on the sheet, known from how the pack is seen.
#include "assets/print/pack_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/print/label.h"
#include "assets/print/label_sheet.h"
#include "assets/product_model.h"
#include "assets/shapes/archetypes/label_zone.h"
#include "catalog/own_faces.h"
#include "support/face_pictures.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

constexpr int front_blue = 10, back_blue = 60, left_blue = 110, right_blue = 160, top_blue = 210,
              bottom_blue = 250;

class PackPictures : public testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", (scratch_.path() / "cache").c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  // A row of that shape with the pictures, two pixels a millimetre of what they show.
  Result<catalog::Product> pack(const std::string& archetype,
                                std::array<int, 3> size_mm,
                                const std::vector<std::pair<std::string, Image>>& pictures) const {
    catalog::Product product;
    product.sku = "own-pack";
    product.name = "Pack";
    product.archetype = archetype;
    product.size_mm = size_mm;
    product.faces.emplace();
    for (const auto& [side, picture] : pictures) {
      write_png_face(scratch_.path() / (side + ".png"), picture);
      const auto* slot = std::ranges::find(catalog::face_slots, side, &catalog::FaceSlot::name);
      (*product.faces).*slot->file = side + ".png";
    }
    MARKETGEN_CHECK(catalog::keep_faces(product, scratch_.path(), "own.json:own-pack"));
    return product;
  }

  ScratchFolder scratch_;
};

assets::Panel panel_of(const catalog::Product& product, assets::PanelKind kind) {
  for (const assets::Panel& panel : assets::panels_of(product).value()) {
    if (panel.kind == kind) return panel;
  }
  ADD_FAILURE() << "no such panel";
  return {};
}

// The sheet's colour at a share of the panel's width and height.
Rgb8 at(const Image& sheet, const assets::Panel& panel, double x, double y) {
  const auto pixel = [](double from, double to, double share, int length) {
    return std::clamp(static_cast<int>((from + (to - from) * share) * length), 0, length - 1);
  };
  const std::uint8_t* p = sheet.at(pixel(panel.u0, panel.u1, x, sheet.width),
                                   pixel(panel.v0, panel.v1, y, sheet.height));
  return {p[0], p[1], p[2]};
}

// That the pixel shows this place of the graded picture with that blue.
void expect_place(Rgb8 color, double x, double y, int blue, const std::string& what) {
  constexpr double rounding = 4;  // of 255: a pixel of the sheet, and the pack's rounded edges
  EXPECT_NEAR(color.r, 20 + 200 * x, rounding) << what;
  EXPECT_NEAR(color.g, 20 + 200 * y, rounding) << what;
  EXPECT_NEAR(color.b, blue, 2) << what;
}

// Every side of a carton upright and unmirrored on its own panel of the net.
TEST_F(PackPictures, EachFaceOfABoxLiesOnItsPanel) {
  const auto box = pack("box",
                        {120, 60, 180},
                        {{"front", graded_picture(240, 360, front_blue)},
                         {"back", graded_picture(240, 360, back_blue)},
                         {"left", graded_picture(120, 360, left_blue)},
                         {"right", graded_picture(120, 360, right_blue)},
                         {"top", graded_picture(240, 120, top_blue)},
                         {"bottom", graded_picture(240, 120, bottom_blue)}});
  ASSERT_TRUE(box.ok()) << to_string(box.error());
  const auto sheet = assets::draw_label(*box, 512);
  ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
  const std::vector<std::pair<assets::PanelKind, int>> blues{
      {assets::PanelKind::front, front_blue},
      {assets::PanelKind::back, back_blue},
      {assets::PanelKind::left, left_blue},
      {assets::PanelKind::right, right_blue},
      {assets::PanelKind::top, top_blue},
      {assets::PanelKind::bottom, bottom_blue}};
  for (const auto& [kind, blue] : blues) {
    for (const auto& [x, y] : {std::pair{0.1, 0.1}, {0.9, 0.1}, {0.1, 0.9}, {0.5, 0.5}})
      expect_place(at(*sheet, panel_of(*box, kind), x, y), x, y, blue, std::string(name_of(kind)));
  }
}

// The middle of the front of a can is the middle of its picture; towards its outline the picture is
// taken from ever further out, as a photograph sees a round pack.
TEST_F(PackPictures, TheSidesOfACanGoRoundItInOrder) {
  const auto can = pack("can",
                        {66, 66, 115},
                        {{"front", graded_picture(132, 230, front_blue)},
                         {"back", graded_picture(132, 230, back_blue)},
                         {"left", graded_picture(132, 230, left_blue)},
                         {"right", graded_picture(132, 230, right_blue)}});
  ASSERT_TRUE(can.ok()) << to_string(can.error());
  const auto sheet = assets::draw_label(*can, 512);
  ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
  const assets::Panel band = panel_of(*can, assets::PanelKind::band);
  const assets::LabelZone zone = assets::label_zone_of(*can);
  const double height = can->height_m();
  const auto down = [&](double v) {  // on the picture, at a share of the band
    const double z = zone.high_m + (zone.low_m - zone.high_m) * v;
    return (height - z) / height;
  };
  const auto across = [](double turn) {  // of a turn away from the picture's own direction
    return 0.5 + 0.5 * std::sin(2 * std::numbers::pi * turn);
  };
  for (const double turn : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
    const auto seen = [&](double u) { return at(*sheet, band, u - std::floor(u), 0.5); };
    expect_place(seen(0.5 + turn), across(turn), down(0.5), front_blue, "front");
    expect_place(seen(0.25 + turn), across(turn), down(0.5), left_blue, "left");
    expect_place(seen(0.75 + turn), across(turn), down(0.5), right_blue, "right");
    expect_place(seen(1 + turn), across(turn), down(0.5), back_blue, "back");
  }
  for (const double v : {0.05, 0.3, 0.95})
    expect_place(at(*sheet, band, 0.5, v), 0.5, down(v), front_blue, "front");
}

TEST_F(PackPictures, AWrapIsTheWholeLabel) {
  const auto jar = pack("jar", {70, 70, 120}, {{"wrap", graded_picture(660, 240, 99)}});
  ASSERT_TRUE(jar.ok()) << to_string(jar.error());
  const auto sheet = assets::draw_label(*jar, 512);
  ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
  for (const double share : {0.02, 0.25, 0.5, 0.75, 0.98})
    expect_place(at(*sheet, panel_of(*jar, assets::PanelKind::band), share, 1 - share),
                 share,
                 1 - share,
                 99,
                 "wrap");
}

TEST_F(PackPictures, AWrappedTubHasItsLidToo) {
  const auto tub =
      pack("tub",
           {95, 95, 70},
           {{"wrap", graded_picture(900, 180, 99)}, {"top", graded_picture(190, 190, top_blue)}});
  ASSERT_TRUE(tub.ok()) << to_string(tub.error());
  const auto sheet = assets::draw_label(*tub, 512);
  ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
  EXPECT_EQ(at(*sheet, panel_of(*tub, assets::PanelKind::band), 0.3, 0.6).b, 99);
  const Rgb8 middle = at(*sheet, panel_of(*tub, assets::PanelKind::top), 0.5, 0.5);
  expect_place(middle, 0.5, 0.5, top_blue, "lid");
}

// The face of a bag as it is seen from before it: its middle is the picture's.
TEST_F(PackPictures, ABagHasAFrontAndABack) {
  for (const char* shape : {"pouch", "pillow_bag", "paper_bag"}) {
    const auto bag = pack(shape,
                          {160, 70, 240},
                          {{"front", graded_picture(320, 480, front_blue)},
                           {"back", graded_picture(320, 480, back_blue)}});
    ASSERT_TRUE(bag.ok()) << to_string(bag.error());
    const auto sheet = assets::draw_label(*bag, 512);
    ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
    for (const auto& [kind, blue] :
         {std::pair{assets::PanelKind::front, front_blue}, {assets::PanelKind::back, back_blue}}) {
      const assets::Panel panel = panel_of(*bag, kind);
      EXPECT_EQ(at(*sheet, panel, 0.5, 0.5).b, blue) << shape;
      EXPECT_NEAR(at(*sheet, panel, 0.5, 0.5).r, 120, 6) << shape;
      EXPECT_LT(at(*sheet, panel, 0.2, 0.5).r, 90) << shape;  // not mirrored
      EXPECT_GT(at(*sheet, panel, 0.8, 0.5).r, 150) << shape;
      EXPECT_LT(at(*sheet, panel, 0.5, 0.25).g, 100) << shape;  // upright
      EXPECT_GT(at(*sheet, panel, 0.5, 0.75).g, 140) << shape;
    }
  }
}

// Every shape with print shows its pictures where its mesh says that it is printed: looked at from
// the front, a point has the colour of what lies before it.
TEST_F(PackPictures, EveryShapeSeenFromTheFrontIsItsPicture) {
  int shapes = 0;
  for (const assets::ArchetypeInfo& shape : assets::archetypes()) {
    const auto kind = assets::sheet_kind_of(shape.name);
    ASSERT_TRUE(kind.ok());
    if (*kind == assets::SheetKind::skin) continue;
    SCOPED_TRACE(shape.name);
    ++shapes;
    const auto product = pack(
        std::string(shape.name), {120, 90, 150}, {{"front", graded_picture(240, 300, front_blue)}});
    ASSERT_TRUE(product.ok()) << to_string(product.error());
    const auto sheet = assets::draw_label(*product, 512);
    ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
    const assets::ProductModel model = assets::make_product_model(*product).value();
    const assets::Panel* facing = nullptr;
    const std::vector<assets::Panel> panels = assets::panels_of(*product).value();
    for (const assets::Panel& panel : panels) {
      if (panel.kind == assets::PanelKind::front || panel.kind == assets::PanelKind::band)
        facing = &panel;
    }
    ASSERT_NE(facing, nullptr);
    int looked = 0;
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
      if (model.surfaces[model.mesh.surfaces[t]].texture != "label") continue;
      Vec3f middle{0, 0, 0}, normal{0, 0, 0};
      Vec2f uv{0, 0};
      for (const std::uint32_t vertex : model.mesh.triangles[t]) {
        middle = middle + model.mesh.positions[vertex] * (1.0F / 3);
        normal = normal + model.mesh.normals[vertex] * (1.0F / 3);
        uv = uv + model.mesh.uvs[vertex] * (1.0F / 3);
      }
      const bool on_front =
          uv.x >= facing->u0 && uv.x <= facing->u1 && uv.y >= facing->v0 && uv.y <= facing->v1;
      if (!on_front || normal.y > -0.9F) continue;
      ++looked;
      const std::uint8_t* pixel =
          sheet->at(static_cast<int>(uv.x * static_cast<float>(sheet->width)),
                    static_cast<int>(uv.y * static_cast<float>(sheet->height)));
      EXPECT_NEAR(pixel[0], 20 + 200 * (middle.x / 0.12F + 0.5F), 5);
      EXPECT_NEAR(pixel[1], 20 + 200 * (1 - middle.z / 0.15F), 5);
      EXPECT_EQ(pixel[2], front_blue);
    }
    EXPECT_GT(looked, 0);
  }
  EXPECT_GE(shapes, 50);
}

TEST_F(PackPictures, AMissingSideHasTheOppositeOneOrTheGround) {
  const auto box = pack("box",
                        {120, 60, 180},
                        {{"front", plain_picture(240, 360, {200, 30, 40})},
                         {"left", graded_picture(120, 360, left_blue)}});
  ASSERT_TRUE(box.ok()) << to_string(box.error());
  EXPECT_EQ(box->label.primary, "#c81e28");  // the border of the front
  const auto sheet = assets::draw_label(*box, 512);
  ASSERT_TRUE(sheet.ok()) << to_string(sheet.error());
  const auto seen = [&](assets::PanelKind kind, double x, double y) {
    return at(*sheet, panel_of(*box, kind), x, y);
  };
  const Rgb8 ground{200, 30, 40};
  EXPECT_EQ(seen(assets::PanelKind::back, 0.3, 0.3), ground);  // the front's
  EXPECT_EQ(seen(assets::PanelKind::top, 0.3, 0.3), ground);   // neither top nor bottom: ground
  EXPECT_EQ(seen(assets::PanelKind::bottom, 0.3, 0.3), ground);
  expect_place(seen(assets::PanelKind::right, 0.2, 0.7), 0.2, 0.7, left_blue, "right as left");
}

// A row that names its ground colour keeps it.
TEST_F(PackPictures, TheRowsOwnGroundColourStays) {
  catalog::Product product =
      pack("box", {120, 60, 180}, {{"front", plain_picture(240, 360, {})}}).value();
  EXPECT_EQ(product.label.primary, "#000000");
  product.label.primary = "#0a0b0c";
  const Image sheet = assets::draw_label(product, 256).value();
  EXPECT_EQ(at(sheet, panel_of(product, assets::PanelKind::left), 0.5, 0.5), (Rgb8{10, 11, 12}));
}

TEST_F(PackPictures, TheSameAtEverySizeAndEveryTime) {
  const catalog::Product can =
      pack("can", {66, 66, 115}, {{"front", graded_picture(132, 230, front_blue)}}).value();
  const Image sheet = assets::draw_label(can, 512).value();
  EXPECT_EQ(sheet.pixels, assets::draw_label(can, 512).value().pixels);
  const assets::PrintedPicture small = assets::print_label(can, 1).value();
  EXPECT_FALSE(small.bars.has_value());  // its code is somewhere on the photographs
  const assets::Panel band = panel_of(can, assets::PanelKind::band);
  const Rgb8 near = at(sheet, band, 0.45, 0.4), far = at(small.picture, band, 0.45, 0.4);
  EXPECT_NEAR(near.r, far.r, 4);
  EXPECT_NEAR(near.g, far.g, 4);
}

TEST_F(PackPictures, WhatDoesNotFitIsToldOrRefused) {
  const auto fault = [&](const std::string& archetype,
                         const std::vector<std::pair<std::string, Image>>& pictures) {
    const auto product = pack(archetype, {100, 100, 100}, pictures);
    if (!product.ok()) return to_string(product.error());
    const auto checked = assets::check_faces(*product);
    EXPECT_EQ(assets::draw_label(*product, 64).ok(), checked.ok());
    return checked.ok() ? std::string() : to_string(checked.error());
  };
  const auto expect_says = [](const std::string& text, const std::string& says) {
    EXPECT_NE(text.find(says), std::string::npos) << text;
  };
  const Image square = graded_picture(100, 100, 0);
  expect_says(fault("apple", {{"front", square}}), "assets.bad_row");
  expect_says(fault("apple", {{"front", square}}), "shapes that do: can, food_tin");
  expect_says(fault("mesh", {{"front", square}}), "a mesh has pictures of its own");
  expect_says(fault("can", {{"top", square}}), "it takes front, back, left, right, wrap");
  expect_says(fault("pouch", {{"left", square}}), "it takes front, back");
  expect_says(fault("can", {{"front", square}, {"wrap", graded_picture(314, 95, 0)}}),
              "give the one or the others");
  expect_says(fault("box", {{"front", graded_picture(210, 100, 0)}}),
              "own-pack/faces/front: a picture of 210 x 100 pixels is 2.1 times as wide");
  expect_says(fault("box", {{"front", graded_picture(100, 210, 0)}}), "2.1 times as high");
  expect_says(fault("box", {}), "names no picture");
  EXPECT_EQ(fault("box", {{"front", graded_picture(190, 100, 0)}}), "");
  const catalog::Product wide =
      pack("box", {100, 100, 100}, {{"front", graded_picture(120, 100, 0)}, {"top", square}})
          .value();
  const auto fits = assets::face_fits(wide, assets::kept_pixels(wide).value());
  const std::vector<std::string> notes = assets::face_notes(fits.value());
  ASSERT_EQ(notes.size(), 1U);
  expect_says(notes[0], "the picture of the front is 1.2 times as wide for its height");
}

}  // namespace
}  // namespace marketgen
