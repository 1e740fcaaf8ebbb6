// What an HTTP client asks and what it is answered, whatever library carries it.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace marketgen::web {

struct HttpAsk {
  std::string method;                          // "GET"
  std::string path;                            // decoded, begins with '/'; no query
  std::map<std::string, std::string> query;    // decoded; of a name given twice the last
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;                            // of POST
  std::string_view header(const std::string& name) const;  // empty when there is none
};

// Bytes that several answers may share.
struct HttpBody {
  std::string type;  // content type
  std::string bytes;
  bool packed = false;  // bytes are gzip's; who cannot read that gets them unpacked
  std::string etag;     // with its quotes
};

struct HttpReply {
  int status = 200;
  std::shared_ptr<const HttpBody> body;
  bool lasting = false;  // the same for ever under this path: may be kept without asking again
  int retry_after_s = 0;
};

// Texts and tables are packed when they are larger than a packet; pictures are packed already.
std::shared_ptr<const HttpBody> make_body(std::string type, std::string bytes);
// Of bytes that make_body() has packed, or left as they were, before.
std::shared_ptr<const HttpBody> made_body(std::string type, std::string bytes);
HttpReply json_reply(const std::string& json);
// {"error": {"code", "where", "message"}}
HttpReply error_reply(int status, const Error& error);
// The status that belongs to an error's code: 404 server.not_found, 409 server.edit_taken and
// server.drive_taken, 400 for other server.*, input.* and json.* codes, 500 for everything else.
int status_of(const Error& error);

// "%20" and '+' as blanks. Nothing when a '%' is not followed by two hex digits, or for a NUL.
std::optional<std::string> decoded(std::string_view text, bool plus_is_blank);
// "a=1&b=2". Error: server.bad_request.
Result<std::map<std::string, std::string>> query_of(std::string_view text);
// Decodes a path and refuses what no address of ours has: "..", "//", a backslash, control
// characters, bytes that are not UTF-8, more than 1,000 bytes. Error: server.bad_request.
Result<std::string> path_of(std::string_view uri);
// Its parts between the slashes.
std::vector<std::string> parts_of(std::string_view path);

}  // namespace marketgen::web
