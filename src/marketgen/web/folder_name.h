// Names that pages give to folders of new stores.
#pragma once
#include <string>

#include "base/result.h"

namespace marketgen::web {

// The last part of a path, and nothing that a path reads otherwise. Error: server.bad_request.
Result<void> check_folder_name(const std::string& name);

}  // namespace marketgen::web
