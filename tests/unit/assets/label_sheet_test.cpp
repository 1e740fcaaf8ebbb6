// The label sheet: known nets, and what every sheet keeps.
#include "assets/print/label_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "assets/product_model.h"

namespace marketgen {
namespace {

catalog::Product pack(std::string_view archetype, std::array<int, 3> size_mm) {
  catalog::Product product;
  product.sku = "test";
  product.archetype = archetype;
  product.size_mm = size_mm;
  return product;
}

const assets::Panel& panel_named(const std::vector<assets::Panel>& panels, assets::PanelKind kind) {
  return *std::find_if(
      panels.begin(), panels.end(), [kind](const assets::Panel& p) { return p.kind == kind; });
}

TEST(LabelSheet, NetOfABox) {  // 200 x 100 x 300 mm unfolds to 600 x 400 mm
  const catalog::Product box = pack("box", {200, 100, 300});
  EXPECT_NEAR(assets::sheet_size_of(box).value().width_m, 0.6F, 1e-6F);
  EXPECT_NEAR(assets::sheet_size_of(box).value().height_m, 0.4F, 1e-6F);
  const std::vector<assets::Panel> panels = assets::panels_of(box).value();
  ASSERT_EQ(panels.size(), 6U);
  const assets::Panel& front = panel_named(panels, assets::PanelKind::front);
  EXPECT_NEAR(front.u0, 0, 1e-6);
  EXPECT_NEAR(front.u1, 1.0 / 3, 1e-6);
  EXPECT_NEAR(front.v0, 0.25, 1e-6);
  EXPECT_NEAR(front.v1, 1, 1e-6);
  const assets::Panel& right = panel_named(panels, assets::PanelKind::right);
  EXPECT_NEAR(right.u0, 1.0 / 3, 1e-6);
  EXPECT_NEAR(right.width_m, 0.1, 1e-6);
  EXPECT_NEAR(panel_named(panels, assets::PanelKind::back).u0, 0.5, 1e-6);
  EXPECT_NEAR(panel_named(panels, assets::PanelKind::top).v1, 0.25, 1e-6);
}

TEST(LabelSheet, BandOfACanIsItsCircumference) {
  const std::vector<assets::Panel> panels = assets::panels_of(pack("can", {66, 66, 115})).value();
  ASSERT_EQ(panels.size(), 1U);
  EXPECT_EQ(panels[0].kind, assets::PanelKind::band);
  EXPECT_NEAR(panels[0].width_m, std::numbers::pi * 0.066, 1e-4);
  EXPECT_EQ(panels[0].u0, 0.0F);
  EXPECT_EQ(panels[0].u1, 1.0F);
}

TEST(LabelSheet, PanelsLieOnTheSheetApartAndInOneScale) {
  for (const assets::ArchetypeInfo& info : assets::archetypes()) {
    for (const std::array<int, 3> size :
         {std::array{66, 66, 115}, std::array{300, 200, 40}, std::array{60, 180, 300}}) {
      const catalog::Product product = pack(info.name, size);
      const std::vector<assets::Panel> panels = assets::panels_of(product).value();
      const assets::SheetSize sheet = assets::sheet_size_of(product).value();
      for (const assets::Panel& p : panels) {
        EXPECT_GE(std::min(p.u0, p.v0), -1e-6F) << info.name;
        EXPECT_LE(std::max(p.u1, p.v1), 1 + 1e-6F) << info.name;
        EXPECT_NEAR((p.u1 - p.u0) * sheet.width_m, p.width_m, 1e-5F) << info.name;
        EXPECT_NEAR((p.v1 - p.v0) * sheet.height_m, p.height_m, 1e-5F) << info.name;
        EXPECT_GT(std::min(p.width_m, p.height_m), 0.0F) << info.name;
        for (const assets::Panel& q : panels) {
          const bool apart = p.u1 <= q.u0 + 1e-6F || q.u1 <= p.u0 + 1e-6F || p.v1 <= q.v0 + 1e-6F ||
                             q.v1 <= p.v0 + 1e-6F;
          EXPECT_TRUE(p.kind == q.kind || apart) << info.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace marketgen
