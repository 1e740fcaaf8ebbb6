#include "web/folder_name.h"

#include <algorithm>

#include "base/text.h"

namespace marketgen::web {

Result<void> check_folder_name(const std::string& name) {
  const bool odd = std::ranges::any_of(name, [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '/' || c == '\\' || c == '\x7f';
  });
  if (name.empty() || name.front() == '.' || odd || !is_utf8(name))
    return Error{"server.bad_request",
                 "name",
                 "is the name of a new folder: letters, no slash, no dot in front"};
  return {};
}

}  // namespace marketgen::web
