// A client that sends whatever bytes it is given.
#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <map>
#include <string>
#include <string_view>

#include "base/text.h"

namespace marketgen {

struct RawAnswer {
  int status = 0;  // 0: none
  std::map<std::string, std::string> headers;
  std::string body;
};

class RawClient {
 public:
  explicit RawClient(int port, int timeout_s = 20) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval limit{timeout_s, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  }
  ~RawClient() { close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool connected() const { return connected_; }
  void send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }
  // The head of an answer.
  RawAnswer head() {
    std::size_t end = 0;
    while ((end = kept_.find("\r\n\r\n")) == std::string::npos) {
      if (!more()) return {};
    }
    RawAnswer answer = head_of(kept_.substr(0, end));
    kept_.erase(0, end + 4);
    return answer;
  }
  // One answer; `has_body` is false for HEAD.
  RawAnswer answer(bool has_body = true) {
    RawAnswer answer = head();
    const std::string length = answer.headers["content-length"];
    const std::size_t wanted = has_body && !length.empty() ? std::stoul(length) : 0;
    while (kept_.size() < wanted && more()) {
    }
    answer.body = kept_.substr(0, wanted);
    kept_.erase(0, wanted);
    return answer;
  }
  // What has come, so many bytes at most; none: the server has closed, or is silent.
  std::string read(std::size_t bytes) {
    if (kept_.empty()) more();
    const std::string piece = kept_.substr(0, bytes);
    kept_.erase(0, piece.size());
    return piece;
  }
  // Reads a little, for clients that are slow.
  std::size_t sip(std::size_t bytes) const {
    std::string piece(bytes, '\0');
    return static_cast<std::size_t>(std::max<ssize_t>(0, recv(socket_, piece.data(), bytes, 0)));
  }

 private:
  bool more() {
    char piece[1 << 16];
    const ssize_t got = recv(socket_, piece, sizeof piece, 0);
    if (got <= 0) return false;
    kept_.append(piece, static_cast<std::size_t>(got));
    return true;
  }
  static RawAnswer head_of(const std::string& head) {
    RawAnswer answer;
    if (head.starts_with("HTTP/1.1 ")) answer.status = std::stoi(head.substr(9, 3));
    for (std::size_t at = head.find("\r\n"); at != std::string::npos;
         at = head.find("\r\n", at + 2)) {
      const std::string line = head.substr(at + 2, head.find("\r\n", at + 2) - at - 2);
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos)
        answer.headers[lower_ascii(line.substr(0, colon))] = line.substr(colon + 2);
    }
    return answer;
  }

  int socket_;
  bool connected_ = false;
  std::string kept_;
};

inline std::string get_request(const std::string& path, int port, const std::string& more = "") {
  return "GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + more +
         "\r\n";
}
inline RawAnswer get(int port, const std::string& path, const std::string& more = "") {
  RawClient client(port);
  client.send(get_request(path, port, more));
  return client.answer();
}

}  // namespace marketgen
