#include "net/retry.h"

#include <algorithm>

#include "base/hash.h"
#include "base/seed.h"

namespace marketgen::net {

bool is_worth_repeating(int status) {
  return status == 429 || (status >= 500 && status != 501);
}

double retry_pause_s(int next, const HttpRequest& request, const HttpLimits& limits) {
  Stream draw = Seed(hash64(request.body, hash64(request.url)))
                    .child("http_retry", static_cast<std::uint64_t>(next))
                    .stream();
  double pause = limits.first_wait_s;
  for (int i = 1; i < next; ++i)
    pause = std::min(2 * pause, limits.longest_wait_s);
  return std::min(pause, limits.longest_wait_s) * draw.uniform(0.5, 1.0);
}

}  // namespace marketgen::net
