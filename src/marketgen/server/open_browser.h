// The user's own browser.
#pragma once
#include <string>

namespace marketgen::server {

// Starts it at an address, to live on without us. False when the desktop has no way to do so.
bool open_browser(const std::string& address);

}  // namespace marketgen::server
