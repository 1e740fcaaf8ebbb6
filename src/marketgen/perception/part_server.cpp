#include "perception/part_server.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "base/progress.h"

namespace marketgen::perception {
namespace {

// Where an URL is a host alone, the path that such servers are published with.
std::string with_path(const std::string& url, const std::string& path) {
  const std::size_t host = url.find("://");
  const std::size_t end = url.find_first_of("/?#", host == std::string::npos ? 0 : host + 3);
  const bool bare = end == std::string::npos || url.substr(end) == "/";
  return bare ? url.substr(0, end) + path : url;
}

}  // namespace

PartServer::PartServer(const std::string& url,
                       const std::string& path,
                       std::shared_ptr<const net::HttpClient> client)
    : url_(with_path(url, path)), client_(std::move(client)) {
  use_.url = url;
}

bool PartServer::ask(Question question,
                     const std::function<Result<void>(const std::string& answer)>& read) {
  if (failed_in_a_row_ >= max_part_failures) {
    ++use_.skipped, ++use_.offline;
    return false;
  }
  ++use_.questions;
  const Result<void> answered = put(std::move(question), read);
  if (answered.ok()) {
    ++use_.answered;
    failed_in_a_row_ = 0;
    return true;
  }
  log_debug(to_string(answered.error()));
  ++failed_in_a_row_, ++use_.offline;
  return false;
}

Result<void> PartServer::put(Question question,
                             const std::function<Result<void>(const std::string& answer)>& read) {
  net::HttpRequest request;
  request.method = "POST";
  request.url = url_;
  request.headers = {{"Content-Type", std::move(question.content_type)}};
  request.body = std::move(question.body);
  const auto answer = client_->send(request);
  if (!answer.ok()) {
    // Of this machine, not of the server: a record that cannot be written.
    if (answer.error().code.starts_with("io.")) log_warning(to_string(answer.error()));
    ++(answer.error().code == "net.timeout"     ? use_.timed_out
       : answer.error().code == "net.too_large" ? use_.bad_answer
                                                : use_.unreachable);
    return answer.error();
  }
  if (answer->status / 100 != 2) {
    ++use_.refused;
    return Error{"perception.part_refused", url_, fmt::format("status {}", answer->status)};
  }
  auto used = read(answer->body);
  if (!used.ok()) ++use_.bad_answer;
  return used;
}

PartServer::Question form_with_png(const std::string& png,
                                   const std::string& field,
                                   const std::string& value) {
  // Stands in the picture with the chance of a hash's collision.
  const std::string line = "marketgen-" + Hasher().add(png).hex();
  return {"multipart/form-data; boundary=" + line,
          fmt::format("--{0}\r\nContent-Disposition: form-data; name=\"{1}\"\r\n\r\n{2}\r\n"
                      "--{0}\r\nContent-Disposition: form-data; name=\"image\"; "
                      "filename=\"image.png\"\r\nContent-Type: image/png\r\n\r\n{3}\r\n--{0}--\r\n",
                      line,
                      field,
                      value,
                      png)};
}

}  // namespace marketgen::perception
