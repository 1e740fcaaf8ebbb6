// The page's own files: what viewer/ is built into.
#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"
#include "web/http_message.h"

namespace marketgen::server {

// $MARKETGEN_VIEWER, else viewer/dist of the installation or the source tree. Error:
// usage.unavailable when no page was built.
Result<std::filesystem::path> page_folder();

// The file at this path below `folder`; "/" is index.html. Errors: server.not_found, also for
// links that lead out of the folder; io.*.
Result<web::HttpReply> page_file(const std::filesystem::path& folder, const std::string& path);

}  // namespace marketgen::server
