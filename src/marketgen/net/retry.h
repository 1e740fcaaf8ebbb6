// When a request is repeated, and how long we wait before.
#pragma once
#include "net/http.h"

namespace marketgen::net {

// 429, and every 5xx but 501: the server may answer later.
bool is_worth_repeating(int status);

// Seconds before repetition `next` (the first is 1), when the server does not say: first_wait_s
// doubled each time, at most longest_wait_s, times a factor of 0.5 to 1 that URL, body and `next`
// decide. So clients that were refused together do not come back together, and one alone always
// waits alike.
double retry_pause_s(int next, const HttpRequest& request, const HttpLimits& limits);

}  // namespace marketgen::net
