// Rows of one's own: a robot or tool that is no row of data/robots is named by its file's path,
// "mine/cart.json", as the working folder sees it; the file is named after the row's id.
#pragma once
#include <string_view>

namespace marketgen::robots {

inline bool is_row_file(std::string_view id) {
  return id.ends_with(".json");
}

}  // namespace marketgen::robots
