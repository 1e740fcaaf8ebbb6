// What the report pages share: one file that loads nothing, light or dark as its reader has it.
#pragma once
#include <string>
#include <string_view>

namespace marketgen::store {

// A whole HTML page. `body` is markup, `title` a text, which is escaped. Classes that the page's
// style knows: tiles and tile, good, bad and warn, value, sub, plots, views, strips, bar, back and
// mark.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace marketgen::store
