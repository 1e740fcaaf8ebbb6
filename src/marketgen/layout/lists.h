// Names that a row of a table has.
#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

namespace marketgen::layout {

template <class Name>
bool lists(const std::vector<std::string_view>& names, const Name& name) {
  return std::ranges::find(names, std::string_view(name)) != names.end();
}

}  // namespace marketgen::layout
