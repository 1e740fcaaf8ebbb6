// A server on this machine that plays a script (support/mock_http_server.py), for as long as it is
// in scope.
#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "support/run_program.h"

namespace marketgen {

class MockServer {
 public:
  // `steps` as the script describes them.
  explicit MockServer(const nlohmann::json& steps) {
    const std::filesystem::path root = MARKETGEN_SOURCE_DIR;
    std::ofstream(scratch_.path() / "script.json") << steps.dump();
    std::error_code ignored;
    const std::filesystem::path ours = root / ".venv/bin/python";
    server_ = std::make_unique<Started>(
        std::vector<std::string>{std::filesystem::exists(ours, ignored) ? ours.string() : "python3",
                                 (root / "tests/support/mock_http_server.py").string(),
                                 (scratch_.path() / "script.json").string(),
                                 (scratch_.path() / "log").string(),
                                 (scratch_.path() / "port").string()});
    for (int i = 0; i < 1200 && port_.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      port_ = contents_of(scratch_.path() / "port");
    }
    EXPECT_FALSE(port_.empty()) << "the mock server does not start: " << server_->errors_so_far();
  }
  ~MockServer() { stop(); }
  MockServer(const MockServer&) = delete;
  MockServer& operator=(const MockServer&) = delete;

  void stop() {
    if (server_ == nullptr) return;
    server_->interrupt();
    server_->wait();
    server_.reset();
  }

  std::string url(const std::string& path = "", const std::string& host = "127.0.0.1") const {
    return "http://" + host + ":" + port_ + path;
  }

  // What was asked so far: method, path, headers, body, time (seconds).
  std::vector<nlohmann::json> requests() const {
    std::vector<nlohmann::json> list;
    std::istringstream lines(contents_of(scratch_.path() / "log"));
    for (std::string line; std::getline(lines, line);)
      list.push_back(nlohmann::json::parse(line));
    return list;
  }

 private:
  ScratchFolder scratch_;
  std::unique_ptr<Started> server_;
  std::string port_;
};

// The text of every file in a folder, one after the other.
inline std::string all_text_in(const std::filesystem::path& folder) {
  std::string all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) all += contents_of(entry.path());
  }
  return all;
}

}  // namespace marketgen
