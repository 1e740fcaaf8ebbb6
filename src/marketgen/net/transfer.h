// One attempt at one URL, by libcurl: no repetition, no redirection.
#pragma once
#include <optional>
#include <string>

#include "net/http.h"

namespace marketgen::net {

struct Transfer {
  HttpAnswer answer;
  std::string redirect_url;             // where the answer sends us, absolute; empty: nowhere
  std::optional<double> retry_after_s;  // as the server asks
};

// What came of an attempt: an answer, or an error that says whether another attempt may help.
struct Attempt {
  Result<Transfer> transfer = Transfer{};
  bool passing = false;  // the connection failed or broke: it may work later
};

// `url` stands for request.url. Errors: net.bad_url, net.unreachable, net.timeout, net.too_large,
// internal.interrupted.
Attempt transfer_once(const HttpRequest& request, const std::string& url, const HttpLimits& limits);

}  // namespace marketgen::net
