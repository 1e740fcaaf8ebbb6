// `marketgen view`: stores in a browser, until the program is interrupted.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::server {

struct ServeOptions {
  std::vector<std::string> folders;
  std::vector<std::string> results;  // folders of evaluations in these stores
  std::string host = "127.0.0.1";
  int port = 0;       // 0: any free one
  std::string token;  // needed for a host other than loopback
};

// Calls `opened` with the address once it answers, then serves until it is interrupted, and returns
// that. Errors: usage.bad_flag (a host without a token, a host that is no numeric address),
// usage.unavailable (no page), server.cannot_listen; those of open_stores and Viewer::open.
Result<void> serve(const ServeOptions& options,
                   catalog::Catalog rows,
                   const std::function<void(const std::string&)>& opened);

}  // namespace marketgen::server
