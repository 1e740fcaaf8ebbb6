// Text of others on a terminal or in a log.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace marketgen {

// One line that is safe to show, whatever a file or a server put into `text`: control characters,
// line breaks, marks that turn the direction of writing, invisible ones and bytes that are no UTF-8
// stand as \n, \x1b, \u202e; what is longer than `max_characters` loses its middle. Whoever shows
// text that is not the program's own passes it through here.
std::string safe_line(std::string_view text, std::size_t max_characters = 1000);

}  // namespace marketgen
