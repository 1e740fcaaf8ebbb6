// A part of the manipulation system that runs in a server of its own: a segmentation network, a
// grasp network. Asked over HTTP, within limits; what fails is counted and never an error of the
// caller's, whose own part then stands in.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "agent/part_use.h"
#include "net/http.h"

namespace marketgen::perception {

constexpr int max_part_failures = 3;  // in a row; then it is not asked any more

// One thread's.
class PartServer {
 public:
  // `url` as the user gave it, to which `path` is added where it names a host alone.
  PartServer(const std::string& url,
             const std::string& path,
             std::shared_ptr<const net::HttpClient> client);

  struct Question {
    std::string content_type, body;
  };
  // Whether it answered and `read` could use what it said. Every false is a time that the program's
  // own part stands in.
  bool ask(Question question, const std::function<Result<void>(const std::string& answer)>& read);

  const agent::PartUse& use() const { return use_; }

 private:
  Result<void> put(Question question,
                   const std::function<Result<void>(const std::string& answer)>& read);

  std::string url_;
  std::shared_ptr<const net::HttpClient> client_;
  agent::PartUse use_;
  int failed_in_a_row_ = 0;
};

// One file of a form, as browsers and `requests.post(files=)` send it (RFC 7578), with a text field
// beside it.
PartServer::Question form_with_png(const std::string& png,
                                   const std::string& field,
                                   const std::string& value);

}  // namespace marketgen::perception
