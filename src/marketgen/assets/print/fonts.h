// The fonts of labels and pictures: our own three families from known files, whatever else a
// machine has installed or configured. So the same text is the same pixels everywhere.
#pragma once
#include <string>
#include <vector>

struct _FcConfig;

namespace marketgen::assets {

// Families whose files are nowhere, by their Debian packages: fonts-lato. None in a sound
// installation.
std::vector<std::string> missing_fonts();

// Fontconfig's view of those files alone; where one is missing, of the whole machine. Made once,
// lives as long as the process.
_FcConfig* font_config();

}  // namespace marketgen::assets
