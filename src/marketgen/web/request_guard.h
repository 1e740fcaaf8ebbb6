// Who may ask the viewer's server, and how often: checked before any path is looked at.
//
// Another site's page in the same browser must not read a store: its requests carry another Origin,
// and a name that its owner points at this machine (DNS rebinding) another Host.
#pragma once
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "web/http_message.h"

namespace marketgen::web {

struct GuardRules {
  std::string host;   // as it was given: "127.0.0.1"
  int port = 0;       // that it listens on
  std::string token;  // empty: none is needed
  double requests_per_s = 500;
  double burst = 3000;     // requests at once: a page asks for many labels when it opens
  bool may_write = false;  // POST below /api/stores/N/edit/, /api/stores/N/drive/ and /api/make/
  double writes_per_s = 20, write_burst = 60;  // of the requests, those that post
};

class RequestGuard {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RequestGuard(GuardRules rules);

  // Nothing: let it pass. 403 for a foreign Host or Origin or a missing token, 405 for anything but
  // GET and HEAD (and POST of JSON where one may write), 429 for too many requests. Thread-safe.
  std::optional<HttpReply> refusal(const HttpAsk& ask, Clock::time_point now = Clock::now());
  // The same of a request's head, but for how often one may ask.
  std::optional<HttpReply> refusal_of_head(const HttpAsk& ask) const;

 private:
  bool is_own_host(std::string_view host) const;
  bool has_token(const HttpAsk& ask) const;
  // Fills with time, and is emptied by requests.
  struct Bucket {
    double per_s, most, tokens;
    Clock::time_point last;
  };
  bool is_write(const HttpAsk& ask) const;
  bool within_rate(Bucket& bucket, Clock::time_point now);

  GuardRules rules_;
  std::mutex mutex_;
  Bucket reads_, writes_;
};

}  // namespace marketgen::web
