// Labels are drawn with three families of ours, whatever else the machine has.
#include "assets/print/fonts.h"

#include <fontconfig/fontconfig.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace marketgen {
namespace {

TEST(Fonts, OurFamiliesAndNoOthers) {
  EXPECT_TRUE(assets::missing_fonts().empty());
  const FcFontSet* machine = FcConfigGetFonts(assets::font_config(), FcSetSystem);
  EXPECT_TRUE(machine == nullptr || machine->nfont == 0);
  const FcFontSet* fonts = FcConfigGetFonts(assets::font_config(), FcSetApplication);
  ASSERT_NE(fonts, nullptr);
  std::set<std::string> families;
  for (int i = 0; i < fonts->nfont; ++i) {
    FcChar8* family = nullptr;
    ASSERT_EQ(FcPatternGetString(fonts->fonts[i], FC_FAMILY, 0, &family), FcResultMatch);
    families.emplace(reinterpret_cast<const char*>(family));
  }
  for (const char* wanted :
       {"DejaVu Sans", "DejaVu Sans Mono", "DejaVu Serif", "Lato", "Open Sans"}) {
    EXPECT_TRUE(families.contains(wanted)) << wanted;
  }
  for (const std::string& family : families) {
    EXPECT_TRUE(family.starts_with("DejaVu") || family.starts_with("Lato") ||
                family.starts_with("Open Sans"))
        << family;
  }
}

}  // namespace
}  // namespace marketgen
