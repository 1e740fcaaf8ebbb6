#include "assets/print/fonts.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/progress.h"
#include "io/installation.h"

namespace marketgen::assets {
namespace {

namespace fs = std::filesystem;

// MARKETGEN_FONTS_*: the folders that CMake found when this was built; a wheel and an installation
// have copies.
struct Family {
  const char *package, *folder, *file, *built_with;
};
constexpr Family families[] = {
    {"fonts-dejavu-core", "dejavu", "DejaVuSans.ttf", MARKETGEN_FONTS_DEJAVU},
    {"fonts-lato", "lato", "Lato-Regular.ttf", MARKETGEN_FONTS_LATO},
    {"fonts-open-sans", "open-sans", "OpenSans-Regular.ttf", MARKETGEN_FONTS_OPEN_SANS},
};

fs::path folder_of(const Family& family) {
  std::vector<fs::path> places;
  for (const fs::path& share : io::share_folders())
    places.push_back(share / "fonts" / family.folder);
  places.emplace_back(family.built_with);
  std::error_code failed;
  const auto found = std::ranges::find_if(
      places, [&](const fs::path& place) { return fs::exists(place / family.file, failed); });
  return found == places.end() ? fs::path() : *found;
}

// DejaVu Sans has the letters that the others lack.
constexpr char configuration[] =
    "<?xml version=\"1.0\"?><fontconfig>"
    "<match target=\"pattern\"><edit name=\"family\" mode=\"append_last\">"
    "<string>DejaVu Sans</string></edit></match></fontconfig>";

// File by file: of folders fontconfig would keep what it has read, in a cache that nobody checks.
void add_fonts(FcConfig* config) {
  for (const Family& family : families) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(family), failed))
      files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files)
      FcConfigAppFontAddFile(config, reinterpret_cast<const FcChar8*>(file.c_str()));
  }
}

FcConfig* make_font_config() {
  const std::vector<std::string> missing = missing_fonts();
  if (!missing.empty()) {
    log_warning(fmt::format("labels are drawn with the fonts of this machine, for want of {}",
                            fmt::join(missing, ", ")));
    return FcInitLoadConfigAndFonts();
  }
  FcConfig* config = FcConfigCreate();
  FcConfigParseAndLoadFromMemory(config, reinterpret_cast<const FcChar8*>(configuration), FcTrue);
  FcConfigBuildFonts(config);
  add_fonts(config);
  // A machine without fontconfig has no configuration of its own; Pango would complain of that.
  FcChar8* const own = FcConfigGetFilename(config, nullptr);
  if (own == nullptr) FcConfigSetCurrent(config);
  FcStrFree(own);
  return config;
}

}  // namespace

std::vector<std::string> missing_fonts() {
  std::vector<std::string> missing;
  for (const Family& family : families) {
    if (folder_of(family).empty()) missing.emplace_back(family.package);
  }
  return missing;
}

FcConfig* font_config() {
  static FcConfig* const config = make_font_config();
  return config;
}

}  // namespace marketgen::assets
