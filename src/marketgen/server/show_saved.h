// How a store that a page has saved comes among those that are shown.
#pragma once
#include <filesystem>
#include <functional>

#include "base/result.h"

namespace marketgen::server {

// Opens a folder that was saved; the number it has in addresses.
using ShowSaved = std::function<Result<int>(const std::filesystem::path&)>;

}  // namespace marketgen::server
