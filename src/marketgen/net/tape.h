// Exchanges in a folder: written as they happen, found again by what was asked.
//
// One JSON file an exchange, called <hash of method, URL, headers and body>-<n>.json: n counts
// equal requests. Secret headers are neither written nor hashed, so that a record made with a key
// answers one who has none. Pictures in a request (long base64) are hashed and not written: their
// place says how long they were and their hash.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "net/http.h"

namespace marketgen::net {

class HttpTape {
 public:
  enum class Mode { off, record, replay };
  // Errors: as HttpClient::open.
  static Result<std::unique_ptr<HttpTape>> open(const HttpOptions& options);

  Mode mode() const { return mode_; }
  // Where the next exchange with this request lies.
  std::filesystem::path next_place(const HttpRequest& request);

 private:
  HttpTape(Mode mode, std::filesystem::path folder) : mode_(mode), folder_(std::move(folder)) {}
  Mode mode_;
  std::filesystem::path folder_;
  std::mutex guard_;
  std::map<std::string, int> asked_;  // times, by hash
};

// Errors: io.cannot_write.
Result<void> write_exchange(const std::filesystem::path& place,
                            const HttpRequest& request,
                            const HttpAnswer& answer);
// Errors: net.not_recorded, net.bad_record, json.*, io.cannot_read.
Result<HttpAnswer> read_exchange(const std::filesystem::path& place, const HttpRequest& request);

}  // namespace marketgen::net
