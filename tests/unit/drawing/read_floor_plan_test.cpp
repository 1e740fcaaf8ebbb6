// Floor plans as text and pixels: units, names, shapes, and what is wrong with a file.
#include "drawing/floor_plan.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "drawing/sketch.h"
#include "geometry/image.h"
#include "io/png.h"

namespace marketgen {
namespace {

using drawing::Role;

// 24 x 15 m, in millimetres.
const std::string room = R"(<rect x="1000" y="1000" width="24000" height="15000"/>)";

std::string svg(
    const std::string& inner,
    const std::string& size = R"(width="26000mm" height="17000mm" viewBox="0 0 26000 17000")") {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" )" + size + ">" + inner + "</svg>";
}

std::string dxf(const std::string& entities, const std::string& header = "9\n$INSUNITS\n70\n4\n") {
  return "0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

std::string lwpolyline(const std::string& layer,
                       const std::vector<PointMm>& points,
                       const char* closed = "1") {
  std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n" + std::to_string(points.size()) +
                     "\n70\n" + closed + "\n";
  for (const PointMm& p : points)
    text += "10\n" + std::to_string(p[0]) + "\n20\n" + std::to_string(p[1]) + "\n";
  return text;
}

const std::string dxf_room = lwpolyline("0", {{0, 0}, {24000, 0}, {24000, 15000}, {0, 15000}});

Result<drawing::FloorPlan> read(const std::string& text, const std::string& scale = "") {
  drawing::ReadOptions options;
  if (!scale.empty()) options.scale = drawing::parse_scale(scale, "scale").value();
  return drawing::read_floor_plan_bytes(text, "plan", options);
}

std::string size_of(const Result<drawing::FloorPlan>& plan) {
  if (!plan.ok()) return to_string(plan.error());
  return std::to_string(plan->shell.width_mm) + "x" + std::to_string(plan->shell.depth_mm);
}

std::string code_of(const Result<drawing::FloorPlan>& plan) {
  return plan.ok() ? "" : plan.error().code;
}

bool warns(const drawing::FloorPlan& plan, const std::string& of) {
  return std::ranges::any_of(plan.warnings,
                             [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

TEST(FloorPlanUnits, OfAnSvgComeFromItsWidth) {
  EXPECT_EQ(size_of(read(svg(room))), "24000x15000");
  EXPECT_EQ(size_of(read(svg(room, R"(width="2600cm" height="1700cm" viewBox="0 0 26000 17000")"))),
            "24000x15000");
  EXPECT_EQ(size_of(read(svg(room, R"(width="260mm" height="170mm" viewBox="0 0 26000 17000")"),
                         "1:100")),
            "24000x15000");
  EXPECT_EQ(size_of(read(svg(room, R"(viewBox="0 0 26000 17000")"), "1 unit = 2 mm")),
            "48000x30000");
}

TEST(FloorPlanUnits, OfADxfComeFromItsHeader) {
  EXPECT_EQ(size_of(read(dxf(dxf_room))), "24000x15000");
  EXPECT_EQ(size_of(read(dxf(lwpolyline("0", {{0, 0}, {24, 0}, {24, 15}, {0, 15}}),
                             "9\n$INSUNITS\n70\n6\n"))),
            "24000x15000");
}

TEST(FloorPlanUnits, ThatAreMissingAreAskedFor) {
  for (const std::string& text :
       {svg(room, ""), dxf(dxf_room, ""), svg(room, R"(width="800px" height="600")")}) {
    const auto plan = read(text);
    EXPECT_EQ(code_of(plan), "drawing.no_scale");
    EXPECT_NE(plan.error().message.find("--floor-plan-scale"), std::string::npos);
  }
  // A sheet of paper as large as it is holds no floor.
  const auto sheet = read(svg(room, R"(width="260mm" height="170mm" viewBox="0 0 26000 17000")"));
  EXPECT_EQ(code_of(sheet), "drawing.no_outline");
  EXPECT_NE(sheet.error().message.find("--floor-plan-scale"), std::string::npos);
  drawing::ReadOptions by_size;
  by_size.width_mm = 36000;
  EXPECT_EQ(size_of(drawing::read_floor_plan_bytes(dxf(dxf_room, ""), "plan", by_size)),
            "36000x22500");
}

TEST(FloorPlanUnits, OfTheFlag) {
  const auto unit = [](const char* text) {
    return drawing::parse_scale(text, "scale").value().mm_per_unit;
  };
  EXPECT_DOUBLE_EQ(unit("10 mm"), 10);
  EXPECT_DOUBLE_EQ(unit("1 unit = 2cm"), 20);
  EXPECT_DOUBLE_EQ(unit("50 px = 1 m"), 20);
  EXPECT_DOUBLE_EQ(unit("1 unit = 1 ft"), 304.8);
  EXPECT_DOUBLE_EQ(drawing::parse_scale("1:50", "scale").value().of_paper, 50);
  for (const char* bad : {"", "10", "1 unit = 0 mm", "a:b", "mm", "1 unit = 5 parsecs"})
    EXPECT_FALSE(drawing::parse_scale(bad, "scale").ok()) << bad;
}

TEST(FloorPlanNames, AreEnglishGermanAndChinese) {
  for (const char* name : {"A-WALL-FULL", "walls", "Wände", "墙体", "Aussenwand"})
    EXPECT_EQ(drawing::role_of(name), Role::wall) << name;
  for (const char* name : {"A-DOOR", "Tuer 1", "Türen", "门", "emergency exit", "出口"})
    EXPECT_EQ(drawing::role_of(name), Role::door) << name;
  for (const char* name : {"A-GLAZ", "Windows", "Fenster", "窗户"})
    EXPECT_EQ(drawing::role_of(name), Role::window) << name;
  for (const char* name : {"S-COLS", "column-3", "Stützen", "柱子"})
    EXPECT_EQ(drawing::role_of(name), Role::column) << name;
  for (const char* name : {"A-WALL-DIMS", "A-ANNO-TEXT", "A-FURN", "墙体标注"})
    EXPECT_EQ(drawing::role_of(name), Role::ignored) << name;
  for (const char* name : {"0", "Layer 1", "drywallpaper"})
    EXPECT_EQ(drawing::role_of(name), Role::unknown) << name;
}

TEST(FloorPlanShapes, AnLWithADoorAndColumns) {
  const auto plan = read(dxf(
      lwpolyline("A-WALL",
                 {{0, 0}, {30000, 0}, {30000, 10000}, {18000, 10000}, {18000, 20000}, {0, 20000}}) +
      lwpolyline("A-DOOR", {{5000, -200}, {7000, -200}, {7000, 0}, {5000, 0}}) +
      lwpolyline("S-COLS", {{8800, 7800}, {9200, 7800}, {9200, 8200}, {8800, 8200}})));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  EXPECT_EQ(plan->shell.outline_mm.value_or(PolygonMm{}).size(), 6U);
  ASSERT_EQ(plan->shell.openings.size(), 1U);
  EXPECT_EQ(plan->shell.openings[0].kind, plan::OpeningKind::entrance);
  EXPECT_EQ(plan->shell.openings[0].wall, plan::Wall::south);
  EXPECT_EQ(plan->shell.openings[0].width_mm, 2000);
  EXPECT_NEAR(plan->shell.openings[0].center, 0.2, 1e-9);
  ASSERT_EQ(plan->shell.columns.size(), 1U);
  EXPECT_EQ(plan->shell.columns[0].x_mm, 9000);
  EXPECT_EQ(plan->shell.columns[0].size_mm, 400);
}

// A door in a wall that is no side of the bounds is found, and said to be left out.
TEST(FloorPlanShapes, ADoorInARecessIsToldOf) {
  const auto plan = read(dxf(
      lwpolyline("A-WALL",
                 {{0, 0}, {30000, 0}, {30000, 10000}, {18000, 10000}, {18000, 20000}, {0, 20000}}) +
      lwpolyline("A-DOOR", {{18000, 12000}, {18200, 12000}, {18200, 13500}, {18000, 13500}})));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  ASSERT_EQ(plan->openings.size(), 1U);
  EXPECT_FALSE(plan->openings[0].in_shell);
  EXPECT_TRUE(warns(*plan, "left out"));
}

TEST(FloorPlanShapes, AnOutlineThatCrossesItselfIsRefused) {
  const auto plan = read(svg(R"(<polygon points="1000,1000 25000,16000 25000,1000 1000,16000"/>)"));
  EXPECT_EQ(code_of(plan), "drawing.bad_outline");
}

TEST(FloorPlanShapes, OpenLinesAreNoFloor) {
  EXPECT_EQ(code_of(read(svg(R"(<polyline points="1000,1000 25000,1000 25000,16000"/>)"))),
            "drawing.no_outline");
  EXPECT_EQ(code_of(read(svg(""))), "drawing.no_outline");
}

TEST(FloorPlanFiles, ScriptsAndReferencesAreNeitherRunNorFetched) {
  const auto plan =
      read(svg(room + R"(<script>alert(1)</script><use href="http://127.0.0.1:1/x.svg#a"/>
      <image href="file:///etc/passwd"/>)"));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  EXPECT_TRUE(warns(*plan, "script"));
  EXPECT_TRUE(warns(*plan, "not fetched"));
  EXPECT_TRUE(warns(*plan, "<image>"));
}

TEST(FloorPlanFiles, EntitiesAndUsesDoNotExplode) {
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c <= 'j'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " \"";
    for (int i = 0; i < 10; ++i)
      bomb += std::string("&") + static_cast<char>(c - 1) + ";";
    bomb += "\">";
  }
  const auto plan = read(bomb + "]>" + svg(room + "<g id=\"&j;\"/>"));
  EXPECT_TRUE(plan.ok()) << to_string(plan.error());
  std::string uses = "<defs><g id=\"u0\"><path d=\"M0 0L1 1\"/></g>";
  for (int i = 1; i <= 8; ++i) {
    uses += "<g id=\"u" + std::to_string(i) + "\">";
    for (int k = 0; k < 40; ++k)
      uses += "<use href=\"#u" + std::to_string(i - 1) + "\"/>";
    uses += "</g>";
  }
  EXPECT_EQ(code_of(read(svg(room + uses + "</defs><use href=\"#u8\"/>"))), "drawing.bad_file");
  const auto itself = read(svg(room + "<g id=\"me\"><use href=\"#me\"/></g>"));
  ASSERT_TRUE(itself.ok()) << to_string(itself.error());
  EXPECT_TRUE(warns(*itself, "uses itself"));
}

TEST(FloorPlanFiles, ThatAreNoneAreRefusedWithARemedy) {
  for (const std::string& text : {std::string(),
                                  std::string("   \n"),
                                  std::string("GIF89a"),
                                  std::string("%PDF-1.4"),
                                  std::string("<svg><g"),
                                  std::string("<html/>"),
                                  std::string("AC1027 dwg"),
                                  std::string("AutoCAD Binary DXF\r\n"),
                                  std::string("0\nSECTION\nx\n"),
                                  dxf("")}) {
    const auto plan = read(text);
    EXPECT_EQ(code_of(plan), "drawing.bad_file") << text;
  }
}

TEST(FloorPlanFiles, ABlockInItselfIsRefused) {
  const std::string text =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n10\n0\n20\n0\n0\nINSERT\n2\nA\n10\n0\n20\n0\n0\nENDBL"
      "K\n0\nENDSEC\n" +
      dxf(dxf_room + "0\nINSERT\n2\nA\n10\n0\n20\n0\n");
  EXPECT_EQ(code_of(read(text)), "drawing.bad_file");
}

Image drawn_room(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool in = x >= 40 && y >= 40 && x < width - 40 && y < height - 40;
      const bool floor = x >= 52 && y >= 52 && x < width - 52 && y < height - 52;
      std::fill_n(image.at(x, y), 3, in && !floor ? std::uint8_t{0} : std::uint8_t{255});
    }
  }
  return image;
}

TEST(FloorPlanPictures, HaveTheScaleOfAFlagOrOfASize) {
  const std::string png = io::encode_png(drawn_room(704, 504)).value();
  EXPECT_EQ(size_of(read(png, "1 px = 40 mm")), "24000x16000");
  EXPECT_EQ(code_of(read(png)), "drawing.no_scale");
  drawing::ReadOptions by_size;
  by_size.width_mm = 30000;
  EXPECT_EQ(size_of(drawing::read_floor_plan_bytes(png, "plan", by_size)), "30000x20000");
}

TEST(FloorPlanPictures, ThatHoldNoFloorAreRefused) {
  EXPECT_EQ(code_of(read(io::encode_png(Image(1, 1)).value(), "10 mm")), "drawing.bad_file");
  EXPECT_FALSE(read(io::encode_png(Image(400, 400)).value(), "10 mm").ok());  // all black
  const std::string png = io::encode_png(drawn_room(704, 504)).value();
  EXPECT_EQ(code_of(read(png.substr(0, png.size() / 2), "10 mm")), "image.bad_file");
}

// 20,000 x 10,000 pixels: refused by its head.
TEST(FloorPlanPictures, OfTwoHundredMegapixelsAreRefused) {
  std::string png = io::encode_png(Image(64, 64)).value();
  png.replace(16, 8, std::string("\x00\x00\x4e\x20\x00\x00\x27\x10", 8));
  const auto plan = read(png, "10 mm");
  ASSERT_FALSE(plan.ok());
  EXPECT_TRUE(code_of(plan) == "input.too_large" || code_of(plan) == "image.bad_file")
      << to_string(plan.error());
}

}  // namespace
}  // namespace marketgen
